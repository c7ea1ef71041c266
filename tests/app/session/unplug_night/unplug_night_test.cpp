#include "tests/app/session/unplug_lines.h"

namespace halbench::app {
namespace {

constexpr int Cycles = 100;

TEST_F(UnplugLines, tcpIsUnpluggedAHundredTimes) {
    runTcp(Cycles);
}

TEST_F(UnplugLines, udpIsUnpluggedAHundredTimes) {
    runUdp(Cycles);
}

TEST_F(UnplugLines, aSerialLineIsUnpluggedAHundredTimes) {
    runSerial(Cycles);
}

} // namespace
} // namespace halbench::app
