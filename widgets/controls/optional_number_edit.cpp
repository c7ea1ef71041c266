#include "widgets/controls/optional_number_edit.h"

#include "widgets/language/display_units.h"
#include "widgets/language/number_text.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>

namespace halbench::widgets {

OptionalNumberEdit::OptionalNumberEdit(QWidget* parent) : QLineEdit(parent) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(this, &QLineEdit::textEdited, this, [this] {
        read();
        sayAt(*this, typingProblem(text()));
        Q_EMIT valueChanged();
    });
}

void OptionalNumberEdit::setLimits(const NumberLimits& limits) {
    m_limits = limits;
    read();
}

void OptionalNumberEdit::setValue(std::optional<double> value) {
    m_exact = value;
    m_exactText = value ? settingText(*value) : QString();
    setText(m_exactText);
    read();
}

void OptionalNumberEdit::setExplanation(const QString& text) {
    m_explanation = text;
    refreshWords();
}

void OptionalNumberEdit::read() {
    m_value.reset();
    m_problem.clear();
    if (!text().trimmed().isEmpty()) {
        // What was set has more digits than it shows; as long as its text stands it keeps them.
        const auto number = m_exact && text() == m_exactText ? m_exact : parseNumber(text());
        if (!number) {
            m_problem = numberProblem(text());
        } else if (*number < m_limits.min || (*number == m_limits.min && !m_limits.isMinAllowed)) {
            m_problem = m_limits.isMinAllowed ? tr("At least %1").arg(numberText(m_limits.min, 7))
                                              : tr("More than %1").arg(numberText(m_limits.min, 7));
        } else if (*number > m_limits.max) {
            m_problem = tr("At most %1").arg(numberText(m_limits.max, 7));
        } else {
            m_value = number;
        }
    }
    refreshWords();
}

void OptionalNumberEdit::refreshWords() {
    const Role role = m_problem.isEmpty() ? Role::None : Role::Bad;
    if (roleOf(*this) != role) {
        setRole(*this, role);
    }
    setToolTip(m_problem.isEmpty() ? m_explanation : m_problem);
    setAccessibleDescription(toolTip());
}

void OptionalNumberEdit::changeEvent(QEvent* event) {
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        read();
    }
}

} // namespace halbench::widgets
