#include "tests/models/spherical/calibration_runs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

/// Bound of Cramer and Rao at 100 uT.
constexpr double Bound_deg = 0.0286;

TEST(CalibrationUnknowns, derivativesAreThoseOfThePrediction) {
    SphericalCalibration calibration =
        nominalCalibration(sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05),
                           {Q, 0.05, harmonicPreset(HarmonicPreset::H1)});
    calibration.sensors[1].gain_ratio = {1.1, 0.9, 1.05};
    calibration.sensors[1].skew_ratio = {0.02, -0.03, 0.01};
    calibration.drift_per_K = -1e-3;
    CalibrationSelection all;
    all.harmonics = all.skews = all.directions = all.drift = all.coil = true;
    const auto unknowns = calibrationUnknowns(all, calibration);
    EXPECT_EQ(unknowns.size(), 1U + 1U + 4U + 3U * 17U);
    CalibrationSample sample;
    sample.coilCurrent_A = 3.0;
    sample.temperature_degC = 40.0;
    const Eigen::Matrix3d rotation = rotationOf(angles_deg(10, -20, 30));
    const CalibrationPrediction prediction = CalibrationModel(calibration, unknowns).at(rotation, sample);
    const auto readingsOf = [&](const SphericalCalibration& changed, const Eigen::Matrix3d& at) {
        return CalibrationModel(changed, unknowns).at(at, sample).readings_T;
    };
    const double h = 1e-6; // central differences of fields below 1 T: rounding 1e-10, error h^2
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
        Eigen::VectorXd step = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()));
        step[static_cast<Eigen::Index>(k)] = h;
        const SphericalReadings slope =
            (readingsOf(steppedCalibration(calibration, unknowns, step), rotation) -
             readingsOf(steppedCalibration(calibration, unknowns, -step), rotation)) /
            (2.0 * h);
        EXPECT_LT((slope - prediction.byUnknown.col(static_cast<Eigen::Index>(k))).norm(), 2e-9)
            << unknowns[k].name;
    }
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d w = h * Eigen::Vector3d::Unit(k);
        const SphericalReadings slope = (readingsOf(calibration, rotationOfVector(w) * rotation) -
                                         readingsOf(calibration, rotationOfVector(-w) * rotation)) /
                                        (2.0 * h);
        EXPECT_LT((slope - prediction.byRotation.col(k)).norm(), 2e-9);
    }
    // Correction is the inverse of the prediction.
    const SphericalReadings corrected_T = correctedReadings_T(calibration, prediction.readings_T, 3.0);
    const RotorField field(calibration.field);
    SensorPoses poses;
    for (std::size_t i = 0; i < 3; ++i) {
        poses[i] = calibration.sensors[i].pose;
    }
    EXPECT_LT((corrected_T - (1.0 - 0.015) * field.readings_T(rotation, poses)).norm(), 1e-15);
}

TEST(Calibration, unknownOrientationsBringTheErrorBelowTwiceTheNoiseBound) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SphericalPlant plant = *SphericalPlant::make(erroneousDevice(), seed);
        const auto samples = recordedMotion(plant, 600, false);
        EXPECT_GT(calibratedError_deg(plant, nominalOf(plant), 5), 10.0 * Bound_deg);
        const auto fit = calibrate(nominalOf(plant), samples, {});
        ASSERT_TRUE(fit.has_value()) << fit.error().message;
        EXPECT_LT(calibratedError_deg(plant, fit->calibration, 5), 2.0 * Bound_deg);
        // 600 x 9 readings less 1800 orientation angles, 28 unknowns and one gauge.
        EXPECT_EQ(fit->freedom, 5400.0 - 1800.0 - 27.0);
        EXPECT_NEAR(fit->excess_ratio, 1.0, 3.0 / std::sqrt(2.0 * fit->freedom));
        EXPECT_EQ(fit->notes.size(), 1U);
    }
}

TEST(Calibration, knownOrientationsBringItThereToo) {
    SphericalPlant plant = *SphericalPlant::make(erroneousDevice(), 4);
    const auto samples = recordedMotion(plant, 300, true);
    CalibrationConfig config;
    config.selection.directions = true;
    const auto fit = calibrate(nominalOf(plant), samples, config);
    ASSERT_TRUE(fit.has_value()) << fit.error().message;
    EXPECT_LT(calibratedError_deg(plant, fit->calibration, 5), 2.0 * Bound_deg);
    EXPECT_EQ(fit->notes.size(), 1U);
}

TEST(Calibration, harmonicsAreIdentifiedFromMotion) {
    SphericalParameters parameters = erroneousDevice();
    parameters.harmonics = 1.0;
    SphericalPlant plant = *SphericalPlant::make(parameters, 6);
    const auto samples = recordedMotion(plant, 600, false);
    SphericalCalibration nominal = nominalOf(plant);
    for (SphericalHarmonicTerm& term : nominal.field.harmonics) {
        term.amplitude_T = 0.0;
    }
    CalibrationConfig config;
    config.selection.harmonics = true;
    const auto fit = calibrate(nominal, samples, config);
    ASSERT_TRUE(fit.has_value()) << fit.error().message;
    int inside = 0;
    for (const CalibratedValue& value : fit->values) {
        if (value.unknown.kind == CalibrationKind::Harmonic) {
            const double error_T = std::abs(value.value - trueValue(plant, value.unknown));
            EXPECT_LT(error_T, 2.0 * value.half95); // 1e-4 of honest intervals are missed by that much
            EXPECT_LT(value.half95, 2e-4);
            ++inside;
        }
    }
    EXPECT_EQ(inside, 4);
}

TEST(Calibration, driftAndCoilFieldAreIdentified) {
    SphericalParameters parameters = erroneousDevice();
    parameters.warmRise_K = 40.0;
    parameters.warmTime_s = 20.0;
    parameters.temperatureError_K = 0.0;
    SphericalPlant plant = *SphericalPlant::make(parameters, 7);
    std::vector<CalibrationSample> samples = recordedMotion(plant, 200, false);
    plant.setCoilCurrent_A(5.0);
    const auto more = recordedMotion(plant, 200, false);
    samples.insert(samples.end(), more.begin(), more.end());
    CalibrationConfig config;
    config.selection.drift = config.selection.coil = true;
    const auto fit = calibrate(nominalOf(plant), samples, config);
    ASSERT_TRUE(fit.has_value()) << fit.error().message;
    const CurrentLoop coil = statorCoilOf(parameters);
    for (const CalibratedValue& value : fit->values) {
        if (value.unknown.kind == CalibrationKind::Drift) {
            EXPECT_NEAR(value.value, -1.1e-3, 2.0 * value.half95);
            EXPECT_LT(value.half95, 1e-4);
        } else if (value.unknown.kind == CalibrationKind::Coil) {
            const auto i = static_cast<std::size_t>(value.unknown.sensor);
            const SensorPose& pose = plant.specimen().poses[i];
            const double known =
                (pose.axes.transpose() * loopField_T_per_A(coil, pose.position_m))[value.unknown.component] *
                plant.specimen().sensors[i].gain_ratio[value.unknown.component];
            EXPECT_NEAR(value.value, known, 2.0 * value.half95) << value.unknown.name;
        }
    }
}

TEST(Calibration, intervalsHoldTheTruth) {
    // 30 seeds of 28 values; the samples of one kind belong together in part: 92 to 98 % for all.
    IntervalCount all;
    for (const auto& [kind, count] : intervalCounts(30)) {
        all.inside += count.inside;
        all.all += count.all;
    }
    EXPECT_GE(all.ratio(), 0.92);
    EXPECT_LE(all.ratio(), 0.98);
}

TEST(Calibration, refusesMotionThatDoesNotExcite) {
    SphericalParameters parameters = erroneousDevice();
    parameters.motion = 0.0;
    SphericalPlant still = *SphericalPlant::make(parameters, 8);
    const auto resting = calibrate(nominalOf(still), recordedMotion(still, 200, false), {});
    ASSERT_FALSE(resting.has_value());
    EXPECT_EQ(resting.error().code, ErrorCode::Refused);
    EXPECT_NE(resting.error().message.find("moved by only"), std::string::npos);
    // Spin about one axis only.
    parameters.motion = static_cast<double>(MotionKind::Tumble);
    parameters.tilt_rad = degreesToRadians(0.1);
    SphericalPlant spinning = *SphericalPlant::make(parameters, 8);
    const auto spun = calibrate(nominalOf(spinning), recordedMotion(spinning, 200, false), {});
    ASSERT_FALSE(spun.has_value());
    EXPECT_EQ(spun.error().code, ErrorCode::Refused);
    EXPECT_NE(spun.error().message.find("does not determine"), std::string::npos);
    const auto few = calibrate(nominalOf(spinning), recordedMotion(spinning, 10, false), {});
    EXPECT_EQ(few.error().code, ErrorCode::Refused);
    CalibrationConfig config;
    config.deviation_T = 0.0;
    EXPECT_EQ(calibrate(nominalOf(spinning), {}, config).error().code, ErrorCode::OutOfRange);
    config = {};
    config.isStopped = [] { return true; };
    SphericalPlant moving = *SphericalPlant::make(erroneousDevice(), 8);
    EXPECT_EQ(calibrate(nominalOf(moving), recordedMotion(moving, 200, false), config).error().code,
              ErrorCode::Interrupted);
}

TEST(Calibration, tellsWhichOrientationsStillNeedData) {
    SphericalParameters parameters = erroneousDevice();
    parameters.tilt_rad = degreesToRadians(3);
    SphericalPlant plant = *SphericalPlant::make(parameters, 9);
    auto samples = recordedMotion(plant, 100, false);
    const SphericalCalibration nominal = nominalOf(plant);
    const CalibrationExcitation before = *calibrationExcitation(nominal, samples, {});
    // The most wanted of a coarse grid of orientations, once more.
    Eigen::Matrix3d wanted = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d least = Eigen::Matrix3d::Identity();
    double most = -1.0;
    double fewest = HUGE_VAL;
    for (int i = 0; i < 400; ++i) {
        Random random(static_cast<std::uint64_t>(i));
        const Eigen::Matrix3d at = rotationOf(drawn(random));
        const double gain = calibrationGain(nominal, before, {}, at);
        wanted = gain > most ? at : wanted;
        least = gain < fewest ? at : least;
        most = std::max(most, gain);
        fewest = std::min(fewest, gain);
    }
    const auto with = [&](const Eigen::Matrix3d& rotation) {
        auto longer = samples;
        CalibrationSample sample;
        sample.readings_T =
            RotorField(nominal.field)
                .readings_T(rotation, sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05));
        longer.insert(longer.end(), 5, sample);
        return calibrationExcitation(nominal, longer, {})->weakest_ratio;
    };
    EXPECT_LT(with(wanted), 0.9 * before.weakest_ratio);
    EXPECT_GT(with(least), with(wanted));
}

} // namespace
} // namespace halbench::models
