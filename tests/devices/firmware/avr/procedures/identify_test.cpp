#include "app/procedures/identify_procedure.h"
#include "devices/open_device.h"
#include "tests/devices/firmware/avr/avr_fixture.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::simavr {
namespace {

struct Named {
    const char* name;
    const control::Estimate& onProcessor;
    const control::Estimate& simulated;
    double truth;
};

TEST(AvrIdentify, findsTheSameMotorAsTheSimulatedBoardWithinTheIntervals) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    const auto sim = devices::openDevice("sim:htm?imperfections=off&stray_mT_per_A=2.5", {});
    ASSERT_TRUE(sim) << sim.error().message;
    app::IdentifyConfig config;
    config.given.inertia_kg_m2 = 5.5e-4;
    const auto onProcessor = app::runIdentify(*bench.device, config, {});
    ASSERT_TRUE(onProcessor) << onProcessor.error().message << " " << onProcessor.error().hint;
    const auto simulated = app::runIdentify(**sim, config, {});
    ASSERT_TRUE(simulated) << simulated.error().message;
    // Commutation at the processor's rate bends the sweep by less than its intervals, but with little noise
    // that can be told: then the verdict says so, and nothing worse.
    for (const app::Finding& finding : onProcessor->quality.findings) {
        const bool isExpected = finding.code == "residuals_in_runs" || finding.code == "plateaus_too_slow" ||
                                finding.code == "plateaus_not_steady";
        EXPECT_TRUE(isExpected) << finding.code << ": " << finding.message;
    }
    EXPECT_NE(onProcessor->quality.verdict, app::Verdict::Refused);
    for (const Named& each :
         {Named{"c", onProcessor->viscousDamping, simulated->viscousDamping, 1.23e-3},
          Named{"K_f", onProcessor->coulombFriction, simulated->coulombFriction, 2.05e-2},
          Named{"phi", onProcessor->torqueConstant, simulated->torqueConstant, 1.43e-2}}) {
        ASSERT_TRUE(each.onProcessor.interval95 && each.simulated.interval95) << each.name;
        const auto [low, high] = *each.onProcessor.interval95;
        const auto [simLow, simHigh] = *each.simulated.interval95;
        fmt::print("{}: processor {:.5g} ({:.5g}..{:.5g}), simulated {:.5g} ({:.5g}..{:.5g}), truth {:.5g}\n",
                   each.name, *each.onProcessor.value, low, high, *each.simulated.value, simLow, simHigh,
                   each.truth);
        EXPECT_LE(low, simHigh) << each.name;
        EXPECT_GE(high, simLow) << each.name;
        EXPECT_LE(low, each.truth) << each.name;
        EXPECT_GE(high, each.truth) << each.name;
    }
}

} // namespace
} // namespace halbench::simavr
