#include "app/workspaces/actuators/spherical/board_sensors.h"

#include "app/actuators/spherical/rotation_order.h"
#include "app/workbench/drive_ability.h"
#include "control/base/units.h"
#include "widgets/language/display_units.h"
#include "widgets/language/greek_angles.h"
#include "widgets/language/phrasebook.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace halbench::app {

std::vector<std::string> boardSensorRoles() {
    std::vector<std::string> roles = {"sensor.frames", "sensor.deviation", "rotor.strength"};
    for (const char* sensor : {"0", "1", "2"}) {
        for (const char* place : {"alpha_", "beta_", "gamma_", "radius_"}) {
            roles.push_back(std::string("sensor.") + place + sensor);
        }
    }
    return roles;
}

SensingBoard boardSensors(Workbench& bench) {
    std::vector<ParameterValue> values;
    const devices::Catalogue& catalogue = bench.session().catalogue();
    for (const std::string& role : sensingParameters()) {
        if (const std::optional<double> value = bench.deviceValue(parameterOfRole(catalogue, role))) {
            values.push_back({role, *value});
        }
    }
    return notedSensingBoard(values);
}

models::SphericalSensing sensingOf(const SensingBoard& board) {
    models::SphericalSensing sensing;
    for (std::size_t i = 0; i < sensing.poses.size(); ++i) {
        sensing.poses[i] = board.calibration.sensors[i].pose;
    }
    sensing.field = board.calibration.field;
    std::erase_if(sensing.field.harmonics, [](const auto& harmonic) { return harmonic.amplitude_T == 0.0; });
    if (board.deviation_T > 0.0) {
        sensing.deviation_T = models::SphericalReadings::Constant(board.deviation_T);
    }
    return sensing;
}

QString sensorsInWords(const SensingBoard& board) {
    QStringList places;
    for (std::size_t i = 0; i < board.placement.size(); ++i) {
        const models::PlacementAngles& angles = board.placement[i];
        const auto degrees = [](double angle_rad) {
            return widgets::numberText(radiansToDegrees(angle_rad), 4);
        };
        places << QStringLiteral("(%1, %2, %3)°")
                      .arg(degrees(angles.alpha_rad), degrees(angles.beta_rad), degrees(angles.gamma_rad));
    }
    return QCoreApplication::translate("halbench::app::EstimatorPanel",
                                       "Sensors at %1 (%4), %2 mm from the centre; q %3 mT")
        .arg(places.join(QStringLiteral(", ")), widgets::numberText(1e3 * meanRadius_m(board), 4),
             widgets::numberText(1e3 * board.calibration.field.strength_T, 4),
             placementOrderInWords(board.frames));
}

QString orientationOrderInWords() {
    return widgets::greekAngles(widgets::inWords(orientationOrder()));
}

QString placementOrderInWords(models::SensorFrames frames) {
    return widgets::greekAngles(widgets::inWords(placementOrder(frames)));
}

} // namespace halbench::app
