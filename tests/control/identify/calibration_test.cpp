#include "control/base/distributions.h"
#include "control/base/random.h"
#include "control/identify/calibration_fits.h"
#include "control/identify/ellipse_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace halbench::control {
namespace {

constexpr double Degree = M_PI / 180.0;
const HallEllipse Perfect{0.0, 0.0, 1.0, 0.0, 0.157};

struct Readings {
    std::vector<double> a;
    std::vector<double> b;
};

Readings turn(const HallEllipse& truth, double noise_T, int samples = 800) {
    Random random(1);
    Readings readings;
    for (int i = 0; i < samples; ++i) {
        const double angle = 0.0837 * i;
        readings.a.push_back(truth.offsetA_T + truth.amplitude_T * std::cos(angle) +
                             noise_T * random.gaussian());
        readings.b.push_back(truth.offsetB_T +
                             truth.amplitude_T * truth.gain_ratio * std::sin(angle + truth.quadrature_rad) +
                             noise_T * random.gaussian());
    }
    return readings;
}

double worstError(const HallEllipse& calibration, const HallEllipse& truth) {
    double worst = 0.0;
    for (int i = 0; i < 3600; ++i) {
        const double angle = i * 0.1 * Degree;
        const double a = truth.offsetA_T + truth.amplitude_T * std::cos(angle);
        const double b =
            truth.offsetB_T + truth.amplitude_T * truth.gain_ratio * std::sin(angle + truth.quadrature_rad);
        worst =
            std::max(worst, std::fabs(std::remainder(hallAngle_rad(calibration, a, b) - angle, 2 * M_PI)));
    }
    return worst;
}

TEST(HallEllipse, returnsTheTruthWithoutNoise) {
    const HallEllipse truth{3e-3, -2e-3, 1.04, 0.5 * Degree, 0.15};
    const Readings readings = turn(truth, 0.0);
    const auto fit = fitHallEllipse(readings.a, readings.b);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->ellipse.offsetA_T, truth.offsetA_T, 1e-12);
    EXPECT_NEAR(fit->ellipse.offsetB_T, truth.offsetB_T, 1e-12);
    EXPECT_NEAR(fit->ellipse.gain_ratio, truth.gain_ratio, 1e-11);
    EXPECT_NEAR(fit->ellipse.quadrature_rad, truth.quadrature_rad, 1e-11);
    EXPECT_NEAR(fit->ellipse.amplitude_T, truth.amplitude_T, 1e-11);
    EXPECT_LT(worstError(fit->ellipse, truth), 1e-10);
}

TEST(HallEllipse, uncalibratedWorstCasesAreThoseOfTheTheory) {
    // resources/help/htm-theory.md section 7.5: 70 mV = 5.6 mT gives 2.04 deg, 5 % of gain 1.40 deg
    HallEllipse offset = Perfect;
    offset.offsetA_T = 5.6e-3;
    EXPECT_NEAR(worstError(Perfect, offset) / Degree, 2.04, 0.01);
    HallEllipse gain = Perfect;
    gain.gain_ratio = 1.05;
    EXPECT_NEAR(worstError(Perfect, gain) / Degree, 1.40, 0.01);
    for (const HallEllipse& truth : {offset, gain}) {
        const Readings readings = turn(truth, 1.1e-4); // one ADC count of 0.39 mT over sqrt(12)
        const auto fit = fitHallEllipse(readings.a, readings.b);
        ASSERT_TRUE(fit);
        // what noise leaves: 1.1e-4/0.157/sqrt(800/5) = 6e-5 rad; three sigma
        EXPECT_LT(worstError(fit->ellipse, truth), 2e-4);
        EXPECT_LT(std::fabs(fit->ellipse.gain_ratio - truth.gain_ratio), 4.0 * fit->error.gain_ratio + 1e-5);
    }
}

TEST(HallEllipse, refusesReadingsThatDoNotGoRound) {
    const Readings few = turn(Perfect, 1e-4, 20);
    EXPECT_FALSE(fitHallEllipse(few.a, few.b));
    const std::vector<double> still(200, 0.1);
    EXPECT_FALSE(fitHallEllipse(still, still));
}

// Readings of a rotor whose angle runs as given.
template <typename Angle>
Readings moving(const HallEllipse& truth, double noise_T, int samples, Angle angle_rad) {
    Random random(3);
    Readings readings;
    for (int i = 0; i < samples; ++i) {
        const double angle = angle_rad(i);
        readings.a.push_back(truth.offsetA_T + truth.amplitude_T * std::cos(angle) +
                             noise_T * random.gaussian());
        readings.b.push_back(truth.offsetB_T +
                             truth.amplitude_T * truth.gain_ratio * std::sin(angle + truth.quadrature_rad) +
                             noise_T * random.gaussian());
    }
    return readings;
}

TEST(HallEllipse, refusesSwingsThatLeavePartOfTheCircleOut) {
    const HallEllipse truth{0.5e-3, -0.3e-3, 0.99, 0.5 * Degree, 0.156};
    for (const double swing_deg : {5.0, 30.0, 80.0, 120.0, 145.0}) {
        for (const double middle_deg : {0.0, 40.0, 200.0}) {
            const Readings readings = moving(truth, 1e-4, 10000, [&](int i) {
                return (middle_deg + swing_deg * std::sin(0.00628 * i)) * Degree;
            });
            EXPECT_FALSE(fitHallEllipse(readings.a, readings.b)) << swing_deg << " about " << middle_deg;
        }
    }
}

TEST(HallEllipse, refusesAFractionOfATurnInEachPart) {
    // Five turns over eight parts: each part holds 225 degrees.
    const Readings slow = moving(Perfect, 1e-4, 8000, [](int i) { return 2.0 * M_PI * 5.0 * i / 8000.0; });
    EXPECT_FALSE(fitHallEllipse(slow.a, slow.b));
    const Readings enough = moving(Perfect, 1e-4, 8000, [](int i) { return 2.0 * M_PI * 9.0 * i / 8000.0; });
    EXPECT_TRUE(fitHallEllipse(enough.a, enough.b));
}

TEST(HallEllipse, refusesNoiseAboutOnePoint) {
    const Readings still = moving(Perfect, 1e-4, 8000, [](int) { return 0.7; });
    EXPECT_FALSE(fitHallEllipse(still.a, still.b));
}

TEST(HallEllipse, intervalsHoldTheTruthInRandomMotions) {
    // 95 % by Student's t: of 300 values (5 in each of 60 motions) at most 15 + 4 sqrt(15) = 30 may lie
    // outside.
    const HallEllipse truth{0.5e-3, -0.3e-3, 0.99, 0.5 * Degree, 0.156};
    Random random(5);
    int outside = 0;
    for (int motion = 0; motion < 60; ++motion) {
        const double speed = 0.01 + 0.1 * random.uniform();
        Readings readings = moving(truth, 0.0, 8000, [&](int i) { return speed * i; });
        for (std::size_t i = 0; i < readings.a.size(); ++i) {
            readings.a[i] += 1e-3 * random.gaussian();
            readings.b[i] += 1e-3 * random.gaussian();
        }
        const auto fit = fitHallEllipse(readings.a, readings.b);
        ASSERT_TRUE(fit);
        const double sigmas = studentQuantile(0.975, fit->parts - 1);
        for (const auto member : {&HallEllipse::offsetA_T, &HallEllipse::offsetB_T, &HallEllipse::gain_ratio,
                                  &HallEllipse::quadrature_rad, &HallEllipse::amplitude_T}) {
            outside += std::fabs(fit->ellipse.*member - truth.*member) > sigmas * fit->error.*member ? 1 : 0;
        }
    }
    EXPECT_LE(outside, 30);
}

TEST(StrayFit, returnsTheSlopeOfBothChannels) {
    Random random(2);
    std::vector<StrayRecord> records;
    for (const double angle : {0.3, 2.0, 4.4}) {
        StrayRecord record;
        for (int level = -8; level <= 8; ++level) {
            const double current = 0.5 * level;
            record.currentA_A.push_back(current * std::cos(angle));
            record.currentB_A.push_back(current * std::sin(angle));
            record.hallA_T.push_back(0.157 * std::cos(angle) + 2.5e-3 * record.currentA_A.back() +
                                     1e-4 * random.gaussian());
            record.hallB_T.push_back(0.157 * std::sin(angle) + 2.5e-3 * record.currentB_A.back() +
                                     1e-4 * random.gaussian());
        }
        records.push_back(record);
    }
    const auto fit = fitStray(records);
    ASSERT_TRUE(fit);
    // 102 readings of 0.1 mT over an rms current of 1.7 A: 6e-6 T/A; three sigma
    EXPECT_NEAR(fit->coefficient_T_per_A, 2.5e-3, 1.8e-5);
    EXPECT_NEAR(fit->error_T_per_A, 6e-6, 2e-6);
    for (StrayRecord& record : records) {
        record.currentA_A.assign(record.currentA_A.size(), 1.0);
        record.currentB_A.assign(record.currentB_A.size(), 1.0);
    }
    EXPECT_FALSE(fitStray(records));
}

TEST(Breakaway, findsTheInstantUnderQuantisedAngle) {
    // ramp 0.6 A/s; breaks loose at 1.6486 A (K_s = 1.15 K_f), then J psi'' = phi I - K_f
    std::vector<double> time;
    std::vector<double> angle;
    std::vector<double> current;
    double speed = 0.0;
    double psi = 1.0;
    for (int i = 0; i < 3500; ++i) {
        const double now = 0.6e-3 * i;
        if (now > 1.15 * 1.43357) {
            speed += 1e-3 * (26.0 * now - 37.2727 - 2.236 * speed);
            psi += 1e-3 * speed;
        }
        if (i % 10 == 0) {
            time.push_back(1e-3 * i);
            current.push_back(now);
            angle.push_back(2.5e-3 * std::round(psi / 2.5e-3));
        }
    }
    const auto start = findBreakaway(time, angle, current);
    ASSERT_TRUE(start);
    // 10 ms of the 100 Hz samples are 6 mA; damping, which the model leaves out, another 6 mA
    EXPECT_NEAR(start->current_A, 1.6486, 0.012);
    const std::vector<double> still(time.size(), 1.0);
    EXPECT_FALSE(findBreakaway(time, still, current));
}

} // namespace
} // namespace halbench::control
