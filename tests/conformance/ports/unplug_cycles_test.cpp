#include "tests/conformance/ports/unplug_cycles.h"

namespace halbench::app {
namespace {

/// A few cycles in every run; a hundred at night (ports_night).
constexpr int Cycles = 5;

TEST_F(UnplugPorts, usbBulkIsUnpluggedInMotionWhileItIsRecorded) {
    runBulk(Cycles);
}

TEST_F(UnplugPorts, hidIsUnpluggedInMotionWhileItIsRecorded) {
    runHid(Cycles);
}

} // namespace
} // namespace halbench::app
