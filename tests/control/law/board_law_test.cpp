#include "control/assess/friction_cycles.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/law/board_law_run.h"
#include "control/law/filtered_controller.h"
#include "control/law/filtered_delta.h"
#include "tests/control/filtered_example.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

constexpr double Period_s = 0.01;

BoardLawRun<double> running(const FilteredLaw& law, const PositionLaw& extras, double limit_A) {
    const auto board = boardLaw(law, extras, {Period_s, 0}, limit_A);
    EXPECT_TRUE(board);
    return BoardLawRun<double>(*board);
}

// While nothing limits it and nothing is fed forward it is the controller that the loop is judged with.
TEST(BoardLaw, withinItsLimitIsTheJudgedController) {
    auto law = running(filtered(), {}, 1e6);
    auto controller = FilteredController::make(filtered(), Period_s);
    ASSERT_TRUE(controller);
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const double reference_rad = random.gaussian();
        const double angle_rad = random.gaussian();
        ASSERT_EQ(law.step({reference_rad, 0.0, 0.0}, angle_rad), controller->step(reference_rad, angle_rad));
    }
}

// A constant error at the limit: the integral stands still, and the current comes off at once when the error
// turns, where one that had gone on would hold it for as long again.
TEST(BoardLaw, theIntegralWaitsAtTheLimit) {
    constexpr double Limit_A = 2.0;
    FilteredLaw plain;
    plain.gains.proportional = 1.0;
    plain.gains.integral = 50.0;
    plain.filters = {LowPassFilter{200.0, 1}};
    auto law = running(plain, {}, Limit_A);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_LE(law.step({1.0, 0.0, 0.0}, 0.0), Limit_A);
    }
    int samples = 0;
    while (law.step({-1.0, 0.0, 0.0}, 0.0) > -Limit_A && samples < 100) {
        ++samples;
    }
    // From at most 2 A of integral down to -1 A at 0.5 A a sample, and the low-pass's sample or two.
    EXPECT_LT(samples, 10);
}

TEST(BoardLaw, addsWhatIsFedForwardAfterTheFilters) {
    PositionLaw extras;
    extras.inertia_A_s2_rad = 0.1;
    extras.viscous_A_s_rad = 0.2;
    extras.coulomb_A = 0.3;
    extras.coulombSpeed_rad_s = 0.5;
    extras.stictionCurrent_A = 0.7;
    extras.stictionThreshold_rad = 0.01;
    const auto at = [&](const LawReference<double>& reference, double angle_rad) {
        return running(filtered(), extras, 1e6).step(reference, angle_rad) -
               running(filtered(), {}, 1e6).step(reference, angle_rad);
    };
    EXPECT_NEAR(at({0.0, 2.0, 3.0}, 0.0), 0.1 * 3.0 + 0.2 * 2.0 + 0.3, 1e-12);
    EXPECT_NEAR(at({0.0, -0.25, 0.0}, 0.0), -0.2 * 0.25 - 0.3 * 0.5, 1e-12);
    EXPECT_NEAR(at({0.0, 0.0, 0.0}, 0.02), -0.7, 1e-12);
    EXPECT_NEAR(at({0.0, 0.0, 0.0}, 0.005), 0.0, 1e-12);
}

// The balance of a filtered loop against the loop itself, sample by sample with friction: a low-pass turns
// the phase of a loop that came to rest, and it swings.
TEST(BoardLaw, swingsAsTheHarmonicBalancePredicts) {
    constexpr double Limit_A = 4.0;
    const LoopTiming timing{Period_s, 0};
    PositionPlant plant = published();
    plant.breakawayCurrent_A *= 0.1;
    FilteredLaw law;
    law.gains.proportional = 14.0;
    law.gains.integral = 0.1;
    EXPECT_TRUE(frictionCycles(plant, law.gains, timing, Limit_A)->empty());
    law.filters = {LowPassFilter{150.0, 1}};
    const auto cycles = frictionCycles(plant, *deltaController(law, timing.period_s), timing, Limit_A);
    ASSERT_TRUE(cycles);
    ASSERT_EQ(cycles->size(), 2u);
    auto controller = running(law, {}, Limit_A);
    double angle_rad = -1.7, speed_rad_s = 0.0, current_A = 0.0, most = -1e9, least = 1e9;
    int crossings = 0;
    constexpr int Steps = 200; // of a sample, by Euler's method: 5e-5 s against a swing of some 0.3 s
    constexpr double Step_s = Period_s / Steps;
    for (int sample = 0; sample < 4000; ++sample) {
        current_A = controller.step({0.0, 0.0, 0.0}, angle_rad);
        const double before_rad = angle_rad;
        for (int i = 0; i < Steps; ++i) {
            const double friction_A =
                speed_rad_s != 0.0
                    ? std::copysign(plant.breakawayCurrent_A, speed_rad_s)
                    : std::clamp(current_A, -plant.breakawayCurrent_A, plant.breakawayCurrent_A);
            const double next =
                speed_rad_s + Step_s * (plant.accelerationGain_rad_s2_A * (current_A - friction_A) -
                                        plant.dampingRate_1_s * speed_rad_s);
            speed_rad_s = next * speed_rad_s < 0.0 ? 0.0 : next;
            angle_rad += Step_s * speed_rad_s;
        }
        if (sample >= 2000) { // 20 s: what was at the beginning is over
            most = std::max(most, angle_rad);
            least = std::min(least, angle_rad);
            crossings += before_rad < 0.0 && angle_rad >= 0.0 ? 1 : 0;
        }
    }
    // 10 %: what the describing function is good for (friction_cycles.h).
    EXPECT_NEAR(2.0 * (*cycles)[1].amplitude / (most - least), 1.0, 0.1);
    EXPECT_NEAR((*cycles)[1].frequency_rad_s / (2.0 * Pi * crossings / 20.0), 1.0, 0.1);
}

// Second routes: the controller of the loop as roots in z - 1, and the law itself, run on a sine of the angle
// until it has settled.
TEST(BoardLaw, hasTheFrequencyResponseOfItsRun) {
    FilteredLaw law = filtered();
    law.gains.integral = 0.0; // an integral of a sine never settles
    law.proportionalWeight = 1.0;
    const auto board = boardLaw(law, {}, {Period_s, 0}, 1e9);
    const auto controller = deltaController(law, Period_s);
    ASSERT_TRUE(board && controller);
    constexpr int Settled = 4000; // samples; the slowest pole of this law is 0.3
    constexpr int Samples = 20000;
    for (const int periods : {16, 637, 2865, 7958}) { // whole ones: 0.5 to 250 rad/s
        const double w = 2.0 * Pi * periods / (Samples * Period_s);
        EXPECT_LT(std::abs(feedbackResponse(*board, w) / controller->atFrequency(w) - 1.0), 1e-9) << w;
        BoardLawRun<double> run(*board);
        std::complex<double> sum = 0.0;
        for (int k = 0; k < Settled + Samples; ++k) {
            const double x = w * Period_s * k;
            const double current_A = run.step({}, -std::sin(x));
            sum += k < Settled ? 0.0 : current_A * std::polar(1.0, -x);
        }
        const std::complex<double> seen = std::complex<double>(0.0, 2.0 / Samples) * sum;
        EXPECT_LT(std::abs(seen / feedbackResponse(*board, w) - 1.0), 1e-9) << w; // of 20000 roundings
    }
}

TEST(BoardLaw, isTheLawThatItWasMadeOf) {
    const auto board = boardLaw(filtered(), {}, {Period_s, 1}, 4.0);
    ASSERT_TRUE(board);
    const FilteredLaw again = filteredLaw(*board);
    EXPECT_EQ(again.filters, filtered().filters);
    EXPECT_EQ(again.proportionalWeight, filtered().proportionalWeight);
    EXPECT_EQ(again.derivativeWeight, filtered().derivativeWeight);
    EXPECT_EQ(again.gains.filter_s, filtered().gains.filter_s);
    // Notch and low-pass pass a constant as it is.
    EXPECT_NEAR(proportionalAtRest_A_per_rad(*board), filtered().gains.proportional, 1e-9);
}

TEST(BoardLaw, whatIsNoLawIsRefused) {
    FilteredLaw law = filtered();
    law.derivativeWeight = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(boardLaw(law, {}, {Period_s, 0}, 1.0).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(boardLaw(filtered(), {}, {Period_s, 0}, 0.0).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
