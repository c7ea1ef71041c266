#include "app/wizards/relay_form.h"

#include "widgets/controls/optional_number_edit.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <cmath>

namespace halbench::app {

RelayForm::RelayForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this)) {
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setSpacing(widgets::GridStep_px);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addRow(Base, QStringLiteral("rad/s"));
    addRow(Current, QStringLiteral("A"));
    addRow(Cycles, {});
    m_edits[Base]->setLimits({-1e4, 1e4, true});
    m_edits[Current]->setLimits({0.01, 1000.0, true});
    m_edits[Cycles]->setLimits({40.0, 400.0, true});
    refreshWords();
}

void RelayForm::addRow(Field field, const QString& unit) {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(widgets::PanelMargin_px);
    auto* edit = new widgets::OptionalNumberEdit(row);
    auto* behind = new QLabel(unit, row);
    widgets::setRole(*behind, widgets::Role::Muted);
    behind->setMinimumWidth(behind->fontMetrics().horizontalAdvance(QStringLiteral("rad/s ")));
    layout->addWidget(edit, 1);
    layout->addWidget(behind);
    auto* label = new QLabel(this);
    label->setBuddy(edit);
    m_form->addRow(label, row);
    m_edits[field] = edit;
    m_labels[field] = label;
    connect(edit, &widgets::OptionalNumberEdit::valueChanged, this, &RelayForm::changed);
}

void RelayForm::refreshWords() {
    const QString names[] = {tr("&Base speed"), tr("Relay amplitude"), tr("Cycles")};
    const QString helps[] = {
        tr("Steady speed of the oscillation, at least 3 rad/s in either direction, so that friction acts as "
           "a constant offset. Empty: lowest safe value"),
        tr("Saturation current of the controller. Empty: maximum safe value"),
        tr("Cycles to measure, 40 to 400; the intervals shrink with the square root. Empty: 100")};
    const QString empty[] = {tr("safe value"), tr("safe value"), QStringLiteral("100")};
    for (std::size_t i = 0; i < m_edits.size(); ++i) {
        m_labels[i]->setText(names[i]);
        m_edits[i]->setAccessibleName(QString(names[i]).remove(QLatin1Char('&')));
        m_edits[i]->setAccessibleDescription(helps[i]);
        m_edits[i]->setExplanation(helps[i]);
        m_edits[i]->setPlaceholderText(empty[i]);
    }
}

Result<RelayConfig> RelayForm::config() const {
    for (const widgets::OptionalNumberEdit* edit : m_edits) {
        if (!edit->isValid()) {
            return failure(ErrorCode::InvalidInput,
                           tr("%1: %2").arg(edit->accessibleName(), edit->problem()).toStdString(),
                           tr("Correct it or leave it empty").toStdString());
        }
    }
    RelayConfig config;
    config.base_rad_s = m_edits[Base]->value();
    config.limit_A = m_edits[Current]->value();
    config.cycles = static_cast<int>(std::lround(m_edits[Cycles]->value().value_or(config.cycles)));
    return config;
}

void RelayForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
