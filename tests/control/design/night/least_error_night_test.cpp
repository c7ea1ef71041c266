// A hundred motors drawn over all dampings, delays and bounds.
#include "tests/control/design/least_error_search.h"

#include <gtest/gtest.h>

namespace halbench::control {
namespace {

TEST(LeastErrorAtNight, ofAHundredMotorsIsTheLeast) {
    Random random(20);
    const auto share = [&random] { return random.uniform(); };
    for (int i = 0; i < 100; ++i) {
        const PositionPlant plant{0.1 * std::pow(2000.0, share()), 1.0 * std::pow(5000.0, share()), 0.1};
        const LoopTiming timing{share() < 0.2 ? 0.002 : 0.01, static_cast<int>(3.0 * share())};
        const LeastErrorTargets targets{
            share() < 0.5 ? ErrorMeasure::Iae : ErrorMeasure::Itae, 1.15 + 1.8 * share(), {}};
        const auto design = designLeastError(plant, timing, targets, 4.0);
        ASSERT_TRUE(design) << i << ": " << design.error().message;
        const LeastErrorSearch search(plant, timing, targets);
        // 1 %: what the design says that it finds the least to.
        EXPECT_LE(search.errorOf(design->gains), 1.01 * search.least(8, static_cast<std::uint64_t>(i)))
            << i << ": c/J " << plant.dampingRate_1_s << ", T_s " << timing.period_s << ", delay "
            << timing.delay_samples << ", Ms " << targets.mostMs_ratio;
    }
}

} // namespace
} // namespace halbench::control
