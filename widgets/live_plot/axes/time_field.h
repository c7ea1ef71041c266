#pragma once

#include <QDoubleSpinBox>

#include <optional>

namespace halbench::widgets {

/// A moment in seconds. It keeps its value to the last bit and shows as many decimals as are asked for; a
/// moment that was typed shows all that were typed.
class TimeField : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit TimeField(QWidget* parent = nullptr);

    /// Shown from now on; the arrows of the field move by `step_s`.
    void setShown(int decimals, double step_s);
    int shownDecimals() const { return m_decimals; }

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;

private:
    int m_decimals = 4;
    mutable std::optional<double> m_typed; ///< what was typed last
    mutable int m_typedDecimals = 0;
};

} // namespace halbench::widgets
