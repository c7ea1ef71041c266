#include "widgets/quantity_edit.h"

#include "control/base/assert.h"
#include "widgets/display_units.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>

#include <cmath>

namespace halbench::widgets {

QuantityEdit::QuantityEdit(QWidget* parent) : QDoubleSpinBox(parent) {
    setKeyboardTracking(false); // a half-typed number is not a value
    setAlignment(Qt::AlignRight);
    setAccelerated(true);
    setFormat({});
    connect(this, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &QuantityEdit::edited);
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

QValidator::State QuantityEdit::validate(QString& text, int&) const {
    const auto value = parseNumber(text, m_format.unit);
    if (value) {
        return *value >= minimum() && *value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
    }
    QString number = text;
    number.remove(m_format.unit);
    for (const QChar letter : number) {
        const bool isOfANumber =
            letter.isDigit() || letter.isSpace() || QStringLiteral("+-−.,eE").contains(letter);
        if (!isOfANumber) {
            return QValidator::Invalid; // "nan" and "inf" cannot even be typed
        }
    }
    return QValidator::Intermediate;
}

double QuantityEdit::valueFromText(const QString& text) const {
    return parseNumber(text, m_format.unit).value_or(value());
}

QString QuantityEdit::textFromValue(double value) const {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'f', decimals());
}

QString QuantityEdit::rangeText() const {
    return tr("%1 to %2 %3").arg(textFromValue(minimum()), textFromValue(maximum()), m_format.unit).trimmed();
}

void QuantityEdit::describe() {
    setToolTip(tr("Allowed: %1 (arrow keys: one step, Page Up and Page Down: ten)").arg(rangeText()));
    setAccessibleDescription(rangeText());
}

/// The base class would fall back to the number before and then say that Enter was pressed.
void QuantityEdit::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && !hasAcceptableInput()) {
        event->accept();
        Q_EMIT refused(lineEdit()->text());
        selectAll();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
    if (isEnter) {
        Q_EMIT entered();
    }
}

void QuantityEdit::focusOutEvent(QFocusEvent* event) {
    const QString text = lineEdit()->text();
    const bool isRefused = !hasAcceptableInput();
    QDoubleSpinBox::focusOutEvent(event);
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
