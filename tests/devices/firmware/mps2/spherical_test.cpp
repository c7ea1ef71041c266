#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/orientation_estimator.h"
#include "models/spherical/spherical_calibration.h"
#include "tests/devices/firmware/mps2/spherical_bench.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>

namespace halbench::mps2 {
namespace {

constexpr double Bound_deg = 2e-4; // of the specification, against double precision
constexpr double Budget_instructions = 20000.0;
const std::vector<std::string> Quaternion = {"orientation.w", "orientation.x", "orientation.y",
                                             "orientation.z"};
const std::vector<std::string> Fields = {"field.0.r", "field.0.theta", "field.0.phi",
                                         "field.1.r", "field.1.theta", "field.1.phi",
                                         "field.2.r", "field.2.theta", "field.2.phi"};

/// Gains and offsets that are not nominal, written as one transaction while the rotor turns.
const std::vector<ParameterValue> Calibrated = {
    {"sensor.gain_1", 0.01}, {"sensor.gain_5", -0.02}, {"sensor.offset_3", 1e-3}, {"sensor.turn_2", 0.01}};

struct Turning {
    Recording recording;
    std::size_t switchRow = 0;
    std::vector<double> parameters;
};

Turning turned(Bench& bench, double time_s) {
    Turning result;
    std::vector<std::string> names = Quaternion;
    names.insert(names.end(), Fields.begin(), Fields.end());
    for (const char* name : {"strength", "chi_square", "integrity", "channels_left_out", "status", "fault"}) {
        names.push_back(name);
    }
    bench.record(names, result.recording);
    bench.wait(0.1);
    result.switchRow = result.recording.rows();
    bench.write(Calibrated);
    bench.wait(time_s - 0.1);
    bench.device->stopStream();
    result.parameters = bench.parameters();
    return result;
}

Eigen::Matrix3d rotationAt(const Recording& recording, std::size_t row) {
    Eigen::Quaterniond q;
    q.w() = recording.column(Quaternion[0])[row];
    q.x() = recording.column(Quaternion[1])[row];
    q.y() = recording.column(Quaternion[2])[row];
    q.z() = recording.column(Quaternion[3])[row];
    return q.normalized().toRotationMatrix();
}

double largestAngle_deg(const Recording& one, const Recording& other) {
    double largest = 0.0;
    for (std::size_t row = 0; row < std::min(one.rows(), other.rows()); ++row) {
        largest = std::max(largest, radiansToDegrees(models::symmetricError_rad(rotationAt(one, row),
                                                                                rotationAt(other, row))));
    }
    return largest;
}

/// What double precision finds in the same fields, before the calibration is changed.
double largestErrorToDouble_deg(const Recording& recording, std::size_t rows) {
    models::SensorTriple placement;
    std::size_t sensor = 0;
    for (const models::PlacementAngles& place : models::publishedPlacement()) { // as the board holds it
        placement[sensor++] = {static_cast<float>(place.alpha_rad), static_cast<float>(place.beta_rad),
                               static_cast<float>(place.gamma_rad)};
    }
    models::RotorFieldConfig field;
    field.strength_T = 0.0991864782;
    const models::SphericalCalibration calibration =
        models::nominalCalibration(models::sensorPoses(placement, models::SensorFrames::Zyx, 0.05), field);
    const auto estimator =
        models::OrientationEstimator::make(models::sensingOf(calibration, 1e-4), models::OrientationConfig{});
    EXPECT_TRUE(estimator) << estimator.error().message;
    double largest = 0.0;
    for (std::size_t row = 0; row < rows; ++row) {
        models::SphericalReadings readings;
        for (std::size_t c = 0; c < Fields.size(); ++c) {
            readings[static_cast<Eigen::Index>(c)] = recording.column(Fields[c])[row];
        }
        const models::OrientationEstimate exact =
            estimator->estimate(models::correctedReadings_T(calibration, readings, 0.0));
        largest = std::max(largest, radiansToDegrees(models::symmetricError_rad(rotationAt(recording, row),
                                                                                exact.rotation)));
    }
    return largest;
}

TEST(Mps2Spherical, itsOrientationIsThatOfTheHostBuildAndOfDoublePrecisionInEachTick) {
    const auto readings = std::make_shared<Readings>();
    Bench emulated = emulatedBench("spherical", rotorPlant({{4, 200, 1000}}, readings), SphericalLine);
    ASSERT_TRUE(emulated.device);
    const Turning board = turned(emulated, 0.3);
    Bench hostBoard = sphericalHostBench(readings);
    ASSERT_TRUE(hostBoard.device);
    const Turning host = turned(hostBoard, 0.3);

    ASSERT_GT(board.recording.rows(), 290U);
    ASSERT_EQ(board.recording.rows(), host.recording.rows());
    fmt::print("difference to the host's build {:.2g} deg\n",
               largestAngle_deg(board.recording, host.recording));
    EXPECT_LT(largestAngle_deg(board.recording, host.recording), Bound_deg);
    for (const char* name : {"integrity", "channels_left_out", "status", "fault"}) {
        EXPECT_EQ(board.recording.column(name), host.recording.column(name)) << name;
    }
    for (const std::string& name : Fields) { // one product of the code
        EXPECT_EQ(board.recording.column(name), host.recording.column(name)) << name;
    }
    EXPECT_EQ(board.parameters, host.parameters);
    const double error_deg = largestErrorToDouble_deg(board.recording, board.switchRow);
    fmt::print("difference to double precision {:.2g} deg\n", error_deg);
    EXPECT_LT(error_deg, Bound_deg);

    // The rotor turned, the calibration changed what it shows, and the clipped channel was left out.
    EXPECT_GT(radiansToDegrees(models::symmetricError_rad(rotationAt(board.recording, 0),
                                                          rotationAt(board.recording, board.switchRow))),
              5.0);
    EXPECT_EQ(board.recording.column("channels_left_out").back(), 16.0);
}

TEST(Mps2Spherical, theLongestTickTakesAtMostTwentyThousandInstructions) {
    const auto readings = std::make_shared<Readings>();
    Bench emulated =
        emulatedBench("spherical", rotorPlant({{4, 150, 200}, {0, 170, 190}}, readings), SphericalLine);
    ASSERT_TRUE(emulated.device);
    emulated.write({{"capture.signal_1", 0.0},
                    {"capture.signal_2", 1.0},
                    {"capture.signal_3", 2.0},
                    {"capture.signal_4", 3.0},
                    {"capture.start", 1.0}});
    std::vector<std::string> names;
    for (const SignalSpec& signal : emulated.device->catalogue().signals) {
        names.push_back(signal.name);
    }
    Recording recording;
    emulated.record(names, recording);
    emulated.wait(0.1);
    emulated.write(Calibrated);
    emulated.wait(0.15);
    const TickCosts& costs = emulated.emulated->costs();
    fmt::print("tick: longest {:.0f} instructions of {:.0f}, mean {:.0f} of {} ticks\n",
               costs.worst_instructions, Budget_instructions,
               costs.total_instructions / static_cast<double>(costs.count), costs.count);
    EXPECT_LE(costs.worst_instructions, Budget_instructions);
    EXPECT_EQ(recording.lostRows, 0U);
}

} // namespace
} // namespace halbench::mps2
