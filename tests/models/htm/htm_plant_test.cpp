#include "control/base/units.h"
#include "models/htm/htm_plant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

HtmPlant plant(const HtmParameters& parameters, std::uint64_t seed = 1) {
    auto made = HtmPlant::make(parameters, seed);
    EXPECT_TRUE(made);
    return std::move(*made);
}

// What the board computes from the codes, with exact temperatures of 25 degC.
double field_T(const HtmParameters& p, double code) {
    return ((code + 0.5) * 5.0 / 1024.0 - p.hallQuiescent_V) / p.hallSensitivity_V_per_T;
}

double measuredAngle_rad(HtmPlant& motor) {
    const HtmReadings readings = motor.read();
    return std::atan2(field_T(motor.parameters(), readings.hallCode[1]),
                      field_T(motor.parameters(), readings.hallCode[0]));
}

HtmDrive driveAt(double amplitude_A, double angle_rad, double axis_rad = 0.0) {
    const auto code = [](double current_A) { return 2048.0 + current_A / 2.0 * 4096.0 / 5.0; };
    HtmDrive drive;
    drive.amplitude_A = amplitude_A;
    drive.dacCode = {code(-amplitude_A * std::sin(angle_rad - axis_rad)),
                     code(amplitude_A * std::cos(angle_rad - axis_rad))};
    return drive;
}

TEST(HtmPlant, sameSeedGivesTheSameBitsAndAnotherSeedOthers) {
    HtmPlant first = plant(HtmParameters{}, 5);
    HtmPlant second = plant(HtmParameters{}, 5);
    HtmPlant other = plant(HtmParameters{}, 6);
    bool differs = false;
    for (int i = 0; i < 2000; ++i) {
        for (HtmPlant* motor : {&first, &second, &other}) {
            motor->drive(driveAt(3.0, motor->truth().rotor.angle_rad));
            motor->advance(4);
        }
        const HtmReadings a = first.read();
        const HtmReadings b = second.read();
        ASSERT_EQ(a.hallCode, b.hallCode);
        ASSERT_EQ(first.truth().rotor.angle_rad, second.truth().rotor.angle_rad);
        differs = differs || a.hallCode != other.read().hallCode;
    }
    EXPECT_TRUE(differs);
}

TEST(HtmPlant, idealChainReadsTheExactAngle) {
    for (double angle_rad = -3.1; angle_rad < 3.1; angle_rad += 0.173) {
        HtmParameters p;
        p.initialAngle_rad = angle_rad;
        HtmPlant motor = plant(withIdealChain(p));
        EXPECT_NEAR(measuredAngle_rad(motor), angle_rad, 1e-12); // rounding of codes of about 500
    }
}

TEST(HtmPlant, quantisationAloneGivesThePublishedAngleError) {
    // Section 7.4: 0.041 deg rms, property 6: at most 0.097 deg.
    double square = 0.0;
    double worst_deg = 0.0;
    const int count = 3600;
    for (int i = 0; i < count; ++i) {
        HtmParameters p;
        p.initialAngle_rad = 2.0 * Pi * i / count - Pi + 1e-3;
        HtmPlant motor = plant(withoutImperfections(p));
        const double error_deg =
            radiansToDegrees(std::remainder(measuredAngle_rad(motor) - p.initialAngle_rad, 2.0 * Pi));
        square += error_deg * error_deg;
        worst_deg = std::fmax(worst_deg, std::fabs(error_deg));
    }
    EXPECT_NEAR(std::sqrt(square / count), 0.041, 0.002);
    EXPECT_LT(worst_deg, 0.1);
}

TEST(HtmPlant, strayFieldTurnsTheAngleByTorqueCurrentOnly) {
    // Property 7: atan(k_s I/B0) for a torque current, 0 for a pure d-axis current (quantisation 0.1 deg).
    HtmParameters p = withoutImperfections(HtmParameters{});
    p.stray_T_per_A = 2.5e-3;
    p.coulombFriction_Nm = 1.0; // holds the rotor
    p.initialAngle_rad = 0.7;
    HtmPlant torque = plant(p);
    torque.drive(driveAt(4.0, 0.7));
    torque.advance(40);
    EXPECT_NEAR(radiansToDegrees(measuredAngle_rad(torque) - 0.7), 3.64, 0.1);
    HtmPlant direct = plant(p);
    direct.drive(driveAt(4.0, 0.7, Pi / 2.0)); // I_A = I cos psi, I_B = I sin psi
    direct.advance(40);
    EXPECT_NEAR(direct.truth().current_A[0], 4.0 * std::cos(0.7), 0.01);
    EXPECT_NEAR(radiansToDegrees(measuredAngle_rad(direct) - 0.7), 0.0, 0.1);
    EXPECT_NEAR(direct.truth().torque_Nm, 0.0, 1e-9);
}

TEST(HtmPlant, reachesTheSteadySpeedWhenCommutatedEveryMillisecond) {
    // 1 kHz commutation with the true angle: mean lag of half a millisecond plus 0.3 ms of amplifier.
    HtmPlant motor = plant(withoutImperfections(HtmParameters{}));
    for (int tick = 0; tick < 10000; ++tick) {
        motor.drive(driveAt(4.0, motor.truth().rotor.angle_rad));
        motor.advance(4);
    }
    EXPECT_NEAR(radPerSecondToRpm(motor.truth().rotor.speed_rad_s), 284.8, 0.2); // section 3.8
}

TEST(HtmPlant, staysBitIdenticalAtRestBelowBreakaway) {
    HtmPlant motor = plant(HtmParameters{});
    const double before_rad = motor.truth().rotor.angle_rad;
    motor.drive(driveAt(1.2, before_rad));
    motor.advance(4000);
    EXPECT_EQ(motor.truth().rotor.angle_rad, before_rad);
    EXPECT_EQ(motor.truth().rotor.speed_rad_s, 0.0);
}

TEST(HtmPlant, heldFourAmperesInOnePhaseReachTheLimitInTheDerivedTime) {
    HtmParameters p = withoutImperfections(HtmParameters{});
    p.thermalAcceleration_ratio = 1.0;
    p.coulombFriction_Nm = 1.0;
    HtmPlant motor = plant(p);
    motor.drive(driveAt(4.0, 0.0)); // all of it in phase b
    int milliseconds = 0;
    while (motor.truth().coil_degC[1] < 80.0) {
        motor.advance(4);
        ++milliseconds;
    }
    EXPECT_NEAR(milliseconds / 1000.0, 71.0, 0.5); // section 9, printed to a second
    EXPECT_NEAR(motor.truth().coil_degC[0], 25.0, 0.01);
}

TEST(HtmPlant, staysFiniteAtBothEndsOfEveryParameter) {
    for (const HtmParameterSpec& spec : htmParameterSpecs()) {
        for (const double value : {spec.min, spec.max}) {
            HtmParameters p;
            ASSERT_TRUE(setHtmParameter(p, spec.key, value));
            HtmPlant motor = plant(p);
            for (int ms = 0; ms < 500; ++ms) {
                motor.drive(driveAt(4.0, motor.truth().rotor.angle_rad));
                motor.advance(4);
                const HtmReadings readings = motor.read();
                for (std::size_t i = 0; i < 2; ++i) {
                    ASSERT_GE(readings.hallCode[i], 0.0) << spec.key; // also refuses what is no number
                    ASSERT_LE(readings.hallCode[i], 1023.0) << spec.key;
                    ASSERT_GE(readings.temperatureCode[i], 0.0) << spec.key;
                    ASSERT_LE(readings.temperatureCode[i], 1023.0) << spec.key;
                    ASSERT_TRUE(std::isfinite(motor.truth().current_A[i])) << spec.key;
                }
                ASSERT_TRUE(std::isfinite(motor.truth().rotor.angle_rad)) << spec.key;
            }
        }
    }
}

TEST(HtmPlant, frictionIsDrawnAnewAtEachStartFromRest) {
    HtmParameters p = withoutImperfections(HtmParameters{});
    p.frictionScatter_ratio = 0.033;
    HtmPlant motor = plant(p);
    double sum = 0.0;
    double square = 0.0;
    const int starts = 400;
    for (int i = 0; i < starts; ++i) {
        motor.drive(driveAt(2.5, motor.truth().rotor.angle_rad));
        motor.advance(80);
        ASSERT_NE(motor.truth().rotor.speed_rad_s, 0.0);
        const double scatter = motor.truth().rotor.friction_ratio - 1.0;
        sum += scatter;
        square += scatter * scatter;
        motor.drive(HtmDrive{});
        motor.advance(400);
        ASSERT_EQ(motor.truth().rotor.speed_rad_s, 0.0);
    }
    EXPECT_NEAR(sum / starts, 0.0, 3 * 0.033 / std::sqrt(starts)); // three standard errors
    EXPECT_NEAR(std::sqrt(square / starts), 0.033, 3 * 0.033 / std::sqrt(2.0 * starts));
}

TEST(HtmPlant, refusesAnAmplifierThatIsNone) {
    HtmParameters p;
    p.amplifier.R1_Ohm = -1.0;
    EXPECT_FALSE(HtmPlant::make(p, 1));
}

TEST(HtmSpecimen, spreadsAreThoseOfTheDataSheets) {
    const int count = 600;
    double offset = 0.0;
    double quadrature = 0.0;
    double magnets = 0.0;
    double dac = 0.0;
    for (int seed = 1; seed <= count; ++seed) {
        const HtmSpecimen specimen = drawSpecimen(HtmParameters{}, static_cast<std::uint64_t>(seed));
        offset += std::pow(specimen.hall[0].offset_T, 2);
        quadrature += std::pow(Pi / 2.0 - specimen.hall[1].placement_rad, 2);
        dac += std::pow(specimen.dac[1].gainError_ratio, 2);
        EXPECT_LE(std::fabs(specimen.hall[0].offset_T), 5.6e-3);
        EXPECT_LE(std::fabs(specimen.hall[1].gain_ratio - 1.0), 0.05 + 0.008);
        EXPECT_LE(std::fabs(specimen.dac[0].gainError_ratio), 0.004);
        EXPECT_LE(std::fabs(specimen.dac[0].integralNonLinearity_codes), 2.0);
        EXPECT_LE(std::fabs(specimen.temperature[0].error_K), 2.0);
        double square = 0.0;
        for (int i = 0; i < 64; ++i) {
            square += std::pow(specimen.magnets.angleError_rad(2.0 * Pi * i / 64), 2) / 64;
        }
        magnets += square;
    }
    // A gaussian cut at 2 (2.8) sigma keeps 0.880 (0.992) of its sigma; three standard errors are 9 %.
    EXPECT_NEAR(std::sqrt(offset / count), 0.992 * 2e-3, 0.09 * 2e-3);
    EXPECT_NEAR(std::sqrt(quadrature / count), 0.880 * degreesToRadians(0.5), 0.09 * degreesToRadians(0.5));
    EXPECT_NEAR(std::sqrt(dac / count), 0.880 * 0.002, 0.09 * 0.002);
    EXPECT_NEAR(radiansToDegrees(std::sqrt(magnets / count)), 0.297, 0.03); // root of half the summed squares
}

TEST(HtmSpecimen, writingOneErrorDownLeavesTheOthersAlone) {
    HtmParameters p;
    const HtmSpecimen before = drawSpecimen(p, 9);
    p.hallOffset_T = 1e-3;
    p.quadrature_rad = 0.01;
    p.dacGainError_ratio = 0.0;
    const HtmSpecimen after = drawSpecimen(p, 9);
    EXPECT_EQ(after.hall[0].offset_T, 1e-3);
    EXPECT_EQ(after.hall[1].offset_T, 1e-3);
    EXPECT_EQ(after.hall[0].gain_ratio, before.hall[0].gain_ratio);
    EXPECT_EQ(after.dac[0].integralNonLinearity_codes, before.dac[0].integralNonLinearity_codes);
    EXPECT_EQ(after.temperature[1].error_K, before.temperature[1].error_K);
    EXPECT_EQ(after.magnets.angleError_rad(1.0), before.magnets.angleError_rad(1.0));
}

TEST(HtmSpecimen, writtenGainErrorIsTheRatioOfTheSensors) {
    HtmParameters p;
    for (const double error : {-0.2, 0.05, 0.2}) {
        p.hallGainError_ratio = error;
        const HtmSpecimen specimen = drawSpecimen(p, 1);
        EXPECT_NEAR(specimen.hall[0].gain_ratio / specimen.hall[1].gain_ratio, 1.0 + error, 1e-15);
        EXPECT_NEAR(specimen.hall[0].gain_ratio + specimen.hall[1].gain_ratio, 2.0, 1e-15);
    }
}

TEST(HtmSpecimen, linearityErrorIsACubicShareOfTheField) {
    HtmParameters p = withoutImperfections(HtmParameters{});
    p.hallLinearitySpread_ratio = 0.005;
    const HallConfig bent = drawSpecimen(p, 3).hall[0];
    ASSERT_EQ(bent.harmonics.size(), 2U);
    const double share = 4.0 * bent.harmonics[1].cosine_ratio;
    EXPECT_NE(share, 0.0);
    EXPECT_LE(std::fabs(share), 2.0 * 0.005);
    for (const double psi : {0.0, 0.4, 1.3, 2.6, -2.0}) {
        // B + l (B^3/B0^2 - B): right at zero and at the full field
        const double field_T = 0.157 * std::cos(psi);
        const double expected_T = field_T + share * (std::pow(field_T, 3) / (0.157 * 0.157) - field_T);
        EXPECT_NEAR(hallField_T(bent, psi, 0.0), expected_T, 1e-15);
    }
}

TEST(HtmSpecimen, magnetsWeakenWithAmbientTemperature) {
    HtmParameters p = withoutImperfections(HtmParameters{});
    p.ambient_degC = 35.0;
    const HtmSpecimen warm = drawSpecimen(p, 1);
    EXPECT_NEAR(warm.torqueConstant_Nm_per_A, 1.43e-2 * (1.0 - 0.012), 1e-12);
    EXPECT_NEAR(warm.hall[0].field_T, 0.157 * (1.0 - 0.012), 1e-12);
}

} // namespace
} // namespace halbench::models
