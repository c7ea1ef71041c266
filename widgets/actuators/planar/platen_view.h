#pragma once

#include "widgets/actuators/actuator_view.h"
#include "widgets/actuators/planar/lattice_map.h"
#include "widgets/actuators/planar/platen_drawing.h"
#include "widgets/actuators/planar/platen_state.h"

#include <QFontMetricsF>
#include <QPointF>
#include <QRectF>

#include <Eigen/Core>
#include <optional>
#include <vector>

class QAction;

namespace halbench::widgets {

/// Parts of the picture's rectangle; the table is empty where there is no room for it.
struct PlatenLayout {
    QRectF map;
    QRectF inset;
    QRectF table;
    QRectF key; ///< where the meaning of lines and arrows may stand
};
PlatenLayout platenLayout(const QSizeF& size, const QFontMetricsF& metrics);

/// The platen over the magnet matrix from above: field in the coil plane, blocks, coils inked by current,
/// forces, chips with their fields and residuals, reference, path, window and pitch cell, with the numbers
/// beside it and the error a thousand times as large in an inset. Wheel, + and - zoom about the middle or the
/// pointer, dragging and the arrow keys move the map, Home shows all of it.
/// Source: resources/help/planar-theory.md sections 2 to 7.
class PlatenView final : public ActuatorPicture {
    Q_OBJECT
public:
    explicit PlatenView(QWidget* parent = nullptr);

    void showSettings(const ActuatorValues& values) override;
    void showSamples(const ActuatorValues& values) override;
    void setStale(bool isStale) override;
    void clear() override;
    Drawing drawing() const override;

    void clearPath();
    /// The whole magnet matrix.
    void fit();
    /// Magnifies about a place of the picture in logical pixels.
    void zoom(double factor, const QPointF& about_px);
    void setFollowing(bool isFollowing);

    MapScale scale(const QRectF& map) const;
    const PlatenReadings& readings() const { return m_readings; }
    std::optional<PlatenReach> reach() const;

    QSize sizeHint() const override { return {760, 520}; }
    QSize minimumSizeHint() const override { return {240, 240}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addCommands();
    void keep(const PlatenReadings& before);
    void move(const QPointF& step_px);
    void draw(QPainter& painter, const Theme& theme, const QSizeF& size, LatticeMap& lattice) const;
    void drawMap(QPainter& painter, const Theme& theme, const QRectF& map, LatticeMap& lattice) const;
    void drawState(QPainter& painter, const Theme& theme, const QRectF& map) const;
    void describe();

    PlatenSettings m_settings;
    PlatenReadings m_readings;
    std::optional<models::PlanarPose> m_origin; ///< where the mode began
    std::vector<Eigen::Vector2d> m_path_m;      ///< oldest first
    std::vector<Eigen::Vector3d> m_errors;      ///< of the latest frames
    LatticeMap m_lattice;
    Eigen::Vector2d m_middle_m = Eigen::Vector2d::Zero();
    double m_zoom = 1.0; ///< 1: the whole magnet matrix
    bool m_isFollowing = false;
    bool m_isStale = false;
    QPointF m_dragged;
    QAction* m_follow = nullptr;
};

ActuatorView platenActuatorView();

} // namespace halbench::widgets
