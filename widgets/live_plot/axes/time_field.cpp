#include "widgets/live_plot/axes/time_field.h"

#include "widgets/language/display_units.h"
#include "widgets/language/time_decimals.h"

#include <QSignalBlocker>

#include <algorithm>

namespace halbench::widgets {
namespace {

constexpr double Farthest_s = 1e7;
/// What the field keeps: at 1e7 s a double has no more.
constexpr int KeptDecimals = 12;
constexpr int WholeCharacters = 7; ///< "-1234." and the unit's blank
constexpr int UnitCharacters = 1;
constexpr int StepButtons_px = 32; ///< and the margins

} // namespace

TimeField::TimeField(QWidget* parent) : QDoubleSpinBox(parent) {
    setRange(-Farthest_s, Farthest_s);
    setDecimals(KeptDecimals);
    setSuffix(QStringLiteral(" s"));
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
    constexpr double Step_s = 0.01;
    setShown(m_decimals, Step_s);
}

void TimeField::setShown(int decimals, double step_s) {
    setSingleStep(step_s);
    const int characters = WholeCharacters + UnitCharacters + decimals;
    setFixedWidth(characters * fontMetrics().averageCharWidth() + StepButtons_px);
    if (decimals != m_decimals) {
        m_decimals = decimals;
        if (!hasFocus()) { // else it is being typed
            const QSignalBlocker quiet(this);
            setSpecialValueText({}); // writes the value anew
        }
    }
}

QString TimeField::textFromValue(double value) const {
    const bool isTyped = m_typed && *m_typed == value;
    return fixedText(value, std::max(m_decimals, isTyped ? m_typedDecimals : 0));
}

/// What is shown of the value is the value: leaving the field must not round it.
double TimeField::valueFromText(const QString& text) const {
    QString number = text;
    if (number.endsWith(suffix())) {
        number.chop(suffix().size());
    }
    if (number.trimmed() == textFromValue(value())) {
        return value();
    }
    const double typed = QDoubleSpinBox::valueFromText(text);
    m_typed = typed;
    m_typedDecimals = std::min(typedDecimals(number), KeptDecimals);
    return typed;
}

} // namespace halbench::widgets
