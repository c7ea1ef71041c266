#include "tests/app/session/unplug_lines.h"

namespace halbench::app {
namespace {

/// A few cycles of each line in every run; a hundred at night (unplug_night).
constexpr int Cycles = 5;

TEST_F(UnplugLines, tcpIsUnpluggedInMotionWhileItIsRecorded) {
    runTcp(Cycles);
}

TEST_F(UnplugLines, aBoardWhoseCableIsPulledEndsItsMotionByItself) {
    leaveTcpUnplugged();
}

TEST_F(UnplugLines, udpIsUnpluggedInMotionWhileItIsRecorded) {
    runUdp(Cycles);
}

TEST_F(UnplugLines, aSerialLineIsUnpluggedInMotionWhileItIsRecorded) {
    runSerial(Cycles);
}

} // namespace
} // namespace halbench::app
