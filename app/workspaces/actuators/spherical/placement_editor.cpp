#include "app/workspaces/actuators/spherical/placement_editor.h"

#include "app/workspaces/actuators/spherical/board_sensors.h"
#include "app/workspaces/parts/field_grid.h"
#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "widgets/actuators/spherical/placement_view.h"
#include "widgets/controls/quantity_edit.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr int GridColumns = 4;

/// The three angles of a placement, in the order of its name (da, db, dg).
std::array<double*, 3> partsOf(models::PlacementAngles& angles) {
    return {&angles.alpha_rad, &angles.beta_rad, &angles.gamma_rad};
}

} // namespace

PlacementEditor::PlacementEditor(QWidget* parent)
    : QWidget(parent), m_placement(models::publishedPlacement()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GridStep_px);
    m_view = new widgets::PlacementView(this);
    m_view->setToolTip(tr("Drag a sensor, or 0, 1, 2 and arrow keys; Shift turns"));
    column->addWidget(m_view, 1);
    buildAngles(*column);
    connect(m_view, &widgets::PlacementView::sensorMoved, this, &PlacementEditor::moveSensor);
    connect(m_view, &widgets::PlacementView::sensorChosen, m_sensor,
            [this](std::size_t sensor) { m_sensor->setCurrentIndex(static_cast<int>(sensor)); });
    connect(m_sensor, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int sensor) {
        m_view->choose(static_cast<std::size_t>(sensor));
        showAngles();
    });
    showSensors();
    showAngles();
}

void PlacementEditor::buildAngles(QBoxLayout& column) {
    auto* grid = new FieldGrid(GridColumns, this);
    m_sensor = grid->addBox(tr("Sensor"), tr("Sensor that the angles and arrow keys move"),
                            {QStringLiteral("0"), QStringLiteral("1"), QStringLiteral("2")});
    m_sensor->setMinimumContentsLength(1);
    constexpr std::array Names = {"Δα", "Δβ", "Δγ"};
    for (std::size_t i = 0; i < m_angles.size(); ++i) {
        m_angles[i] = grid->addNumber({QString::fromUtf8(Names[i]),
                                       tr("Rotation from the X axis to the sensor's place"),
                                       QStringLiteral("°"), 2, -180.0, 180.0, 1.0});
        connect(m_angles[i], &widgets::QuantityEdit::edited, this, &PlacementEditor::takeAngles);
    }
    column.addWidget(grid);
    m_order = makeNote(this);
    m_order->setAccessibleName(tr("Order of the rotations"));
    column.addWidget(m_order);
}

void PlacementEditor::setBoard(const SensingBoard& board) {
    m_board = board;
    if (!m_isOnTrial) {
        m_placement = board.placement;
    }
    showSensors();
    showAngles();
}

models::SensorPoses PlacementEditor::poses() const {
    if (m_isOnTrial) {
        const models::PlacementDevice nominal = device(models::SphericalDevice::Exact);
        return models::sensorPoses(m_placement, nominal.frames, nominal.radius_m);
    }
    models::SensorPoses poses;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        poses[i] = m_board.calibration.sensors[i].pose;
    }
    return poses;
}

models::PlacementDevice PlacementEditor::device(models::SphericalDevice model) const {
    models::PlacementDevice device;
    device.device = model;
    device.frames = m_board.frames;
    device.radius_m = 0.0;
    for (const models::SensorCalibration& sensor : m_board.calibration.sensors) {
        device.radius_m += sensor.pose.position_m.norm() / static_cast<double>(m_placement.size());
    }
    device.strength_T = m_board.calibration.field.strength_T;
    return device;
}

void PlacementEditor::tryPlacement(const models::SensorTriple& placement) {
    m_placement = placement;
    m_isOnTrial = true;
    showSensors();
    Q_EMIT placementChanged();
}

void PlacementEditor::moveSensor(std::size_t sensor, const Eigen::Vector3d& direction) {
    models::SensorTriple placement = m_placement;
    placement[sensor] = placementTowards(placement[sensor], m_board.frames, direction);
    for (double* angle_rad : partsOf(placement[sensor])) {
        *angle_rad = std::remainder(*angle_rad, 2.0 * Pi);
    }
    tryPlacement(placement);
    showAngles();
}

void PlacementEditor::takeAngles() {
    models::SensorTriple placement = m_placement;
    const std::array<double*, 3> parts = partsOf(placement[m_view->chosen()]);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        *parts[i] = degreesToRadians(m_angles[i]->value());
    }
    tryPlacement(placement);
}

void PlacementEditor::tryRecommended() {
    tryPlacement(models::recommendedPlacement());
    showAngles();
}

void PlacementEditor::goBack() {
    m_isOnTrial = false;
    m_placement = m_board.placement;
    showSensors();
    showAngles();
    Q_EMIT placementChanged();
}

void PlacementEditor::showSensors() {
    const models::SensorPoses shown = poses();
    std::array<widgets::SphereSensor, 3> sensors;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        sensors[i] = {shown[i].position_m, shown[i].axes};
    }
    m_view->setSensors(sensors);
}

void PlacementEditor::showAngles() {
    const std::array<double*, 3> parts = partsOf(m_placement[m_view->chosen()]);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        m_angles[i]->setQuantity(radiansToDegrees(*parts[i]));
    }
    m_order->setText(placementOrderInWords(m_board.frames));
}

void PlacementEditor::showPose(const models::OrientationAngles& angles,
                               const models::SphericalReadings& readings_T) {
    std::array<double, 9> readings{};
    std::copy(readings_T.begin(), readings_T.end(), readings.begin());
    m_view->clearPath();
    m_view->setReadings(readings);
    m_view->setOrientation(models::rotationOf(angles), 0.0, widgets::SphereVerdict::Fresh);
}

void PlacementEditor::showUncovered(const std::vector<UncoveredShaft>& shafts) {
    std::vector<widgets::SphereWanted> dots;
    for (const UncoveredShaft& shaft : shafts) {
        // The area of a dot grows with the share of the spins.
        dots.push_back({models::rotationOf({shaft.alpha_rad, shaft.beta_rad, 0.0}).col(2),
                        std::sqrt(shaft.share), true});
    }
    m_view->setWanted(std::move(dots));
}

} // namespace halbench::app
