#include "app/batch/coil_documents.h"

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

} // namespace
} // namespace halbench::app
