#include "app/procedures/apply/live_apply_procedure.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/procedures/identify/identify_procedure.h"
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
    const Error refusals[] = {
        refusal(runIdentify(device, gentle, {})),  refusal(runCalibrate(device, {}, {})),
        refusal(runFrequency(device, {}, {}, {})), refusal(runRelay(device, {}, {})),
        refusal(runApply(device, {}, {})),         refusal(runLiveApply(device, {}, {}))};
    for (const Error& error : refusals) {
        EXPECT_EQ(error.code, ErrorCode::Usage) << error.message;
        EXPECT_NE(error.message.find("does not suit this device"), std::string::npos) << error.message;
        EXPECT_NE(error.hint.find("move, record"), std::string::npos) << error.hint;
    }
    EXPECT_FALSE(device.state().isArmed);
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
