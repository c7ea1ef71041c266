#include "app/procedures/base/coil_temperature_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

constexpr double Limit_degC = 80.0;

devices::Catalogue motor() {
    devices::Catalogue catalogue;
    for (const char* name : {"coil_temperature.a", "coil_temperature.b", "current.a", "current.b"}) {
        SignalSpec spec;
        spec.name = spec.role = name;
        catalogue.signals.push_back(spec);
    }
    return catalogue;
}

using Samples = std::vector<control::TimedValue>;

/// So many seconds at 10 Hz of coil A at a constant current, from 25 degC: C 32 J/K, 1.5 ohm, with the noise
/// of a sensor (a fixed sequence, no shape in time).
Samples temperatures(double seconds, double current_A) {
    Samples samples;
    for (int row = 0; row < std::lround(10.0 * seconds); ++row) {
        const double time_s = 0.1 * row;
        const double noise_K = 0.05 * std::sin(12.9898 * row * row);
        samples.push_back({time_s, 25.0 + 1.5 * current_A * current_A / 32.0 * time_s + noise_K, false});
    }
    return samples;
}

Samples constant(double value, double begin_s, double end_s, double period_s) {
    Samples samples;
    for (double time_s = begin_s; time_s < end_s; time_s += period_s) {
        samples.push_back({time_s, value, false});
    }
    return samples;
}

TEST(CoilTemperatureMonitor, currentsOfAnotherStreamOrRateAreThoseOfTheTemperatures) {
    const Samples same = constant(3.0, 0.0, 60.0, 0.1);
    Samples lateStart = constant(3.0, 0.95, 60.0, 0.1); // the temperature was streamed alone at first
    for (const Samples& currents :
         {same, lateStart, constant(3.0, 0.0, 60.0, 0.001), constant(3.0, -5.0, 70.0, 0.03)}) {
        CoilTemperatureMonitor watch(motor());
        watch.add(0, temperatures(60.0, 3.0), currents);
        const auto telling = watch.tellingForecasts(Limit_degC);
        ASSERT_EQ(telling.size(), 1U) << currents.size();
        EXPECT_GT(telling[0].forecast.stretch_s, 50.0);
        // 13.5/32 K/s from 25 degC: 55 K after 130.4 s, 71.9 s behind the newest whole second (58 to 59 s),
        // give or take half of that second
        ASSERT_EQ(telling[0].forecast.verdict, control::LimitForecast::Verdict::Reached);
        EXPECT_LT(telling[0].forecast.interval95_s->first, 72.4);
        EXPECT_GT(telling[0].forecast.interval95_s->second, 71.4);
    }
}

TEST(CoilTemperatureMonitor, nothingIsToldOfCoilsThatAreColdOrWhoseLoadIsNotKnown) {
    CoilTemperatureMonitor idle(motor());
    idle.add(0, temperatures(600.0, 0.0), constant(0.0, 0.0, 600.0, 0.1));
    idle.add(1, temperatures(600.0, 0.0), constant(0.02, 0.0, 600.0, 0.1));
    EXPECT_TRUE(idle.tellingForecasts(Limit_degC).empty());
    EXPECT_EQ(idle.forecasts(Limit_degC).size(), 2U);
    CoilTemperatureMonitor unknown(motor());
    unknown.add(0, temperatures(60.0, 3.0), Samples());
    EXPECT_TRUE(unknown.tellingForecasts(Limit_degC).empty());
    CoilTemperatureMonitor early(motor());
    early.add(0, temperatures(10.0, 3.0), constant(3.0, 0.0, 10.0, 0.1));
    EXPECT_TRUE(early.tellingForecasts(Limit_degC).empty()) << "not 20 s of it yet";
    CoilTemperatureMonitor hot(motor());
    hot.add(0, constant(80.5, 0.0, 5.0, 0.1), constant(0.0, 0.0, 5.0, 0.1));
    EXPECT_EQ(hot.tellingForecasts(Limit_degC).size(), 1U) << "at its limit, whatever its load is";
}

} // namespace
} // namespace halbench::app
