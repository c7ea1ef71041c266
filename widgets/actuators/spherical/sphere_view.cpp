#include "widgets/actuators/spherical/sphere_view.h"

#include "control/base/units.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double FirstAzimuth_rad = 0.6;
constexpr double FirstElevation_rad = 0.45;
constexpr double KeyStep_rad = 0.0872664626; ///< 5 degrees
constexpr double DragStep_rad = 0.008;       ///< a pixel
constexpr double RotorRadius_m = 45.6e-3;
constexpr double ShaftLength = 1.35; ///< of the rotor's radius
constexpr double AxisLength = 1.6;
constexpr double FieldScale = 2.2; ///< radii a tesla
constexpr double Reach = 1.72;     ///< radii from the middle to the border
constexpr int Bands = 14;
constexpr int Sectors = 32;
constexpr std::size_t LongestPath = 600;
constexpr double PathStep = 0.01; ///< between two tips that are kept, rad
constexpr int ConeCorners = 48;
constexpr double LeastDot_px = 2.5;
constexpr double MoreDot_px = 4.0;

Eigen::Vector3d onSphere(double theta_rad, double phi_rad) {
    const double s = std::sin(theta_rad);
    return {s * std::cos(phi_rad), s * std::sin(phi_rad), std::cos(theta_rad)};
}

} // namespace

SphereSensor sphereSensorAt(const std::array<double, 3>& angles_rad, int frames, double radius_m) {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    const AngleAxisd x(angles_rad[0], Vector3d::UnitX());
    const AngleAxisd y(angles_rad[1], Vector3d::UnitY());
    const AngleAxisd z(angles_rad[2], Vector3d::UnitZ());
    Eigen::Matrix3d rotation = frames == 1 ? (x * y * z).toRotationMatrix() : (z * y * x).toRotationMatrix();
    if (frames == 2) {
        const Vector3d place = rotation.col(0);
        const double theta_rad = std::acos(std::clamp(place.z(), -1.0, 1.0));
        rotation = (AngleAxisd(std::atan2(place.y(), place.x()), Vector3d::UnitZ()) *
                    AngleAxisd(theta_rad - Pi / 2.0, Vector3d::UnitY()))
                       .toRotationMatrix();
    }
    SphereSensor sensor;
    sensor.place_m = radius_m * rotation.col(0);
    sensor.axes << rotation.col(0), -rotation.col(2), rotation.col(1);
    return sensor;
}

/// Stator frame to picture: right, up, towards the eye.
struct SphereView::Sight {
    Eigen::Matrix3d view;
    QPointF middle;
    double pixels = 1.0; ///< a radius of the rotor

    QPointF at(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d seen = view * point;
        return {middle.x() + pixels * seen.x(), middle.y() - pixels * seen.y()};
    }
    double depth(const Eigen::Vector3d& point) const { return view.row(2).dot(point); }
    bool isHidden(const Eigen::Vector3d& point) const { return depth(point) < 0.0; }
};

SphereView::SphereView(QWidget* parent)
    : QWidget(parent), m_azimuth_rad(FirstAzimuth_rad), m_elevation_rad(FirstElevation_rad) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
    m_sensors[0] = sphereSensorAt({0.0, 0.0, 0.0}, 0, 0.05);
    m_sensors[1] = sphereSensorAt({0.0, 0.0, Pi / 4.0}, 0, 0.05);
    m_sensors[2] = sphereSensorAt({Pi / 4.0, Pi / 4.0, -Pi / 2.0}, 0, 0.05);
    describe();
}

void SphereView::setSensors(const std::array<SphereSensor, 3>& sensors) {
    m_sensors = sensors;
    update();
}

void SphereView::setReadings(const std::array<double, 9>& readings_T) {
    const bool isFinite =
        std::all_of(readings_T.begin(), readings_T.end(), [](double value) { return std::isfinite(value); });
    m_readings_T = isFinite ? std::optional(readings_T) : std::nullopt;
    update();
}

void SphereView::setOrientation(const Eigen::Matrix3d& rotation, double cone_rad, SphereVerdict verdict) {
    if (!rotation.allFinite()) {
        return;
    }
    m_rotation = rotation;
    m_cone_rad = cone_rad;
    m_verdict = verdict;
    const Eigen::Vector3d tip = rotation.col(2);
    const bool isNew = m_path.empty() || (m_path.back() - tip).norm() > PathStep;
    if (verdict != SphereVerdict::Held && isNew) {
        m_path.push_back(tip);
        if (m_path.size() > LongestPath) {
            m_path.pop_front();
        }
    }
    describe();
    update();
}

void SphereView::setTruth(const std::optional<Eigen::Matrix3d>& rotation) {
    m_truth = rotation;
    update();
}

void SphereView::setWanted(std::vector<SphereWanted> wanted) {
    m_wanted = std::move(wanted);
    update();
}

void SphereView::setStale(bool isStale) {
    m_isStale = isStale;
    describe();
    update();
}

void SphereView::clear() {
    m_rotation.reset();
    m_readings_T.reset();
    m_truth.reset();
    m_verdict = SphereVerdict::Unknown;
    clearPath();
    describe();
}

void SphereView::clearPath() {
    m_path.clear();
    update();
}

void SphereView::setSight(double azimuth_rad, double elevation_rad) {
    m_azimuth_rad = std::remainder(azimuth_rad, 2.0 * Pi);
    m_elevation_rad = std::clamp(elevation_rad, -Pi / 2.0, Pi / 2.0);
    update();
}

SphereView::Sight SphereView::sight(const QSizeF& size) const {
    Sight result;
    const Eigen::Vector3d towards = onSphere(Pi / 2.0 - m_elevation_rad, m_azimuth_rad);
    const Eigen::Vector3d right(-std::sin(m_azimuth_rad), std::cos(m_azimuth_rad), 0.0);
    result.view << right.transpose(), towards.cross(right).transpose(), towards.transpose();
    result.middle = {size.width() / 2.0, size.height() / 2.0};
    result.pixels = 0.5 * std::min(size.width(), size.height()) / Reach;
    return result;
}

QPointF SphereView::placeOf(const Eigen::Vector3d& point_m) const {
    return sight(size()).at(point_m / RotorRadius_m);
}

bool SphereView::isBehind(const Eigen::Vector3d& point_m) const {
    return sight(size()).isHidden(point_m);
}

Eigen::Vector3d SphereView::directionAt(const QPointF& at, double radius_m, bool isBehind) const {
    const Sight seen = sight(size());
    const double radius_px = seen.pixels * radius_m / RotorRadius_m;
    Eigen::Vector3d direction((at.x() - seen.middle.x()) / radius_px, (seen.middle.y() - at.y()) / radius_px,
                              0.0);
    const double square = direction.squaredNorm();
    if (square < 1.0) {
        direction.z() = isBehind ? -std::sqrt(1.0 - square) : std::sqrt(1.0 - square);
    }
    return seen.view.transpose() * direction.normalized();
}

void SphereView::drawRotor(QPainter& painter, const Theme& theme, const Sight& sight) const {
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.raised);
    painter.drawEllipse(sight.middle, sight.pixels, sight.pixels);
    if (!m_rotation) {
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int band = 0; band < Bands; ++band) {
        for (int sector = 0; sector < Sectors; ++sector) {
            const double theta_rad = Pi * (band + 0.5) / Bands;
            const double phi_rad = 2.0 * Pi * (sector + 0.5) / Sectors;
            if (sight.isHidden(*m_rotation * onSphere(theta_rad, phi_rad))) {
                continue;
            }
            // The radial field of the four poles.
            const double field = std::pow(std::sin(theta_rad), 2) * std::cos(2.0 * phi_rad);
            const QColor colour =
                mixed(theme.raised, field > 0.0 ? theme.curves[1] : theme.curves[0], 0.85 * std::abs(field));
            QPolygonF patch;
            for (const auto& [down, along] :
                 {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
                patch << sight.at(*m_rotation * onSphere(Pi * (band + down) / Bands,
                                                         2.0 * Pi * (sector + along) / Sectors));
            }
            painter.setPen(colour);
            painter.setBrush(colour);
            painter.drawPolygon(patch);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(sight.middle, sight.pixels, sight.pixels);
}

void SphereView::drawAxes(QPainter& painter, const Theme& theme, const Sight& sight, bool areInFront) const {
    constexpr std::array Names = {"X", "Y", "Z"};
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
        if (sight.isHidden(axis) == areInFront) {
            continue;
        }
        painter.setPen(QPen(theme.plotAxis, 1.0));
        painter.drawLine(sight.at(areInFront ? axis : Eigen::Vector3d(0.2 * axis)),
                         sight.at(AxisLength * axis));
        painter.setPen(theme.muted);
        painter.drawText(sight.at((AxisLength + 0.1) * axis) + QPointF(-4.0, 4.0),
                         QLatin1String(Names[static_cast<std::size_t>(i)]));
    }
}

void SphereView::drawSensors(QPainter& painter, const Theme& theme, const Sight& sight,
                             bool areInFront) const {
    for (std::size_t i = 0; i < m_sensors.size(); ++i) {
        const SphereSensor& sensor = m_sensors[i];
        const Eigen::Vector3d place = sensor.place_m / RotorRadius_m;
        if (sight.isHidden(place) == areInFront) {
            continue;
        }
        const QPointF at = sight.at(place);
        painter.setPen(QPen(theme.text, 1.0));
        painter.setBrush(theme.panel);
        painter.drawRect(QRectF(at.x() - 4.0, at.y() - 4.0, 8.0, 8.0));
        painter.drawText(at + QPointF(7.0, -7.0), QString::number(i));
        if (!m_readings_T) {
            continue;
        }
        const Eigen::Vector3d field =
            sensor.axes *
            Eigen::Vector3d((*m_readings_T)[3 * i], (*m_readings_T)[3 * i + 1], (*m_readings_T)[3 * i + 2]);
        const QPointF tip = sight.at(place + FieldScale * field);
        painter.setPen(QPen(theme.accent, 2.0));
        painter.drawLine(at, tip);
        const QPointF along = tip - at;
        const double length = std::hypot(along.x(), along.y());
        if (length > 8.0) {
            const QPointF back = along * (6.0 / length);
            const QPointF side(-back.y() * 0.5, back.x() * 0.5);
            painter.drawLine(tip, tip - back + side);
            painter.drawLine(tip, tip - back - side);
        }
    }
}

void SphereView::drawShaft(QPainter& painter, const Theme& theme, const Sight& sight, bool isInFront) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.muted, 1.0));
    for (std::size_t i = 1; i < m_path.size(); ++i) {
        // A shaft that is suddenly on the other side is another of the orientations with the same field.
        if (m_path[i - 1].dot(m_path[i]) < 0.0) {
            continue;
        }
        if (sight.isHidden(m_path[i]) != isInFront) {
            painter.drawLine(sight.at(ShaftLength * m_path[i - 1]), sight.at(ShaftLength * m_path[i]));
        }
    }
    if (m_truth && sight.isHidden(m_truth->col(2)) != isInFront) {
        painter.setPen(QPen(theme.simulated, 1.5, Qt::DashLine));
        const Eigen::Vector3d tip = m_truth->col(2);
        painter.drawLine(sight.at(tip), sight.at(1.08 * ShaftLength * tip));
    }
    if (!m_rotation || sight.isHidden(m_rotation->col(2)) == isInFront) {
        return;
    }
    const bool isGood = m_verdict == SphereVerdict::Fresh && !m_isStale;
    const QColor colour = isGood                                 ? theme.text
                          : m_verdict == SphereVerdict::Doubtful ? theme.warn
                                                                 : theme.disabled;
    const Eigen::Vector3d tip = m_rotation->col(2);
    painter.setPen(QPen(colour, 3.0));
    painter.drawLine(sight.at(tip), sight.at(ShaftLength * tip));
    QPolygonF cone;
    const double radius = ShaftLength * std::tan(std::min(m_cone_rad, 1.2));
    for (int i = 0; i <= ConeCorners; ++i) {
        const double turn_rad = 2.0 * Pi * i / ConeCorners;
        cone << sight.at(ShaftLength * tip + radius * (std::cos(turn_rad) * m_rotation->col(0) +
                                                       std::sin(turn_rad) * m_rotation->col(1)));
    }
    painter.setPen(QPen(colour, 1.0));
    painter.drawPolyline(cone);
}

void SphereView::drawWanted(QPainter& painter, const Theme& theme, const Sight& sight,
                            bool areInFront) const {
    painter.setPen(Qt::NoPen);
    for (const SphereWanted& wanted : m_wanted) {
        if (sight.isHidden(wanted.direction) != areInFront) {
            painter.setBrush(wanted.isFailing
                                 ? theme.bad
                                 : mixed(theme.good, theme.warn, std::clamp(wanted.share, 0.0, 1.0)));
            const double radius = LeastDot_px + MoreDot_px * std::clamp(wanted.share, 0.0, 1.0);
            painter.drawEllipse(sight.at(ShaftLength * wanted.direction), radius, radius);
        }
    }
}

void SphereView::drawWords(QPainter& painter, const Theme& theme, const QSizeF& size) const {
    painter.setPen(m_verdict == SphereVerdict::Doubtful || m_verdict == SphereVerdict::Held ? theme.warn
                                                                                            : theme.muted);
    painter.drawText(QRectF(8.0, 8.0, size.width() - 16.0, size.height() - 16.0),
                     Qt::AlignTop | Qt::AlignLeft, verdictText());
}

void SphereView::draw(QPainter& painter, const Theme& theme, const QSizeF& size) const {
    const Sight seen = sight(size);
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.fillRect(QRectF(QPointF(0.0, 0.0), size), theme.plotBackground);
    for (const bool isInFront : {false, true}) {
        if (isInFront) {
            drawRotor(painter, theme, seen);
        }
        drawAxes(painter, theme, seen, isInFront);
        drawWanted(painter, theme, seen, isInFront);
        drawShaft(painter, theme, seen, isInFront);
        drawSensors(painter, theme, seen, isInFront);
    }
    drawWords(painter, theme, size);
}

QString SphereView::verdictText() const {
    if (m_isStale && m_rotation) {
        return tr("old values");
    }
    switch (m_verdict) {
    case SphereVerdict::Fresh:
        return {};
    case SphereVerdict::Doubtful:
        return tr("doubtful: readings do not fit the model");
    case SphereVerdict::Held:
        return tr("ambiguous: last orientation shown");
    case SphereVerdict::Unknown:
        break;
    }
    return tr("orientation unknown");
}

void SphereView::describe() {
    setAccessibleName(tr("Rotor, sensors and shaft from the side"));
    QString words = verdictText();
    if (m_rotation) {
        const Eigen::Vector3d shaft = m_rotation->col(2);
        const double theta_deg = radiansToDegrees(std::acos(std::clamp(shaft.z(), -1.0, 1.0)));
        words = tr("shaft %1 degrees from Z; %2").arg(std::lround(theta_deg)).arg(words);
    }
    if (words != accessibleDescription()) {
        setAccessibleDescription(words);
    }
}

void SphereView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme theme = currentTheme();
    draw(painter, theme, size());
    if (hasFocus()) {
        painter.setPen(QPen(theme.accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void SphereView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        describe();
    }
    update();
}

void SphereView::mousePressEvent(QMouseEvent* event) {
    m_dragged = event->localPos();
}

void SphereView::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) == 0) {
        return;
    }
    const QPointF step = event->localPos() - m_dragged;
    m_dragged = event->localPos();
    setSight(m_azimuth_rad - DragStep_rad * step.x(), m_elevation_rad + DragStep_rad * step.y());
}

void SphereView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        return setSight(m_azimuth_rad - KeyStep_rad, m_elevation_rad);
    case Qt::Key_Right:
        return setSight(m_azimuth_rad + KeyStep_rad, m_elevation_rad);
    case Qt::Key_Up:
        return setSight(m_azimuth_rad, m_elevation_rad + KeyStep_rad);
    case Qt::Key_Down:
        return setSight(m_azimuth_rad, m_elevation_rad - KeyStep_rad);
    case Qt::Key_Home:
        return setSight(FirstAzimuth_rad, FirstElevation_rad);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace halbench::widgets
