#include "control/base/units.h"
#include "models/estimators/angle_decoding.h"
#include "models/sensors/adc.h"
#include "models/sensors/hall_sensor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

constexpr double B0_T = 0.157;
constexpr int Positions = 100000; // incommensurable with the codes; every code is met many times

struct ErrorFigures {
    double rms_deg = 0.0;
    double peak_deg = 0.0;
};

double wrapped_rad(double angle_rad) {
    return std::remainder(angle_rad, 2.0 * Pi);
}

/// Angle -> Hall voltages -> converter -> fields -> angle, over one turn.
ErrorFigures chainError(AngleDecoding method, bool isQuantised) {
    const auto sensors = hallPair(HallConfig{}, 0.0);
    AdcConfig adc;
    adc.isQuantised = isQuantised;
    Random silent(1);
    ErrorFigures figures;
    double squares = 0.0;
    for (int i = 0; i < Positions; ++i) {
        const double psi = 2.0 * Pi * (i + 0.382) / Positions;
        double field_T[2];
        for (std::size_t channel = 0; channel < 2; ++channel) {
            const double sent_V = hallVoltage_V(sensors[channel], psi, 0.0, 25.0, silent);
            field_T[channel] =
                hallFieldOfVoltage_T(sensors[channel], adcVoltage_V(adc, adcCode(adc, sent_V)), 25.0);
        }
        const double error_deg =
            radiansToDegrees(wrapped_rad(decodeAngle_rad(method, field_T[0], field_T[1], B0_T) - psi));
        squares += error_deg * error_deg;
        figures.peak_deg = std::fmax(figures.peak_deg, std::abs(error_deg));
    }
    figures.rms_deg = std::sqrt(squares / Positions);
    return figures;
}

TEST(AngleDecoding, arctangentUndoesTheSensorsExactly) {
    EXPECT_LT(degreesToRadians(chainError(AngleDecoding::Arctangent, false).peak_deg), 1e-12);
}

TEST(AngleDecoding, converterLeavesTheQuotedArctangentError) {
    const ErrorFigures error = chainError(AngleDecoding::Arctangent, true);
    EXPECT_NEAR(error.rms_deg, 0.041, 5e-4);
    // The largest error depends on which angles are visited: the quoted 0.097 is one grid's; half a code in
    // both channels on a diagonal, 0.0713 * sqrt(2) = 0.1008 degrees, is what no grid can exceed.
    EXPECT_GT(error.peak_deg, 0.0965);
    EXPECT_LT(error.peak_deg, 0.1008);
}

TEST(AngleDecoding, straightLineHasTheQuotedSystematicError) {
    const ErrorFigures error = chainError(AngleDecoding::Linear, false);
    EXPECT_NEAR(error.peak_deg, 1.898, 5e-4);
    EXPECT_NEAR(error.rms_deg, 1.361, 5e-4);
}

TEST(AngleDecoding, straightLineErrorRepeatsFourTimesPerTurn) {
    for (const double psi : {0.1, 0.3, 0.7}) {
        const double reference_rad = wrapped_rad(decodeLinear_rad(std::cos(psi), std::sin(psi), 1.0) - psi);
        for (int quarter = 1; quarter < 4; ++quarter) {
            const double turned_rad = psi + 0.5 * Pi * quarter;
            const double error_rad =
                wrapped_rad(decodeLinear_rad(std::cos(turned_rad), std::sin(turned_rad), 1.0) - turned_rad);
            EXPECT_NEAR(error_rad, reference_rad, 1e-14);
        }
    }
}

TEST(AngleDecoding, straightLineSlopeRipplesAsQuoted) {
    const auto slope = [](double psi) {
        const double h = 1e-5;
        return (decodeLinear_rad(std::cos(psi + h), std::sin(psi + h), 1.0) -
                decodeLinear_rad(std::cos(psi - h), std::sin(psi - h), 1.0)) /
               (2.0 * h);
    };
    EXPECT_NEAR(slope(0.0), 1.111, 5e-4);
    EXPECT_NEAR(slope(0.25 * Pi - 1e-4), 0.785, 5e-4);
}

TEST(AngleDecoding, oneConverterCodeIsTheQuotedAngle) {
    const double step_T = 0.390625e-3;
    EXPECT_NEAR(radiansToDegrees(decodeLinear_rad(B0_T, step_T, B0_T)), 0.1583, 5e-5);
    EXPECT_NEAR(radiansToDegrees(decodeArctangent_rad(B0_T, step_T)), 0.1426, 5e-5);
}

TEST(AngleDecoding, tenMilliteslaMoveTheAngleAsQuoted) {
    EXPECT_NEAR(radiansToDegrees(decodeArctangent_rad(B0_T, 10e-3)), 3.64, 5e-3);
    EXPECT_NEAR(radiansToDegrees(decodeLinear_rad(B0_T, 10e-3, B0_T)), 4.05, 5e-3);
}

TEST(AngleDecoding, uncalibratedWorstCasesAreTheQuotedOnes) {
    double offset_deg = 0.0;
    double gain_deg = 0.0;
    for (int i = 0; i < 3600; ++i) {
        const double psi = 2.0 * Pi * i / 3600;
        const double shifted =
            wrapped_rad(decodeArctangent_rad(B0_T * std::cos(psi) + 5.6e-3, B0_T * std::sin(psi)) - psi);
        const double scaled = wrapped_rad(decodeArctangent_rad(1.05 * std::cos(psi), std::sin(psi)) - psi);
        offset_deg = std::fmax(offset_deg, std::abs(radiansToDegrees(shifted)));
        gain_deg = std::fmax(gain_deg, std::abs(radiansToDegrees(scaled)));
    }
    EXPECT_NEAR(offset_deg, 2.04, 5e-3);
    EXPECT_NEAR(gain_deg, 1.40, 5e-3);
}

TEST(AngleDecoding, steadyTorqueCurrentAdvancesTheAngleByItsStrayField) {
    const auto sensors = hallPair(HallConfig{}, 0.0);
    for (const double current_A : {-4.0, -0.5, 1.0, 4.0}) {
        for (const double psi : {-3.0, -1.0, 0.0, 0.4, 2.0}) {
            // The torque current is commutated on the measured angle, which it moves itself: i = I (-sin
            // psi_m, cos psi_m) turns the field by asin(k_s I/B0); on the true angle it is atan. Here the
            // true angle commutates.
            const double iA_A = -current_A * std::sin(psi);
            const double iB_A = current_A * std::cos(psi);
            const double measured_rad =
                decodeArctangent_rad(hallField_T(sensors[0], psi, iA_A), hallField_T(sensors[1], psi, iB_A));
            EXPECT_NEAR(wrapped_rad(measured_rad - psi), std::atan(2.5e-3 * current_A / B0_T), 1e-14);
        }
    }
}

TEST(AngleDecoding, currentAlongTheFieldChangesTheAmplitudeNotTheAngle) {
    const auto sensors = hallPair(HallConfig{}, 0.0);
    for (const double current_A : {-4.0, 4.0}) {
        const double psi = 0.9;
        const double bA_T = hallField_T(sensors[0], psi, current_A * std::cos(psi));
        const double bB_T = hallField_T(sensors[1], psi, current_A * std::sin(psi));
        EXPECT_NEAR(decodeArctangent_rad(bA_T, bB_T), psi, 1e-14);
        EXPECT_NEAR(std::hypot(bA_T, bB_T), B0_T + 2.5e-3 * current_A, 1e-15); // +-10 mT at +-4 A
    }
}

TEST(Unwrap, followsManyTurnsInBothDirections) {
    for (const double step_rad : {0.5, -1.5}) {
        UnwrapState state{0.2};
        double true_rad = 0.2;
        for (int i = 0; i < 1000; ++i) {
            true_rad += step_rad;
            const auto unwrapped =
                unwrap(state, decodeArctangent_rad(std::cos(true_rad), std::sin(true_rad)));
            ASSERT_TRUE(unwrapped.has_value());
            ASSERT_NEAR(*unwrapped, true_rad, 1e-9);
        }
    }
}

TEST(Unwrap, refusesToGuessBeyondAQuarterTurn) {
    UnwrapState state{3.0};
    const auto jumped = unwrap(state, 3.0 + 1.6);
    ASSERT_FALSE(jumped.has_value());
    EXPECT_EQ(jumped.error().code, ErrorCode::Refused);
    EXPECT_EQ(state.unwrapped_rad, 3.0);
    EXPECT_FALSE(unwrap(state, std::nan("")).has_value());
    EXPECT_TRUE(unwrap(state, 3.0 - 1.5).has_value());
}

} // namespace
} // namespace halbench::models
