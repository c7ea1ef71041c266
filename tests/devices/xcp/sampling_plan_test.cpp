#include "devices/xcp/a2l.h"
#include "devices/xcp/sampling_plan.h"

#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

std::string signalAt(const char* name, const char* events) {
    return std::string("/begin MEASUREMENT ") + name +
           " \"\" FLOAT32_IEEE NO_COMPU_METHOD 0 0 0 1 ECU_ADDRESS 0\n" + events + "/end MEASUREMENT\n";
}

/// A board with events of 1 kHz and 100 Hz whose signals are bound to one of them, to both, or to none.
BoardDescription board() {
    const std::string fixed = "/begin IF_DATA XCP /begin DAQ_EVENT FIXED_EVENT_LIST ";
    const std::string end = " /end DAQ_EVENT /end IF_DATA ";
    const auto description = parseA2l(
        "ASAP2_VERSION 1 71 /begin PROJECT p \"\" /begin MODULE m \"\"\n"
        "/begin IF_DATA XCP /begin DAQ DYNAMIC 1 2 0 OPTIMISATION_TYPE_DEFAULT ADDRESS_EXTENSION_FREE "
        "IDENTIFICATION_FIELD_TYPE_ABSOLUTE GRANULARITY_ODT_ENTRY_SIZE_DAQ_BYTE 8 NO_OVERLOAD_INDICATION\n"
        "/begin EVENT \"fast\" \"fast\" 0 DAQ 1 1 6 0 /end EVENT\n"
        "/begin EVENT \"slow\" \"slow\" 1 DAQ 1 10 6 0 /end EVENT /end DAQ /end IF_DATA\n" +
        signalAt("quick", (fixed + "EVENT 0" + end).c_str()) +
        signalAt("slow", (fixed + "EVENT 1" + end).c_str()) +
        signalAt("both", (fixed + "EVENT 0 EVENT 1" + end).c_str()) + signalAt("anywhere", "") +
        "/end MODULE /end PROJECT\n");
    EXPECT_TRUE(description) << description.error().message;
    return {*description, std::nullopt};
}

DaqAbility ability() {
    DaqAbility ability;
    ability.hasPrescaler = true;
    return ability;
}

TEST(SamplingPlan, takesTheSlowestEventThatCarriesEverySignal) {
    const auto all = planSampling(board(), ability(), {{"both", "anywhere"}, 50.0});
    ASSERT_TRUE(all) << all.error().message;
    EXPECT_EQ(all->event, 1);
    EXPECT_EQ(all->prescaler, 2);
    const auto fast = planSampling(board(), ability(), {{"both", "quick"}, 50.0});
    ASSERT_TRUE(fast);
    EXPECT_EQ(fast->event, 0);
    EXPECT_EQ(fast->prescaler, 20);
    EXPECT_DOUBLE_EQ(fast->layout->period_s, 0.02);
}

TEST(SamplingPlan, signalsOfDifferentEventsAreRefusedByNameAtAnyRate) {
    for (const double rate_Hz : {1000.0, 100.0, 10.0}) {
        const auto plan = planSampling(board(), ability(), {{"both", "quick", "slow"}, rate_Hz});
        ASSERT_FALSE(plan);
        EXPECT_EQ(plan.error().code, ErrorCode::OutOfRange);
        EXPECT_NE(plan.error().message.find("'slow' (100 Hz)"), std::string::npos) << plan.error().message;
        EXPECT_NE(plan.error().hint.find("of the same event together"), std::string::npos);
    }
}

TEST(SamplingPlan, rateThatNoEventDividesToNamesTheNearest) {
    const auto plan = planSampling(board(), ability(), {{"slow"}, 60.0});
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().hint, "the nearest possible rates: 50 Hz and 100 Hz");
}

} // namespace
} // namespace halbench::devices::xcp
