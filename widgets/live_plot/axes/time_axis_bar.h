#pragma once

#include "control/history/sample_history.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace halbench::widgets {

class ValueScaleDraw;

/// The time axis below a stack of plots, aligned with their canvases, with the view's state beside its title.
/// The wheel zooms the time about the moment under the mouse, a left drag scrolls it.
class TimeAxisBar : public QWidget {
    Q_OBJECT
public:
    explicit TimeAxisBar(QWidget* parent = nullptr);
    ~TimeAxisBar() override;

    void setTheme(const Theme& theme);
    /// The canvases' left edge and width in this widget's coordinates.
    void setCanvas(int left, int width);
    /// `origin_s`: the moment from which it counts.
    void setRange(control::TimeRange range, double step_s, std::optional<double> origin_s = {});
    void setState(const QString& state, bool isWarning);
    const QString& state() const { return m_state; }
    /// What of the state there is room for. Beside a narrow canvas the title gives way, to below the legend.
    QString shownState() const;

Q_SIGNALS:
    void zoomRequested(double factor, double at_s);
    void panRequested(double by_s);
    void fitRequested(); ///< by a double click

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    QString title() const;
    int titleLeft() const;
    double timeAt(double x_px) const;

    std::unique_ptr<ValueScaleDraw> m_scale;
    Theme m_theme;
    control::TimeRange m_range{0.0, 1.0};
    std::optional<double> m_last_px; ///< where a drag was last; none: no drag
    int m_left = 0;
    int m_width = 100;
    QString m_state;
    bool m_isWarning = false;
    bool m_isFromEvent = false;
};

} // namespace halbench::widgets
