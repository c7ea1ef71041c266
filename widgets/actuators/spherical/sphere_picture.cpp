#include "widgets/actuators/spherical/sphere_picture.h"

#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "widgets/actuators/spherical/sphere_view.h"
#include "widgets/language/display_units.h"

#include <QAction>
#include <QVBoxLayout>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace halbench::widgets {

namespace {

constexpr std::array SensorAxes = {"r", "theta", "phi"};
constexpr int ResidualFlag = 4; ///< of the integrity: the readings do not fit the model

std::string fieldRole(std::size_t channel) {
    return "field." + std::to_string(channel / 3) + "." + SensorAxes[channel % 3];
}

QString degreesText(double angle_rad) {
    return fixedText(radiansToDegrees(angle_rad), 2);
}

/// In the frame of the stator; nothing while the device does not say it.
std::optional<Eigen::Matrix3d> estimateOf(const ActuatorValues& values) {
    const std::optional<double> real = values.signal("orientation.w");
    if (!real) {
        return std::nullopt;
    }
    const auto part = [&](const char* role) { return values.signal(role).value_or(0.0); };
    const Eigen::Quaterniond quaternion(*real, part("orientation.x"), part("orientation.y"),
                                        part("orientation.z"));
    return quaternion.normalized().toRotationMatrix();
}

std::optional<Eigen::Matrix3d> truthOf(const ActuatorValues& values) {
    const std::optional<double> alpha_rad = values.signal("truth.alpha");
    if (!alpha_rad) {
        return std::nullopt;
    }
    return models::rotationOf(
        {*alpha_rad, values.signal("truth.beta").value_or(0.0), values.signal("truth.gamma").value_or(0.0)});
}

} // namespace

SpherePicture::SpherePicture(QWidget* parent) : ActuatorPicture(parent), m_view(new SphereView(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
    setFocusProxy(m_view);
    auto* forget = new QAction(tr("&Clear path"), this);
    forget->setToolTip(tr("Clear the path of the shaft (Alt+C)"));
    connect(forget, &QAction::triggered, m_view, &SphereView::clearPath);
    addAction(forget);
}

void SpherePicture::showSettings(const ActuatorValues& values) {
    std::array<SphereSensor, 3> sensors;
    const int frames = static_cast<int>(values.parameter("sensor.frames").value_or(0.0));
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        const std::string number = std::to_string(i);
        std::array<double, 3> angles_rad{};
        constexpr std::array Names = {"sensor.alpha_", "sensor.beta_", "sensor.gamma_"};
        for (std::size_t k = 0; k < angles_rad.size(); ++k) {
            const std::optional<double> angle = values.parameter(Names[k] + number);
            if (!angle) {
                return;
            }
            angles_rad[k] = *angle;
        }
        sensors[i] =
            sphereSensorAt(angles_rad, frames, values.parameter("sensor.radius_" + number).value_or(0.05));
    }
    m_view->setSensors(sensors);
}

void SpherePicture::showSamples(const ActuatorValues& values) {
    const auto value = [&](const std::string& role) { return values.signal(role).value_or(0.0); };
    const std::optional<Eigen::Matrix3d> rotation = estimateOf(values);
    if (!rotation) {
        return;
    }
    const bool isHeld = values.signal("orientation.fresh").value_or(1.0) < 0.5;
    if (!isHeld) {
        countImages(*rotation);
    }
    const bool isDoubtful = (static_cast<int>(value("integrity")) & ResidualFlag) != 0;
    m_view->setOrientation(*rotation, value("shaft.cone95"),
                           isHeld       ? SphereVerdict::Held
                           : isDoubtful ? SphereVerdict::Doubtful
                                        : SphereVerdict::Fresh);
    std::array<double, 9> readings_T{};
    for (std::size_t channel = 0; channel < readings_T.size(); ++channel) {
        readings_T[channel] = value(fieldRole(channel));
    }
    m_view->setReadings(readings_T);
    describe(values, *rotation);
}

/// The device shows the one with its shaft up: as the rotor turns past that limit, the shown pose jumps.
void SpherePicture::countImages(const Eigen::Matrix3d& rotation) {
    constexpr double Rounding = 1e-3;
    const bool isOther = m_last && (models::nearestImage(rotation, *m_last) - rotation).norm() > Rounding;
    m_imageChanges += isOther ? 1 : 0;
    m_last = rotation;
}

void SpherePicture::describe(const ActuatorValues& values, const Eigen::Matrix3d& rotation) {
    const models::OrientationAngles angles = models::anglesOf(rotation);
    const std::optional<double> cone_rad = values.signal("shaft.cone95");
    m_numbers =
        tr("α %1°, β %2°, γ %3° (γ about Z first, then β about Y, then α about X)")
            .arg(degreesText(angles.alpha_rad), degreesText(angles.beta_rad), degreesText(angles.gamma_rad));
    m_numbers += QLatin1Char('\n') +
                 tr("q %1 mT, chi-square %2, 95 % cone ±%3°")
                     .arg(fixedText(1e3 * values.signal("strength").value_or(0.0), 2),
                          fixedText(values.signal("chi_square"), 1),
                          fixedText(cone_rad ? std::optional(radiansToDegrees(*cone_rad)) : std::nullopt, 2));
    if (m_imageChanges > 0) {
        m_numbers += QLatin1Char('\n') +
                     tr("changes to another orientation with the same field: %1").arg(m_imageChanges);
    }
    showTruth(truthOf(values), rotation);
}

/// As the one of the four orientations with the same field that lies nearest to the estimate.
void SpherePicture::showTruth(const std::optional<Eigen::Matrix3d>& truth, const Eigen::Matrix3d& rotation) {
    if (!truth) {
        m_view->setTruth({});
        return;
    }
    const Eigen::Matrix3d nearest = models::nearestImage(*truth, rotation);
    const models::OrientationAngles angles = models::anglesOf(nearest);
    m_view->setTruth(nearest);
    m_numbers += QLatin1Char('\n') + tr("simulated truth: α %1°, β %2°, γ %3°; error %4°")
                                         .arg(degreesText(angles.alpha_rad), degreesText(angles.beta_rad),
                                              degreesText(angles.gamma_rad),
                                              degreesText(models::symmetricError_rad(rotation, *truth)));
}

void SpherePicture::setStale(bool isStale) {
    m_view->setStale(isStale);
}

void SpherePicture::clear() {
    m_view->clear();
    m_numbers.clear();
    m_last.reset();
    m_imageChanges = 0;
}

void SpherePicture::showWanted(const std::vector<WantedShaft>& shafts) {
    std::vector<SphereWanted> wanted;
    for (const WantedShaft& shaft : shafts) {
        const double s = std::sin(shaft.theta_rad);
        wanted.push_back(
            {{s * std::cos(shaft.phi_rad), s * std::sin(shaft.phi_rad), std::cos(shaft.theta_rad)},
             shaft.share});
    }
    m_view->setWanted(std::move(wanted));
}

ActuatorPicture::Drawing SpherePicture::drawing() const {
    return [this](QPainter& painter, const Theme& theme, const QSizeF& size) {
        m_view->draw(painter, theme, size);
    };
}

ActuatorView sphereActuatorView() {
    ActuatorView view{"spherical",
                      {"orientation.w", "orientation.x", "orientation.y", "orientation.z"},
                      {"orientation.fresh", "shaft.cone95", "integrity", "chi_square", "strength",
                       "truth.alpha", "truth.beta", "truth.gamma"},
                      [](QWidget* parent) { return new SpherePicture(parent); }};
    for (std::size_t channel = 0; channel < 9; ++channel) {
        view.wished.push_back(fieldRole(channel));
    }
    return view;
}

} // namespace halbench::widgets
