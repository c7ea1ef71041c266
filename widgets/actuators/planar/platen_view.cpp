#include "widgets/actuators/planar/platen_view.h"

#include "control/base/units.h"
#include "widgets/actuators/planar/platen_table.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::widgets {

namespace {

constexpr double Border = 1.04; ///< of the magnet matrix when all of it is shown
constexpr double GreatestZoom = 200.0;
constexpr double ZoomStep = 1.25;
constexpr double KeyStep_px = 40.0;
constexpr double PathStep_m = 2e-6; ///< between two places that are kept
constexpr std::size_t LongestPath = 6000;
constexpr std::size_t KeptErrors = 150; ///< five seconds of frames
constexpr double MapToTable = 1.3;      ///< a table needs a map that is so many times as wide beside it

} // namespace

PlatenLayout platenLayout(const QSizeF& size, const QFontMetricsF& metrics) {
    PlatenLayout layout;
    const double table_px = platenTableWidth_px(metrics);
    const bool hasTable = size.width() >= (1.0 + MapToTable) * table_px;
    // A low picture has room for two columns beside its square map.
    const bool isLow = size.height() < platenTableHeight_px(metrics);
    const int columns = !hasTable ? 0 : isLow && size.width() - 2.0 * table_px >= size.height() ? 2 : 1;
    layout.map = QRectF(0.0, 0.0, size.width() - columns * table_px, size.height());
    if (hasTable) {
        layout.table = QRectF(layout.map.right(), 0.0, columns * table_px, size.height());
    }
    // Below the second column, else at the border of a map that is wide enough.
    layout.key = columns == 2 ? QRectF(size.width() - table_px, 0.55 * size.height(),
                                       table_px - PanelMargin_px, 0.45 * size.height())
                              : QRectF(layout.map.right() - PanelMargin_px - 0.22 * layout.map.width(),
                                       layout.map.top() + PanelMargin_px, 0.22 * layout.map.width(),
                                       0.5 * layout.map.height());
    const double side = std::clamp(0.3 * std::min(layout.map.width(), layout.map.height()), 90.0, 240.0);
    layout.inset = QRectF(layout.map.right() - side - PanelMargin_px,
                          layout.map.bottom() - side - PanelMargin_px, side, side);
    return layout;
}

PlatenView::PlatenView(QWidget* parent) : ActuatorPicture(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
    m_settings = platenSettings({[](const std::string&) { return std::optional<double>(); },
                                 [](const std::string&) { return std::optional<double>(); }});
    addCommands();
    describe();
}

void PlatenView::addCommands() {
    const auto add = [this](const QString& text, const QString& toolTip) {
        auto* action = new QAction(text, this);
        action->setToolTip(toolTip);
        addAction(action);
        return action;
    };
    QAction* all = add(tr("Sho&w all"), tr("Show the whole magnet matrix (Alt+W, Home)"));
    connect(all, &QAction::triggered, this, &PlatenView::fit);
    m_follow = add(tr("F&ollow"), tr("Keep the platen in the middle of the map (Alt+O)"));
    m_follow->setCheckable(true);
    connect(m_follow, &QAction::toggled, this, &PlatenView::setFollowing);
    QAction* forget = add(tr("&Clear path"), tr("Forget the way that the platen went (Alt+C)"));
    connect(forget, &QAction::triggered, this, &PlatenView::clearPath);
}

void PlatenView::showSettings(const ActuatorValues& values) {
    const bool wasPositionMode = m_settings.isPositionMode;
    m_settings = platenSettings(values);
    if (m_settings.isPositionMode != wasPositionMode) {
        m_origin.reset();
    }
    update();
}

void PlatenView::showSamples(const ActuatorValues& values) {
    const PlatenReadings before = m_readings;
    m_readings = platenReadings(values, m_settings);
    keep(before);
    if (m_isFollowing && m_readings.pose) {
        m_middle_m = {m_readings.pose->x_m, m_readings.pose->y_m};
    }
    describe();
    update();
}

/// What later frames show of this one: path, errors, and where the mode began.
void PlatenView::keep(const PlatenReadings& before) {
    if (!m_readings.pose) {
        return;
    }
    const models::PlanarPose& pose = *m_readings.pose;
    if (!m_readings.isArmed) {
        m_origin.reset();
    } else if (!before.isArmed && before.pose) {
        m_origin = before.pose;
    }
    const Eigen::Vector2d place_m(pose.x_m, pose.y_m);
    if (m_path_m.empty() || (m_path_m.back() - place_m).norm() > PathStep_m) {
        if (m_path_m.size() >= LongestPath) { // half at once: rarely
            m_path_m.erase(m_path_m.begin(), m_path_m.begin() + LongestPath / 2);
        }
        m_path_m.push_back(place_m);
    }
    if (!m_readings.reference) {
        m_errors.clear();
        return;
    }
    if (m_errors.size() >= KeptErrors) {
        m_errors.erase(m_errors.begin());
    }
    const models::PlanarPose& reference = *m_readings.reference;
    m_errors.emplace_back(reference.x_m - pose.x_m, reference.y_m - pose.y_m,
                          reference.angle_rad - pose.angle_rad);
}

void PlatenView::setStale(bool isStale) {
    m_isStale = isStale;
    describe();
    update();
}

void PlatenView::clear() {
    m_readings = {};
    m_origin.reset();
    m_errors.clear();
    clearPath();
    describe();
}

void PlatenView::clearPath() {
    m_path_m.clear();
    update();
}

void PlatenView::fit() {
    m_zoom = 1.0;
    m_middle_m.setZero();
    m_follow->setChecked(false);
    update();
}

void PlatenView::setFollowing(bool isFollowing) {
    m_isFollowing = isFollowing;
    if (isFollowing && m_readings.pose) {
        m_middle_m = {m_readings.pose->x_m, m_readings.pose->y_m};
    }
    update();
}

void PlatenView::zoom(double factor, const QPointF& about_px) {
    const QRectF map = platenLayout(size(), QFontMetricsF(tabularFont(font()))).map;
    const Eigen::Vector2d about_m = scale(map).placeOf_m(about_px);
    const double before = m_zoom;
    m_zoom = std::clamp(m_zoom * factor, 1.0, GreatestZoom);
    if (!m_isFollowing) {
        m_middle_m = about_m + (m_middle_m - about_m) * before / m_zoom;
    }
    update();
}

void PlatenView::move(const QPointF& step_px) {
    const double pixels_per_m =
        scale(platenLayout(size(), QFontMetricsF(tabularFont(font()))).map).pixels_per_m;
    const double half_m = 0.5 * MatrixEdge_pitches * m_settings.geometry.matrix.pitch_m;
    m_middle_m += Eigen::Vector2d(-step_px.x(), step_px.y()) / pixels_per_m;
    m_middle_m = m_middle_m.cwiseMax(-half_m).cwiseMin(half_m);
    m_follow->setChecked(false);
    update();
}

MapScale PlatenView::scale(const QRectF& map) const {
    const double edge_m = Border * MatrixEdge_pitches * m_settings.geometry.matrix.pitch_m;
    MapScale result;
    result.pixels_per_m = m_zoom * std::min(map.width(), map.height()) / edge_m;
    result.origin_px = map.center() + result.pixels_per_m * QPointF(-m_middle_m.x(), m_middle_m.y());
    return result;
}

std::optional<PlatenReach> PlatenView::reach() const {
    if (!m_origin || !m_settings.window || !m_readings.pose) {
        return std::nullopt;
    }
    return reachLeft(*m_settings.window, *m_origin, *m_readings.pose);
}

void PlatenView::draw(QPainter& painter, const Theme& theme, const QSizeF& size, LatticeMap& lattice) const {
    painter.setFont(tabularFont(font()));
    const PlatenLayout layout = platenLayout(size, QFontMetricsF(painter.font()));
    painter.setRenderHint(QPainter::Antialiasing);
    drawMap(painter, theme, layout.map, lattice);
    ErrorInset inset;
    inset.recent = m_errors;
    inset.pixels_per_m = scale(layout.map).pixels_per_m;
    if (m_readings.reference && !m_errors.empty()) {
        inset.error = m_errors.back();
    }
    drawErrorInset(painter, theme, layout.inset, inset, m_isStale);
    if (!layout.table.isEmpty()) {
        PlatenNumbers numbers{m_settings, m_readings, {}, reach(), m_isStale};
        if (m_readings.pose && m_readings.current_A) {
            numbers.forces = platenForces(m_settings, *m_readings.pose, *m_readings.current_A);
        }
        drawPlatenTable(painter, theme, layout.table, numbers);
    }
    drawMapKey(painter, theme, layout.key, m_readings);
}

void PlatenView::drawMap(QPainter& painter, const Theme& theme, const QRectF& map,
                         LatticeMap& lattice) const {
    painter.save();
    painter.setClipRect(map);
    const MapScale seen = scale(map);
    const double ratio = painter.device()->devicePixelRatioF();
    painter.drawImage(map.topLeft(),
                      lattice.image(m_settings.geometry, seen, map.size().toSize(), ratio, theme));
    const PlatenDrawing drawing{painter, theme, seen, m_settings, m_isStale};
    if (m_readings.pose) {
        drawing.cell(*m_readings.pose);
        if (m_origin && m_settings.window) {
            drawing.window(*m_origin);
        }
        drawing.platen(m_readings);
        drawing.path(m_path_m);
        if (m_readings.reference) {
            drawing.ghost(*m_readings.reference);
        }
        drawing.chips(m_readings);
        if (m_readings.current_A) {
            drawing.forces(platenForces(m_settings, *m_readings.pose, *m_readings.current_A));
        }
        if (m_readings.truth) {
            drawing.truth(*m_readings.truth);
        }
    }
    drawMapLegend(painter, theme, map, seen, m_settings.geometry);
    drawState(painter, theme, map);
    painter.restore();
}

/// Upper left: what else has to be known of the pose.
void PlatenView::drawState(QPainter& painter, const Theme& theme, const QRectF& map) const {
    QString text = tr("pose not known");
    if (m_readings.pose) {
        const std::array<int, 2> cell = pitchCell(*m_readings.pose, m_settings.geometry.matrix.pitch_m);
        text = tr("Pitch cell %1, %2").arg(cell[0]).arg(cell[1]) + QStringLiteral(" · ") +
               (m_readings.isHomed ? tr("homed") : tr("not homed"));
        text = m_isStale ? text + QStringLiteral(" · ") + tr("old values") : text;
    }
    const QFontMetricsF metrics(painter.font());
    const QRectF box(map.left() + 8.0, map.top() + 8.0, metrics.horizontalAdvance(text) + 12.0,
                     metrics.height() + 6.0);
    QColor ground = theme.panel;
    ground.setAlphaF(0.85);
    painter.fillRect(box, ground);
    painter.setPen(m_readings.pose && !m_readings.isHomed ? theme.warn : theme.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

ActuatorPicture::Drawing PlatenView::drawing() const {
    return [this](QPainter& painter, const Theme& theme, const QSizeF& size) {
        LatticeMap lattice; // in the file's colours
        painter.fillRect(QRectF(QPointF(), size), theme.plotBackground);
        draw(painter, theme, size, lattice);
    };
}

void PlatenView::describe() {
    setAccessibleName(tr("Platen over the magnet matrix"));
    QString words = tr("pose not known");
    if (m_readings.pose) {
        const models::PlanarPose& pose = *m_readings.pose;
        words = tr("platen at x %1 mm, y %2 mm, turned by %3 mrad")
                    .arg(fixedText(1e3 * pose.x_m, 1), fixedText(1e3 * pose.y_m, 1),
                         fixedText(1e3 * pose.angle_rad, 0));
        words = m_isStale ? words + QStringLiteral("; ") + tr("old values") : words;
    }
    if (words != accessibleDescription()) {
        setAccessibleDescription(words);
    }
}

void PlatenView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme theme = currentTheme();
    draw(painter, theme, size(), m_lattice);
    if (hasFocus()) {
        painter.setPen(QPen(theme.accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void PlatenView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        describe();
    }
    update();
}

void PlatenView::mousePressEvent(QMouseEvent* event) {
    m_dragged = event->localPos();
}

void PlatenView::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0) {
        move(event->localPos() - m_dragged);
        m_dragged = event->localPos();
    }
}

void PlatenView::wheelEvent(QWheelEvent* event) {
    zoom(std::pow(ZoomStep, event->angleDelta().y() / 120.0), event->position());
    event->accept();
}

void PlatenView::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = platenLayout(size(), QFontMetricsF(tabularFont(font()))).map.center();
    switch (event->key()) {
    case Qt::Key_Left:
        return move({KeyStep_px, 0.0});
    case Qt::Key_Right:
        return move({-KeyStep_px, 0.0});
    case Qt::Key_Up:
        return move({0.0, KeyStep_px});
    case Qt::Key_Down:
        return move({0.0, -KeyStep_px});
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(ZoomStep, middle);
    case Qt::Key_Minus:
        return zoom(1.0 / ZoomStep, middle);
    case Qt::Key_Home:
        return fit();
    default:
        QWidget::keyPressEvent(event);
    }
}

ActuatorView platenActuatorView() {
    ActuatorView view{"planar",
                      {"position.x", "position.y", "position.phi"},
                      {"reference.x", "reference.y", "reference.phi", "truth.position.x", "truth.position.y",
                       "truth.position.phi", "lift", "chi_square", "current_scale", "chips_left_out", "homed",
                       "status"},
                      [](QWidget* parent) { return new PlatenView(parent); }};
    for (int k = 1; k <= models::CoilCount; ++k) {
        const std::string coil = ".coil" + std::to_string(k);
        view.needed.push_back("current" + coil);
        view.wished.push_back("coil_temperature" + coil);
    }
    for (int j = 1; j <= models::ChipCount; ++j) {
        view.needed.push_back("hall.x" + std::to_string(j));
        view.needed.push_back("hall.y" + std::to_string(j));
    }
    return view;
}

} // namespace halbench::widgets
