#pragma once

#include "app/workbench/display_quantity.h"
#include "app/workspaces/drive/axis_ranges.h"

#include <QPushButton>
#include <QWidget>

#include <optional>

class QLabel;

namespace halbench::widgets {
class QuantityEdit;
}

namespace halbench::app {

class NumberCheck;

/// A button that acts while it is held and only then: letting go, losing the focus, being hidden or disabled,
/// and a window that goes to the background all end it.
class HoldButton : public QPushButton {
    Q_OBJECT

public:
    explicit HoldButton(const QString& text, QWidget* parent = nullptr);

Q_SIGNALS:
    void held();
    void letGo();

protected:
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void begin();
    void end();

    bool m_isHeld = false;
};

/// Backward and forward while a button is held, at a chosen speed or current.
class JogRow : public QWidget {
    Q_OBJECT

public:
    explicit JogRow(QWidget* parent = nullptr);

    /// Of the axis in position mode, else ampere.
    void setQuantity(bool isSpeed, const devices::AxisSpec& axis);
    void setUnits(const DisplayUnits& units);
    /// That is shown, in the unit of the axis a second.
    double speed() const;

Q_SIGNALS:
    void jogStarted(double rate); ///< in the unit of the axis a second, or A
    void jogStopped();
    void refused(const QString& text, const QString& remedy); ///< the rate cannot be used

private:
    HoldButton* addButton(const QString& text, const QString& toolTip, double sign);
    void start(double sign);
    void dress();
    DisplayQuantity shownSpeed() const;
    double firstSpeed() const;

    DisplayUnits m_units;
    std::optional<bool> m_isSpeed;
    devices::AxisSpec m_axis;
    widgets::QuantityEdit* m_rate = nullptr;
    NumberCheck* m_check = nullptr; ///< of the rate
};

} // namespace halbench::app
