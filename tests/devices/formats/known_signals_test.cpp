#include "devices/formats/known_signals.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

TEST(KnownSignals, areThoseOfOurBoardInItsUnits) {
    const auto board = openDevice("sim:htm", {});
    ASSERT_TRUE(board) << board.error().message;
    for (const KnownSignal& known : knownSignals()) {
        const SignalSpec* spec = (*board)->catalogue().findSignal(std::string(known.name));
        ASSERT_NE(spec, nullptr) << known.name;
        EXPECT_EQ(spec->unit, known.unit) << known.name;
    }
    for (const SignalSpec& spec : (*board)->catalogue().signals) {
        if (spec.name.rfind("capture.", 0) != 0) { // of the board's own capture, not of its motion
            EXPECT_EQ(unitOfKnownSignal(spec.name), spec.unit) << spec.name;
        }
    }
}

TEST(KnownSignals, temperaturesAreToldByTheirNames) {
    for (const char* name : {"temp", "Temp_1", "coil_temp", "MotorTemp", "temperature", "Wickeltemperatur"}) {
        EXPECT_TRUE(isTemperatureName(name)) << name;
    }
    for (const char* name : {"position", "template", "tempo", "attempts", ""}) {
        EXPECT_FALSE(isTemperatureName(name)) << name;
    }
}

TEST(KnownSignals, anyOtherNameHasNoUnit) {
    EXPECT_FALSE(unitOfKnownSignal("angle"));
    EXPECT_FALSE(unitOfKnownSignal(""));
}

} // namespace
} // namespace halbench::devices
