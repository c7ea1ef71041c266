#include "tests/app/session/kill_recording.h"

namespace halbench::app {
namespace {

TEST_F(KillRecording, whatWasWrittenIsThereAfterAKillAtAnyMoment) {
    killTimes(6, 4000);
}

} // namespace
} // namespace halbench::app
