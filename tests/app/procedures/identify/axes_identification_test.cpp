#include "app/procedures/identify/axes_identification.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(IdentifyOutcome, hasTheQualityAndTheRecordingOfEitherKind) {
    IdentifyResult motor;
    motor.quality.verdict = Verdict::Doubtful;
    motor.recording.time_s = {0.0, 0.01};
    AxesIdentifyResult platen;
    platen.quality.verdict = Verdict::Refused;
    platen.recording.time_s = {0.0};
    EXPECT_EQ(qualityOf(IdentifyOutcome(motor)).verdict, Verdict::Doubtful);
    EXPECT_EQ(qualityOf(IdentifyOutcome(platen)).verdict, Verdict::Refused);
    EXPECT_EQ(recordingOf(IdentifyOutcome(motor)).rows(), 2U);
    EXPECT_EQ(recordingOf(IdentifyOutcome(platen)).rows(), 1U);
}

} // namespace
} // namespace halbench::app
