#include "app/actuators/spherical/sensing_signs.h"

#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/orientation_estimator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using Signs = std::array<bool, models::ChannelCount>; ///< true: reversed

constexpr std::size_t MostSamples = 300;
/// Reversed: the readings are at least this share of the expected ones, with the other sign.
constexpr double ReversedShare = -0.5;
/// Residual of readings that are not of one field; parts and assembly leave 3 mT.
constexpr double Misfit_T = 0.01;
/// A reversal must reduce the squares of the residual by this factor.
constexpr double LeastGain_ratio = 10.0;
/// Known orientations beyond this angle from those of the readings are not theirs.
constexpr double OtherOrientation_rad = 20.0 * Pi / 180.0;

std::vector<std::size_t> chosenSamples(const SensedMotion& motion) {
    std::vector<std::size_t> chosen;
    const std::size_t step = 1 + motion.samples.size() / MostSamples;
    for (std::size_t n = 0; n < motion.samples.size(); n += step) {
        chosen.push_back(n);
    }
    return chosen;
}

std::string namesOf(const Signs& reversed) {
    std::string names;
    const std::vector<std::string> all = fieldSignals();
    for (std::size_t c = 0; c < all.size(); ++c) {
        names += reversed[c] ? (names.empty() ? "" : ", ") + all[c] : "";
    }
    return names;
}

/// The readings as a share of the field that is expected at the orientations of the recording.
double shareOfExpected(const SensedMotion& motion, const SensingBoard& board) {
    const std::vector<models::CalibrationUnknown> none;
    const models::CalibrationModel model(board.calibration, none);
    double product_T2 = 0.0;
    double square_T2 = 0.0;
    for (const std::size_t n : chosenSamples(motion)) {
        const models::CalibrationSample& sample = motion.samples[n];
        if (motion.recorded[n].allFinite() && sample.used == models::AllChannels) {
            const models::SphericalReadings expected_T = model.at(motion.recorded[n], sample).readings_T;
            product_T2 += sample.readings_T.dot(expected_T);
            square_T2 += expected_T.squaredNorm();
        }
    }
    return square_T2 > 0.0 ? product_T2 / square_T2 : 1.0;
}

/// rms of what the linear fit of the tensor leaves of the readings with these signs.
double misfit_T(const SensedMotion& motion, const SensingBoard& board, const models::TensorSystem& system,
                const Signs& reversed) {
    double square_T2 = 0.0;
    double freedom = 0.0;
    for (const std::size_t n : chosenSamples(motion)) {
        const models::CalibrationSample& sample = motion.samples[n];
        if (sample.used != models::AllChannels) {
            continue;
        }
        models::SphericalReadings readings_T = sample.readings_T;
        for (std::size_t c = 0; c < reversed.size(); ++c) {
            readings_T[static_cast<Eigen::Index>(c)] *= reversed[c] ? -1.0 : 1.0;
        }
        const models::SphericalReadings field_T =
            models::correctedReadings_T(board.calibration, readings_T, sample.coilCurrent_A);
        square_T2 += (field_T - system.design() * system.solve(field_T)).squaredNorm();
        freedom += system.freedom();
    }
    return freedom > 0.0 ? std::sqrt(square_T2 / freedom) : 0.0;
}

/// Single channels, whole sensors, one component of all sensors.
std::vector<Signs> plausibleReversals() {
    std::vector<Signs> reversals;
    for (std::size_t c = 0; c < models::ChannelCount; ++c) {
        Signs one{};
        one[c] = true;
        reversals.push_back(one);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        Signs sensor{};
        Signs component{};
        for (std::size_t k = 0; k < 3; ++k) {
            sensor[3 * i + k] = component[3 * k + i] = true;
        }
        reversals.push_back(sensor);
        reversals.push_back(component);
    }
    return reversals;
}

Finding reversedFinding(std::string message) {
    return {"readings_reversed", std::move(message),
            "Check the wiring and the direction of the sensors, reverse the sign of these columns and "
            "calibrate again."};
}

std::optional<Finding> reversalWithoutOrientations(const SensedMotion& motion, const SensingBoard& board) {
    const models::TensorSystem system(models::sensingOf(board.calibration, board.deviation_T));
    const double before_T = system.isDetermined() ? misfit_T(motion, board, system, {}) : 0.0;
    if (before_T < Misfit_T) {
        return std::nullopt;
    }
    std::optional<Signs> best;
    double least_T = before_T / std::sqrt(LeastGain_ratio);
    for (const Signs& reversal : plausibleReversals()) {
        const double after_T = misfit_T(motion, board, system, reversal);
        if (after_T < least_T) {
            least_T = after_T;
            best = reversal;
        }
    }
    return best ? std::optional<Finding>(
                      reversedFinding(namesOf(*best) + " read with the opposite sign of the others"))
                : std::nullopt;
}

/// Known orientations in another unit, another order of the rotations or of another time.
std::optional<Finding> otherReferences(const SensedMotion& motion, const SensingBoard& board) {
    const auto estimator =
        models::OrientationEstimator::make(models::sensingOf(board.calibration, board.deviation_T), {});
    std::vector<double> off_rad;
    for (const std::size_t n : estimator ? chosenSamples(motion) : std::vector<std::size_t>()) {
        const models::CalibrationSample& sample = motion.samples[n];
        if (sample.used == models::AllChannels) {
            double strength_T = 0.0;
            const Eigen::Matrix3d rotation = estimator->solve(
                models::correctedReadings_T(board.calibration, sample.readings_T, sample.coilCurrent_A),
                strength_T);
            off_rad.push_back(models::symmetricError_rad(rotation, motion.recorded[n]));
        }
    }
    if (off_rad.empty()) {
        return std::nullopt;
    }
    const auto middle = off_rad.begin() + static_cast<std::ptrdiff_t>(off_rad.size() / 2);
    std::nth_element(off_rad.begin(), middle, off_rad.end());
    if (*middle < OtherOrientation_rad) {
        return std::nullopt;
    }
    return Finding{
        "references_do_not_fit",
        fmt::format("the known orientations differ from those of the readings by {:.0f} degrees "
                    "(median)",
                    radiansToDegrees(*middle)),
        "Check their unit, the order of the rotations (Z, then Y, then X of the stator), their time "
        "base and the placement of the sensors."};
}

} // namespace

std::optional<Finding> contradictingReadings(const SensedMotion& motion, const SensingBoard& board) {
    if (!motion.recorded.empty() && shareOfExpected(motion, board) < ReversedShare) {
        return reversedFinding(
            fmt::format("all readings have the opposite sign of those that {}.alpha, .beta "
                        "and .gamma tell: their sign, or that of q, is reversed",
                        motion.recordedBy));
    }
    if (auto found = reversalWithoutOrientations(motion, board)) {
        return found;
    }
    return motion.hasReference ? otherReferences(motion, board) : std::nullopt;
}

} // namespace halbench::app
