#pragma once

#include "widgets/live_plot/axes/value_range.h"

#include <QObject>

#include <optional>

class QMouseEvent;
class QWheelEvent;

namespace halbench::widgets {

class LivePlot;

/// The mouse on one axis of values of a plot: the wheel zooms this axis about the value under the mouse, a
/// left drag moves it, a double click lets it follow its data again. The other axis stays as it is. Owned by
/// its plot. Thread: GUI.
class AxisMouse : public QObject {
    Q_OBJECT
public:
    AxisMouse(LivePlot& plot, bool isRight);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void wheel(const QWheelEvent& event);
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void followData();
    double valueAt(int y_px) const;
    void hold(const ValueRange& range);

    LivePlot& m_plot;
    bool m_isRight;
    std::optional<int> m_last_px; ///< where the drag was last, on the axis; none: no drag
    bool m_isMoved = false;       ///< in this drag; a click changes nothing
};

} // namespace halbench::widgets
