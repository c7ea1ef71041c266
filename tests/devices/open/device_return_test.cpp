#include "devices/open/device_return.h"
#include "devices/open/disconnected_device.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

DeviceInfo board(const std::string& id = "HB-17", const std::string& firmware = "1.0") {
    DeviceInfo info;
    info.uri = "serial:/dev/ttyACM0";
    info.model = "htm";
    info.id = id;
    info.firmware = firmware;
    return info;
}

/// A device that only says who it is.
std::unique_ptr<Device> answering(const DeviceInfo& info) {
    class Named final : public Device {
    public:
        explicit Named(DeviceInfo info) : m_info(std::move(info)) {}
        const DeviceInfo& info() const override { return m_info; }
        const Catalogue& catalogue() const override { return m_catalogue; }
        Clock& clock() override { std::abort(); }
        DeviceState state() const override { return {true, true, false, 0, {}}; }
        LinkStatistics statistics() const override { return {}; }
        Result<std::vector<double>> readParameters(std::span<const std::string>) override { return {}; }
        Result<std::vector<double>> readSignals(std::span<const std::string>) override { return {}; }
        Result<void> writeParameters(std::span<const ParameterValue>) override { return {}; }
        Result<void> saveParameters() override { return {}; }
        Result<void> startStream(const StreamRequest&, BlockSink) override { return {}; }
        void stopStream() noexcept override {}
        Result<void> arm() override { return {}; }
        Result<void> disarm() override { return {}; }
        void stop() noexcept override {}
        Result<void> clearStop() override { return {}; }
        Result<Recording> readCapture() override { return Recording(); }

    private:
        DeviceInfo m_info;
        Catalogue m_catalogue;
    };
    return std::make_unique<Named>(info);
}

/// Where the device is looked for: a test says what is there.
struct Place {
    Result<DeviceInfo> there = failure(ErrorCode::DeviceLost, "nothing is plugged in");
    int looks = 0;

    DeviceReturn::Opener opener() {
        return [this]() -> Result<std::unique_ptr<Device>> {
            ++looks;
            return there ? Result<std::unique_ptr<Device>>(answering(*there)) : failure(there.error());
        };
    }
};

constexpr double Step_s = 0.005; ///< how often the connection asks

/// Looks until the time is over or something happens.
Result<std::unique_ptr<Device>> lookFrom(DeviceReturn& back, double from_s, double to_s) {
    for (double now_s = from_s; now_s < to_s; now_s += Step_s) {
        Result<std::unique_ptr<Device>> found = back.look(now_s);
        if (!found || *found) {
            return found;
        }
    }
    return std::unique_ptr<Device>();
}

TEST(DeviceReturn, looksSoonThenMoreAndMoreSeldomButNeverGivesUp) {
    Place place;
    DeviceReturn back(board(), place.opener(), {0.1, 2.0, 2.0, 5.0, 3});
    ASSERT_TRUE(back.noteLost(100.0));
    ASSERT_TRUE(lookFrom(back, 100.0, 101.0));
    EXPECT_EQ(place.looks, 3); // at 0.1, 0.3 and 0.7 s
    EXPECT_EQ(back.reason().message, "nothing is plugged in");
    ASSERT_TRUE(lookFrom(back, 101.0, 105.0));
    EXPECT_EQ(place.looks, 5); // at 1.5 and 3.1 s; from now on two seconds apart
    ASSERT_TRUE(lookFrom(back, 105.0, 1105.0));
    EXPECT_NEAR(place.looks, 504, 3); // 1000 s, every 2 s and at most a step of 5 ms more
}

TEST(DeviceReturn, givesTheSameDeviceBack) {
    Place place;
    DeviceReturn back(board(), place.opener());
    ASSERT_TRUE(back.noteLost(0.0));
    ASSERT_TRUE(lookFrom(back, 0.0, 3.0));
    place.there = board();
    const auto found = lookFrom(back, 3.0, 6.0); // the pause is at most two seconds
    ASSERT_TRUE(found);
    ASSERT_NE(*found, nullptr);
    EXPECT_EQ((*found)->info().id, "HB-17");
}

TEST(DeviceReturn, refusesAnotherDeviceAtTheSameAddress) {
    Place place;
    place.there = board("HB-18");
    DeviceReturn back(board(), place.opener());
    ASSERT_TRUE(back.noteLost(0.0));
    const auto found = lookFrom(back, 0.0, 1.0);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::Refused);
    EXPECT_EQ(found.error().message, "another device answers at serial:/dev/ttyACM0: HB-18 instead of HB-17");
    EXPECT_NE(found.error().hint, "");
}

TEST(DeviceReturn, refusesTheSameDeviceWithOtherFirmware) {
    Place place;
    place.there = board("HB-17", "1.1");
    DeviceReturn back(board(), place.opener());
    ASSERT_TRUE(back.noteLost(0.0));
    const auto found = lookFrom(back, 0.0, 1.0);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().message, "HB-17 reconnected with other firmware: 1.1 instead of 1.0");
    EXPECT_NE(found.error().hint, "");
}

TEST(DeviceReturn, givesUpADeviceThatIsLostAgainAndAgainRightAfterItsReturn) {
    Place place;
    place.there = board();
    DeviceReturn back(board(), place.opener());
    double now_s = 0.0;
    for (int loss = 0; loss < 3; ++loss) {
        ASSERT_TRUE(back.noteLost(now_s)) << loss;
        ASSERT_TRUE(lookFrom(back, now_s, now_s + 1.0));
        now_s += 1.0; // less than five seconds after the return
    }
    const Result<void> again = back.noteLost(now_s);
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().hint.find("another program"), std::string::npos);
}

TEST(DeviceReturn, aHundredUnplugsOfADeviceThatStaysAWhileAreNoReasonToGiveUp) {
    Place place;
    place.there = board();
    DeviceReturn back(board(), place.opener());
    for (int loss = 0; loss < 100; ++loss) {
        ASSERT_TRUE(back.noteLost(10.0 * loss)) << loss;
        const auto found = lookFrom(back, 10.0 * loss, 10.0 * loss + 1.0);
        ASSERT_TRUE(found && *found) << loss;
    }
}

TEST(DisconnectedDevice, answersEverythingWithTheLossAndIsNeverArmed) {
    const auto former = answering(board());
    DisconnectedDevice gone(*former, 12.5, {ErrorCode::DeviceLost, "unplugged", "plug it in"});
    EXPECT_EQ(gone.info().id, "HB-17");
    EXPECT_FALSE(gone.state().isConnected);
    EXPECT_FALSE(gone.state().isArmed); // although it was
    EXPECT_EQ(gone.clock().now_s(), 12.5);
    const ParameterValue value{"gain.kp", 1.0};
    for (const Result<void>& answer :
         {gone.arm(), gone.disarm(), gone.clearStop(), gone.saveParameters(), gone.clock().waitFor(1.0),
          gone.writeParameters({&value, 1}), gone.startStream({}, {})}) {
        ASSERT_FALSE(answer);
        EXPECT_EQ(answer.error().message, "unplugged");
    }
    EXPECT_FALSE(gone.readParameters({&value.name, 1}));
    EXPECT_FALSE(gone.readSignals({&value.name, 1}));
    EXPECT_FALSE(gone.readCapture());
}

} // namespace
} // namespace halbench::devices
