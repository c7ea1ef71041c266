#include "app/documents/coil_documents.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

using Forecast = control::LimitForecast;

CoilForecast coilOf(const char* signal, Forecast::Verdict verdict, std::optional<double> earliest_s = {}) {
    CoilForecast coil{signal, {}};
    coil.forecast.verdict = verdict;
    coil.forecast.now_degC = 40.0;
    coil.forecast.limit_degC = 80.0;
    coil.forecast.stretch_s = 60.0;
    coil.forecast.earliest_s = earliest_s;
    return coil;
}

TEST(CoilDocuments, whatIsKnownIsThereAndTheRestIsNull) {
    CoilForecast reached = coilOf("a", Forecast::Verdict::Reached, 90.0);
    reached.forecast.time_s = 100.0;
    reached.forecast.interval95_s = {90.0, 120.0};
    CoilForecast withheld = coilOf("b", Forecast::Verdict::Withheld);
    withheld.forecast.reason = Forecast::Reason::NoStep;
    const JsonValue list = toJson({reached, withheld});
    ASSERT_EQ(list.items().size(), 2U);
    const JsonValue& first = list.items()[0];
    EXPECT_EQ(first.find("verdict")->text(), "reached");
    EXPECT_EQ(first.find("ci95_s")->items()[1].number(), 120.0);
    EXPECT_TRUE(first.find("reason")->isNull());
    EXPECT_TRUE(first.find("final_ci95_degC")->isNull());
    const JsonValue& second = list.items()[1];
    EXPECT_EQ(second.find("reason")->text(), "no_step");
    for (const char* key : {"time_s", "ci95_s", "earliest_s"}) {
        EXPECT_TRUE(second.find(key)->isNull()) << key;
    }
    EXPECT_EQ(coilLine({withheld, reached}), "a reaches 80 degC in 100 s at this load (95 %: 90 to 120 s)");
}

TEST(CoilDocuments, theMostUrgentIsSaid) {
    const CoilForecast later = coilOf("a", Forecast::Verdict::NotBefore, 500.0);
    const CoilForecast sooner = coilOf("b", Forecast::Verdict::NotBefore, 50.0);
    const CoilForecast hot = coilOf("c", Forecast::Verdict::AtLimit);
    const CoilForecast cool = coilOf("d", Forecast::Verdict::NotReached);
    const CoilForecast unknown = coilOf("e", Forecast::Verdict::Withheld);
    EXPECT_EQ(coilLine({later, sooner}).substr(0, 42), "b does not reach 80 degC for 50 s at this ");
    EXPECT_EQ(coilLine({sooner, hot}), "c is at its limit of 80 degC");
    EXPECT_EQ(coilLine({cool}), "");
    const std::vector<CoilForecast> both = {cool, unknown};
    EXPECT_EQ(mostUrgent(both)->signal, "e") << "what is not known before what is cool";
    EXPECT_EQ(mostUrgent({}), nullptr);
}

/// A board of somebody: other names, the same roles; coil B has no current.
devices::Catalogue foreignMotor() {
    devices::Catalogue catalogue;
    for (const auto& [name, role] : {std::pair("T_U", "coil_temperature.a"),
                                     std::pair("T_V", "coil_temperature.b"), std::pair("i_U", "current.a")}) {
        SignalSpec spec;
        spec.name = name;
        spec.role = role;
        catalogue.signals.push_back(spec);
    }
    return catalogue;
}

TEST(CoilTemperatureMonitor, findsItsSignalsByTheirRolesAndTellsTheWarmingCoil) {
    CoilTemperatureMonitor watch(foreignMotor());
    EXPECT_TRUE(watch.forecasts(80.0).empty()) << "nothing came yet";
    SampleBlock block;
    block.layout = std::make_shared<const StreamLayout>(
        StreamLayout{{{"i_U", "A"}, {"position", "rad"}, {"T_V", "degC"}, {"T_U", "degC"}}, 0.1});
    for (int row = 0; row < 600; ++row) {
        const double flicker_K = row % 2 == 0 ? 0.01 : -0.01;
        block.time_s.push_back(0.1 * row);
        block.values.insert(block.values.end(), {2.0, 0.0, 30.0 + flicker_K, 30.0 + 0.02 * row + flicker_K});
    }
    watch.take(block); // 0.2 K/s from 30 to 42 degC: 38 K more take 190 s on a straight line
    const std::vector<CoilForecast> forecasts = watch.forecasts(80.0);
    ASSERT_EQ(forecasts.size(), 2U);
    EXPECT_EQ(mostUrgent(forecasts)->signal, "T_U");
    ASSERT_EQ(forecasts[0].forecast.verdict, Forecast::Verdict::Reached);
    EXPECT_NEAR(*forecasts[0].forecast.time_s, 190.0, 10.0);
    EXPECT_NE(forecasts[1].forecast.verdict, Forecast::Verdict::Reached);
    EXPECT_TRUE(CoilTemperatureMonitor(devices::Catalogue()).forecasts(80.0).empty());
}

} // namespace
} // namespace halbench::app
