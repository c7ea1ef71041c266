#include "tests/app/session/kill_recording.h"

namespace halbench::app {
namespace {

TEST_F(KillRecording, whatWasWrittenIsThereAfterAHundredKills) {
    killTimes(100, 40000); // four seconds of 32 signals at 10 kHz: several flushes
}

} // namespace
} // namespace halbench::app
