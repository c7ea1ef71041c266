#include "tests/conformance/ports/unplug_cycles.h"

namespace halbench::app {
namespace {

constexpr int Cycles = 100;

TEST_F(UnplugPorts, usbBulkIsUnpluggedAHundredTimes) {
    runBulk(Cycles);
}

TEST_F(UnplugPorts, hidIsUnpluggedAHundredTimes) {
    runHid(Cycles);
}

} // namespace
} // namespace halbench::app
