#pragma once

#include <QPointF>
#include <QWidget>

#include <array>
#include <optional>

namespace halbench::widgets {

/// Readings of the two Hall sensors over a turn of the rotor, one against the other with a scale in mT: a
/// circle about the middle where both are right. Kept is the newest reading at each of 180 angles.
class HallTraceView : public QWidget {
    Q_OBJECT
public:
    explicit HallTraceView(QWidget* parent = nullptr);

    void add(double angle_rad, double hall_a_T, double hall_b_T); ///< left out unless all are finite
    void setStale(bool isStale);                                  ///< the reading is the last one known
    void clear();

    int angles() const; ///< at how many of the 180 there is a reading
    /// Outermost circle of the scale: holds all readings.
    double fullScale_T() const;

    QSize sizeHint() const override { return {320, 420}; }
    QSize minimumSizeHint() const override { return {200, 200}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void drawScale(QPainter& painter, double pixels_per_T) const;
    void drawReadings(QPainter& painter, double pixels_per_T) const;
    void drawTitles(QPainter& painter, double pixels_per_T) const;
    void describe();

    std::array<std::optional<QPointF>, 180> m_readings_T; ///< x Hall A, y Hall B
    std::optional<QPointF> m_newest_T;
    double m_largest_T = 0.0;
    bool m_isStale = false;
};

} // namespace halbench::widgets
