#include "widgets/controls/quantity_edit.h"

#include "control/base/assert.h"
#include "widgets/language/display_units.h"
#include "widgets/language/number_text.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolTip>

#include <cmath>

namespace halbench::widgets {

QuantityEdit::QuantityEdit(QWidget* parent) : QDoubleSpinBox(parent) {
    setKeyboardTracking(false); // a half-typed number is not a value
    setAlignment(Qt::AlignRight);
    setAccelerated(true);
    setFormat({});
    connect(this, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
        showProblem({});
        Q_EMIT edited(value);
    });
    connect(lineEdit(), &QLineEdit::textChanged, this, &QuantityEdit::judgeTyped);
}

void QuantityEdit::setFormat(const QuantityFormat& format) {
    const QSignalBlocker blocker(this);
    m_format = format;
    setDecimals(format.decimals);
    setRange(format.min, format.max);
    setSingleStep(format.step);
    setSuffix(format.unit.isEmpty() ? QString() : QChar(QChar::Nbsp) + format.unit);
    describe();
}

void QuantityEdit::setQuantity(double value) {
    HB_ASSERT(std::isfinite(value));
    const QSignalBlocker blocker(this);
    setValue(value);
}

/// Whatever is typed stays to be seen; what is no number inside the limits is refused in words.
QValidator::State QuantityEdit::validate(QString& text, int&) const {
    return problemOf(text).isEmpty() ? QValidator::Acceptable : QValidator::Intermediate;
}

/// The base class would leave out what separates thousands, and a text that was refused would become a number
/// ten or a thousand times another one.
void QuantityEdit::fixup(QString&) const {}

/// The base class keeps the unit at the end of the text; in front of it the user may have typed it again.
QString QuantityEdit::typedOf(const QString& text) const {
    return text.endsWith(suffix()) ? text.left(text.size() - suffix().size()) : text;
}

bool QuantityEdit::isWordForLeast(const QString& text) const {
    return !specialValueText().isEmpty() && text == specialValueText();
}

QString QuantityEdit::problemOf(const QString& text) const {
    if (isWordForLeast(text)) {
        return {};
    }
    const QString typed = typedOf(text);
    if (const auto value = parseNumber(typed, m_format.unit)) {
        return *value >= minimum() && *value <= maximum() ? QString() : allowedText();
    }
    return numberProblem(typed, m_format.unit) + QLatin1Char(' ') + allowedText();
}

double QuantityEdit::valueFromText(const QString& text) const {
    return isWordForLeast(text) ? minimum() : parseNumber(typedOf(text), m_format.unit).value_or(value());
}

QString QuantityEdit::textFromValue(double value) const {
    return fixedText(value, decimals());
}

QString QuantityEdit::rangeText() const {
    return tr("%1 to %2 %3").arg(textFromValue(minimum()), textFromValue(maximum()), m_format.unit).trimmed();
}

void QuantityEdit::describe() {
    setToolTip(tr("Allowed: %1 (arrow keys: one step, Page Up and Page Down: ten)").arg(rangeText()));
    setAccessibleDescription(rangeText());
}

/// More digits only lead farther away.
bool QuantityEdit::isTooFar(const QString& typed) const {
    const auto value = parseNumber(typed, m_format.unit);
    return value && ((*value > 0.0 && *value > maximum()) || (*value < 0.0 && *value < minimum()));
}

/// A number that is half typed is none yet; what cannot become one is said while it is typed.
void QuantityEdit::judgeTyped(const QString& text) {
    const QString typed = typedOf(text);
    const bool isWrong =
        !isWordForLeast(text) && (!typingProblem(typed, m_format.unit).isEmpty() || isTooFar(typed));
    showProblem(lineEdit()->hasFocus() && isWrong ? problemOf(text) : QString());
}

void QuantityEdit::showProblem(const QString& problem) {
    if (problem == m_problem) {
        return;
    }
    m_problem = problem;
    setRole(*this, problem.isEmpty() ? Role::None : Role::Bad);
    setAccessibleDescription(problem.isEmpty() ? rangeText() : problem);
    sayAt(*this, problem);
}

QString QuantityEdit::allowedText() const {
    return tr("Allowed: %1.").arg(rangeText());
}

/// What is wrong goes before what the field is for.
bool QuantityEdit::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && !m_problem.isEmpty()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), bubbleOf(m_problem), this);
        return true;
    }
    return QDoubleSpinBox::event(event);
}

/// The base class would fall back to the number before and then say that Enter was pressed.
void QuantityEdit::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && !hasAcceptableInput()) {
        event->accept();
        showProblem(problemOf(lineEdit()->text()));
        Q_EMIT refused(lineEdit()->text());
        selectAll();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
    if (isEnter) {
        Q_EMIT entered();
    }
}

void QuantityEdit::stepBy(int steps) {
    QDoubleSpinBox::stepBy(steps);
    showProblem({}); // whatever was typed is a number again
}

void QuantityEdit::focusOutEvent(QFocusEvent* event) {
    const QString text = lineEdit()->text();
    const bool isRefused = !hasAcceptableInput();
    QDoubleSpinBox::focusOutEvent(event);
    showProblem({}); // it shows the number before
    if (isRefused) {
        Q_EMIT refused(text);
    }
}

void QuantityEdit::changeEvent(QEvent* event) {
    QDoubleSpinBox::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
        describe();
    }
}

} // namespace halbench::widgets
