#include "app/actuators/spherical/sensing_needs.h"

#include "app/actuators/spherical/missing_orientations.h"
#include "app/actuators/spherical/rotation_order.h"
#include "app/actuators/spherical/sensing_board.h"
#include "app/actuators/spherical/sensing_fit.h"
#include "app/actuators/spherical/sensing_motion.h"
#include "control/base/units.h"
#include "models/spherical/orientation.h"

#include <algorithm>

namespace halbench::app {
namespace {

constexpr std::size_t MostRows = 150;
constexpr std::size_t ListedOrientations = 2;
constexpr double Tilts_deg[] = {-40.0, -20.0, 0.0, 20.0, 40.0};
constexpr double Spins_deg[] = {-60.0, -30.0, 0.0, 30.0, 60.0, 90.0};

std::vector<ParameterValue> listed(const std::map<std::string, double>& values) {
    std::vector<ParameterValue> list;
    for (const auto& [name, value] : values) {
        list.push_back({name, value});
    }
    return list;
}

/// Every direction of the workspace with the largest gain of its spins.
template <typename Gain>
std::vector<ShaftNeed> shaftNeeds(Gain gain) {
    std::vector<ShaftNeed> needs;
    double most = 0.0;
    for (const double alpha : Tilts_deg) {
        for (const double beta : Tilts_deg) {
            double largest = 0.0;
            models::OrientationAngles angles{degreesToRadians(alpha), degreesToRadians(beta), 0.0};
            for (const double gamma : Spins_deg) {
                angles.gamma_rad = degreesToRadians(gamma);
                largest = std::max(largest, gain(models::rotationOf(angles)));
            }
            const models::ShaftDirection shaft = models::shaftOf(models::rotationOf(angles));
            needs.push_back({shaft.theta_rad, shaft.phi_rad, largest});
            most = std::max(most, largest);
        }
    }
    for (ShaftNeed& need : needs) {
        need.share = most > 0.0 ? need.share / most : 0.0;
    }
    return needs;
}

} // namespace

MotionNeeds sensingNeeds(const Recording& rows, const std::map<std::string, double>& values) {
    const SensingBoard board = notedSensingBoard(listed(values));
    MotionNeeds needs;
    needs.shafts = shaftNeeds([](const Eigen::Matrix3d&) { return 1.0; });
    const auto motion = sensedMotion(rows);
    if (!motion) {
        return needs;
    }
    std::vector<models::CalibrationSample> samples;
    const std::size_t step = 1 + (motion->samples.size() - 1) / MostRows;
    for (std::size_t i = 0; i < motion->samples.size(); i += step) {
        samples.push_back(motion->samples[i]);
    }
    const models::CalibrationConfig config = sensingFitConfig(*motion, board, false);
    const auto excitation = models::calibrationExcitation(board.calibration, samples, config);
    if (!excitation) {
        return needs; // too few rows so far
    }
    needs.isEnough = excitation->isEnough();
    if (needs.isEnough) {
        needs.shafts = shaftNeeds([](const Eigen::Matrix3d&) { return 0.0; });
        return needs;
    }
    needs.shafts = shaftNeeds([&](const Eigen::Matrix3d& rotation) {
        return models::calibrationGain(board.calibration, *excitation, config, rotation);
    });
    for (const models::OrientationAngles& angles :
         missingOrientations(board.calibration, *excitation, config, ListedOrientations)) {
        needs.missing.push_back(orientationText(angles));
    }
    needs.order = orientationOrder();
    return needs;
}

} // namespace halbench::app
