#include "control/base/random.h"
#include "control/identify/limit_forecast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

using Verdict = LimitForecast::Verdict;
using Reason = LimitForecast::Reason;

/// One coil at a constant current: C T' = R25 (1 + alpha (T - 25)) I^2 - (T - 25)/R_th, which is linear in T.
struct Coil {
    double square_A2 = 4.0;
    double start_degC = 25.0;
    double tau_s = 480.0;

    double rate_per_s() const { return (1.5 * 0.00393 * square_A2 - 32.0 / tau_s) / 32.0; }
    double slope_K_per_s(double now_degC) const {
        return (1.5 * (1.0 + 0.00393 * (now_degC - 25.0)) * square_A2 - (now_degC - 25.0) * 32.0 / tau_s) /
               32.0;
    }
    double at(double time_s) const {
        const double rate = rate_per_s();
        const double shape = std::abs(rate) < 1e-12 ? time_s : std::expm1(rate * time_s) / rate;
        return start_degC + slope_K_per_s(start_degC) * shape;
    }
    /// The answer in closed form; infinite: never.
    double limitAfter(double now_s, double limit_degC) const {
        const double now_degC = at(now_s);
        const double slope = slope_K_per_s(now_degC);
        const double straight_s = (limit_degC - now_degC) / slope;
        const double share = 1.0 + rate_per_s() * straight_s;
        return slope > 0.0 && share > 0.0 ? std::log(share) / rate_per_s()
                                          : std::numeric_limits<double>::infinity();
    }
};

struct Sensor {
    double step_K = 0.0; ///< 0: none
    double noise_K = 0.0;
};

constexpr double Rate_Hz = 20.0;
constexpr double Limit_degC = 80.0;

ThermalBins measured(const Coil& coil, const Sensor& sensor, double length_s, Random& random) {
    ThermalBins bins;
    for (int row = 0; row <= static_cast<int>(length_s * Rate_Hz); ++row) {
        const double time_s = row / Rate_Hz;
        double value = coil.at(time_s) + sensor.noise_K * random.gaussian();
        value = sensor.step_K > 0.0 ? std::round(value / sensor.step_K) * sensor.step_K : value;
        bins.add(100.0 + time_s, value, std::sqrt(coil.square_A2));
    }
    return bins;
}

LimitForecast forecastOf(const ThermalBins& bins) {
    return forecastLimit(atSteadyLoad(bins.bins()), Limit_degC);
}

struct Tally {
    int cases = 0;
    int decided = 0;
    int wrong = 0;
};

/// A forecast counts from the middle of the newest complete second: half of one and up to another one ago.
constexpr double Age_s = 1.5;

void count(Tally& tally, const LimitForecast& forecast, double truth_s) {
    ++tally.cases;
    const bool isNever = truth_s > LimitForecast::Longest_s;
    if (forecast.verdict == Verdict::Reached) {
        ++tally.decided;
        const auto [low_s, high_s] = *forecast.interval95_s;
        tally.wrong += low_s <= truth_s + Age_s && truth_s <= high_s ? 0 : 1;
    } else if (forecast.verdict == Verdict::NotReached) {
        ++tally.decided;
        tally.wrong += isNever ? 0 : 1;
    } else if (forecast.verdict == Verdict::NotBefore) {
        tally.wrong += *forecast.earliest_s <= truth_s + Age_s ? 0 : 1;
    }
}

Tally tallyOf(const Sensor& sensor, double length_s, Random& random) {
    Tally tally;
    for (int i = 0; tally.cases < 150; ++i) {
        const double taus_s[] = {150.0, 480.0, 900.0};
        const Coil coil{random.uniform() * 13.5 + 0.5, 25.0 + 50.0 * random.uniform(), taus_s[i % 3]};
        if (coil.at(length_s) < Limit_degC - 1.0) {
            count(tally, forecastOf(measured(coil, sensor, length_s, random)),
                  coil.limitAfter(length_s, Limit_degC));
        }
    }
    return tally;
}

TEST(LimitForecast, isRightWithinItsIntervalOrWithheldWhateverTheSensor) {
    Random random(11);
    for (const Sensor& sensor : {Sensor{0.0, 0.0}, Sensor{0.0, 0.05}, Sensor{0.0, 0.3}, Sensor{0.488, 0.0},
                                 Sensor{0.488, 0.05}, Sensor{0.488, 0.3}, Sensor{0.1, 0.05}}) {
        for (const double length_s : {30.0, 120.0, 400.0}) {
            const Tally tally = tallyOf(sensor, length_s, random);
            // 95 % and no less: 5 % of 150 are 7.5, and 12 leave room for chance (1.7 sigma)
            EXPECT_LE(tally.wrong, 0.08 * tally.cases)
                << "step " << sensor.step_K << " noise " << sensor.noise_K << " length " << length_s;
            if (length_s > 100.0) { // and it is of use: two minutes decide most cases, on a stair too
                EXPECT_GT(tally.decided, 0.6 * tally.cases)
                    << "step " << sensor.step_K << " noise " << sensor.noise_K << " length " << length_s;
            }
        }
    }
}

TEST(LimitForecast, aMinuteAtThreeAmperesTellsTheTimeToAFewPerCent) {
    Random random(1);
    const Coil coil{9.0, 25.0, 480.0}; // runs away: no equilibrium at 3 A in one phase of 1.5 ohm
    const LimitForecast forecast = forecastOf(measured(coil, {0.0, 0.05}, 60.0, random));
    ASSERT_EQ(forecast.verdict, Verdict::Reached);
    const double truth_s = coil.limitAfter(60.0, Limit_degC);
    EXPECT_NEAR(*forecast.time_s, truth_s, 0.1 * truth_s);
    EXPECT_LT(forecast.interval95_s->second, 1.3 * forecast.interval95_s->first);
    EXPECT_EQ(*forecast.earliest_s, forecast.interval95_s->first);
}

TEST(LimitForecast, whatSettlesBelowTheLimitNeverReachesItAndSaysWhere) {
    Random random(2);
    const Coil coil{2.0, 25.0, 480.0}; // T_end = 25 + 3 W x 15 K/W / (1 - 0.00393 x 45) = 79.7 degC at 2 A^2
    const LimitForecast near = forecastOf(measured(coil, {0.0, 0.02}, 1500.0, random));
    EXPECT_NE(near.verdict, Verdict::Reached) << "0.3 K below the limit";
    const Coil cooler{1.0, 25.0, 480.0};
    const LimitForecast forecast = forecastOf(measured(cooler, {0.0, 0.02}, 400.0, random));
    ASSERT_EQ(forecast.verdict, Verdict::NotReached);
    const double end_degC = 25.0 + 22.5 / (1.0 - 0.00393 * 22.5);
    ASSERT_TRUE(forecast.final95_degC);
    EXPECT_LE(forecast.final95_degC->first, end_degC);
    EXPECT_GE(forecast.final95_degC->second, end_degC);
}

TEST(LimitForecast, aCoilThatCoolsNeverReachesIt) {
    Random random(3);
    const LimitForecast forecast = forecastOf(measured({0.0, 75.0, 480.0}, {0.488, 0.0}, 120.0, random));
    EXPECT_EQ(forecast.verdict, Verdict::NotReached);
}

TEST(LimitForecast, withholdsWithTheReason) {
    Random random(4);
    EXPECT_EQ(forecastLimit({}, Limit_degC).reason, Reason::TooShort);
    const ThermalBins brief = measured({9.0}, {0.0, 0.1}, 15.0, random);
    EXPECT_EQ(forecastOf(brief).reason, Reason::TooShort);
    EXPECT_NEAR(forecastOf(brief).stretch_s, 15.0, 1.0);
    const ThermalBins flat = measured({0.0, 25.0}, {0.488, 0.0}, 300.0, random);
    EXPECT_EQ(forecastOf(flat).reason, Reason::NoStep) << "a dead sensor looks like this too";
    const ThermalBins hot = measured({0.0, 81.0, 1e6}, {0.0, 0.01}, 5.0, random);
    EXPECT_EQ(forecastOf(hot).verdict, Verdict::AtLimit);
    ThermalBins blown; // a fan goes on and off: no body at a constant load does that
    for (int row = 0; row < 6000; ++row) {
        const double time_s = row / Rate_Hz;
        blown.add(time_s, 50.0 + 3.0 * std::sin(time_s / 20.0) + 0.01 * random.gaussian(), 2.0);
    }
    EXPECT_EQ(forecastOf(blown).reason, Reason::NotFirstOrder);
}

TEST(ThermalBins, onlyTheStretchSinceTheLoadChangedCounts) {
    Random random(5);
    ThermalBins bins;
    for (int row = 0; row < 4000; ++row) {
        const double time_s = row / Rate_Hz;
        bins.add(time_s, 30.0 + 0.01 * time_s, time_s < 150.0 ? 1.0 : 2.0);
    }
    const auto steady = atSteadyLoad(bins.bins());
    EXPECT_GE(steady.front().time_s, 149.0);
    EXPECT_LE(steady.front().time_s, 156.0);
    // a turning motor's current goes up and down within each second
    bins.clear();
    for (int row = 0; row < 4000; ++row) {
        const double time_s = row / Rate_Hz;
        bins.add(time_s, 30.0 + 0.01 * time_s, 2.0 * std::sin(7.0 * time_s));
    }
    EXPECT_EQ(atSteadyLoad(bins.bins()).size(), bins.bins().size());
}

TEST(ThermalBins, aLoadThatIsNotKnownIsNotCalledSteady) {
    ThermalBins bins;
    for (int row = 0; row < 4000; ++row) {
        const double time_s = row / Rate_Hz;
        bins.add(time_s, 30.0 + 0.01 * time_s, time_s < 100.0 ? std::nan("") : 2.0);
    }
    const auto steady = atSteadyLoad(bins.bins());
    ASSERT_FALSE(steady.empty());
    EXPECT_GE(steady.front().time_s, 99.0); // where the current begins to be known
    bins.clear();
    for (int row = 0; row < 4000; ++row) {
        bins.add(row / Rate_Hz, 30.0, std::nan(""));
    }
    EXPECT_TRUE(atSteadyLoad(bins.bins()).empty());
}

TEST(ThermalBins, aGapOrAClockThatRunsBackForgetsAndNoNumberIsPassedOver) {
    ThermalBins bins;
    for (int row = 0; row < 100; ++row) {
        bins.add(0.1 * row, row % 7 == 0 ? std::nan("") : 40.0, std::nan(""));
    }
    ASSERT_EQ(bins.bins().size(), 9U);
    EXPECT_EQ(bins.bins().front().mean_degC, 40.0);
    EXPECT_TRUE(std::isnan(bins.bins().front().square_A2));
    bins.add(20.0, 40.0, 0.0);
    EXPECT_TRUE(bins.bins().empty());
    bins.add(21.5, 40.0, 0.0);
    EXPECT_EQ(bins.bins().size(), 1U);
    bins.add(3.0, 40.0, 0.0);
    EXPECT_TRUE(bins.bins().empty());
    for (int second = 4; second < 3000; ++second) {
        bins.add(second, 40.0, 0.0);
    }
    EXPECT_EQ(bins.bins().size(), ThermalBins::Most) << "bounded";
}

} // namespace
} // namespace halbench::control
