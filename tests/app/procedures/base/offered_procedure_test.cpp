#include "app/procedures/apply/live_apply_procedure.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/procedures/identify/identify_procedure.h"
#include "app/procedures/move/move_procedure.h"
#include "app/procedures/relay/relay_procedure.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

// The platen's modes and windows have the motor's names and another meaning: a sweep of currents would push
// it.
TEST(OfferedProcedure, isAllThatADeviceOfAnotherKindStarts) {
    const auto opened = devices::openDevice("sim:planar", {});
    ASSERT_TRUE(opened);
    devices::Device& device = **opened;
    IdentifyConfig gentle; // within the limits of its parameters
    gentle.sweep = {0.3, 0.9, 0.2};
    const auto refusal = [](const auto& result) { return result ? Error{} : result.error(); };
    // It identifies and calibrates in its own way (app/actuators), not in the motor's.
    for (const Error& error :
         {refusal(runIdentify(device, gentle, {})), refusal(runCalibrate(device, {}, {})),
          refusal(runFrequency(device, {}, {}, {})), refusal(runRelay(device, {}, {}))}) {
        EXPECT_EQ(error.code, ErrorCode::Usage) << error.message;
        EXPECT_NE(error.message.find("needs a freely turning rotor"), std::string::npos) << error.message;
    }
    const Error refusals[] = {refusal(runApply(device, {}, {})), refusal(runLiveApply(device, {}, {}))};
    for (const Error& error : refusals) {
        EXPECT_EQ(error.code, ErrorCode::Usage) << error.message;
        EXPECT_NE(error.message.find("is not available for this device"), std::string::npos) << error.message;
        EXPECT_NE(error.hint.find("move, record"), std::string::npos) << error.hint;
    }
    EXPECT_FALSE(device.state().isArmed);
}

TEST(OfferedProcedure, ofARotorNeedsOneAxisThatTurnsForEver) {
    devices::Catalogue catalogue;
    EXPECT_TRUE(checkTurnsForever(catalogue)); // a board without a profile
    catalogue.axes = {devices::AxisSpec{}};
    EXPECT_TRUE(checkTurnsForever(catalogue));
    catalogue.axes.front().turnsForever = false;
    EXPECT_FALSE(checkTurnsForever(catalogue));
    catalogue.axes = {devices::AxisSpec{}, devices::AxisSpec{}};
    EXPECT_FALSE(checkTurnsForever(catalogue));
}

// Nothing can be armed: every procedure that moves is refused before a value is written.
TEST(OfferedProcedure, aDeviceThatOnlySensesIsNotMoved) {
    const auto opened = devices::openDevice("sim:spherical", {});
    ASSERT_TRUE(opened);
    devices::Device& device = **opened;
    const auto refusal = [](const auto& result) { return result ? Error{} : result.error(); };
    for (const Error& error : {refusal(runMove(device, {}, {})), refusal(planRelayOn(device, {})),
                               refusal(runIdentify(device, {}, {})), refusal(runCalibrate(device, {}, {}))}) {
        EXPECT_EQ(error.code, ErrorCode::Usage) << error.message;
        EXPECT_NE(error.message.find("is not available for this device"), std::string::npos) << error.message;
        EXPECT_NE(error.hint.find("record"), std::string::npos) << error.hint;
    }
}

TEST(OfferedProcedure, ofABoardWithoutAProfileIsAny) {
    devices::Catalogue catalogue;
    EXPECT_TRUE(checkProcedureOffered(catalogue, "identify"));
    catalogue.procedures = {"move", "record"};
    EXPECT_TRUE(checkProcedureOffered(catalogue, "move"));
    EXPECT_FALSE(checkProcedureOffered(catalogue, "identify"));
}

} // namespace
} // namespace halbench::app
