#include "devices/open/open_device.h"
#include "tests/conformance/ports/mock_usb.h"
#include "tests/conformance/ports/served_motor.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

void useLikeAnyDevice(const std::string& uri) {
    const auto device = openDevice(uri, {});
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ((*device)->info().model, "htm");
    EXPECT_FALSE((*device)->info().isSimulated) << "what is behind a line may move: it needs consent";
    const ParameterValue gain{"gain.kp", 12.5};
    ASSERT_TRUE((*device)->writeParameters({&gain, 1}));
    EXPECT_DOUBLE_EQ((*device)->readParameters({&gain.name, 1}).value()[0], 12.5);
    Recording recording;
    ASSERT_TRUE((*device)->startStream({{"position", "speed"}, 100.0},
                                       [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE((*device)->arm());
    ASSERT_TRUE((*device)->clock().waitFor(0.3));
    (*device)->stop();
    EXPECT_TRUE((*device)->state().isStopLatched);
    (*device)->stopStream();
    EXPECT_EQ((*device)->statistics().packetsLost, 0U);
    EXPECT_GT(recording.rows(), 10U);
}

TEST(UsbBoard, worksOverBulkEndpointsLikeTheEmbeddedBoard) {
    const MockMachine machine;
    MockBulkBoard mock(machine, 4, "HB-17");
    const ServedMotor motor(mock);
    useLikeAnyDevice("usb:1209:0001:HB-17");
}

TEST(HidBoard, worksOverReportsLikeTheEmbeddedBoard) {
    const MockMachine machine;
    MockHidBoard mock(machine, 3, "HB-9");
    const ServedMotor motor(mock);
    useLikeAnyDevice("hid:1209:0001");
}

} // namespace
} // namespace halbench::devices
