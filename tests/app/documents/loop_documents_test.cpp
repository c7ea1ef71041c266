#include "app/documents/result_documents.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

/// The published motor; help: htm-theory.md 2.
MotorEstimate published() {
    return {{{"c_over_J", 2.2364}, {"Kf_over_J", 37.27}, {"phi_over_J", 26.0}}, {}, {}};
}

// A window compares and keeps documents where it draws: none may begin to compute there.
TEST(LoopDocuments, theProofIsThatOfTheResultAndIsNotComputedAnew) {
    TuneConfig config;
    auto result = runTune(published(), config);
    ASSERT_TRUE(result) << result.error().message;
    const JsonValue body = gainsBody(*result);
    EXPECT_EQ(body.find("proof")->find("noise_gain_A_per_rad")->number(),
              result->assessment->noiseGain_A_per_rad);
    result->assessment.reset();
    EXPECT_FALSE(gainsBody(*result).find("proof")->isObject());
}

} // namespace
} // namespace halbench::app
