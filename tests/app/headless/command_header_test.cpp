#include "app/headless/command_header.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

class CommandHeader : public ::testing::Test {
protected:
    ResultHeader of(const char* address) {
        const auto device = devices::openDevice(address, {});
        return headerFor(m_context, "halbench.run/1", *device.value());
    }

    Console m_console{ConsoleStyle{}};
    std::atomic<int> m_interruptSignal = 0;
    CommandContext m_context{{}, m_console, m_interruptSignal, [] { return std::string("now"); }};
};

TEST_F(CommandHeader, theSeedIsThatOfTheAddressUnlessTheCommandLineHasOne) {
    EXPECT_EQ(of("sim:htm").seed, 1U);
    EXPECT_EQ(of("sim:htm?seed=7").seed, 7U);
    m_context.global.seed = 9;
    EXPECT_EQ(of("sim:htm?seed=7").seed, 9U);
    EXPECT_EQ(headerFor(m_context, "halbench.run/1").seed, 9U);
}

TEST_F(CommandHeader, virtualTimeBeginsAtTheEpochAndPacedTimeNow) {
    EXPECT_EQ(of("sim:htm").started, "1970-01-01T00:00:00Z");
    m_context.global.isRealtime = true;
    EXPECT_EQ(of("sim:htm").started, "now");
}

TEST_F(CommandHeader, namesTheDeviceOnlyWhenThereIsOne) {
    EXPECT_EQ(of("sim:htm").device->model, "htm");
    EXPECT_FALSE(headerFor(m_context, "halbench.run/1").device);
}

} // namespace
} // namespace halbench::app
