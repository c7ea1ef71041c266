#include "devices/transport/serial_port.h"
#include "tests/devices/transport/pty_line.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <termios.h>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;

SerialSettings at(const std::string& device) {
    SerialSettings settings;
    settings.device = device;
    return settings;
}

/// Everything that arrives until there are so many octets, or 2 s.
Octets received(OctetInbox& inbox, std::size_t count) {
    Octets all;
    Octets part;
    while (all.size() < count && inbox.take(part, 2.0).value_or(false)) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

double processorTime_s() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

TEST(SerialPort, setsTheSpeedOfTheLine) {
    PtyLine line;
    OctetInbox inbox;
    SerialSettings settings = at(line.path());
    settings.baud = 230400;
    settings.isDtrOn = false; // a pseudo terminal has no such line: the port opens all the same
    SerialPort port(settings);
    ASSERT_TRUE(port.open(inbox));
    termios state{};
    ASSERT_EQ(::tcgetattr(line.number(), &state), 0);
    EXPECT_EQ(::cfgetospeed(&state), static_cast<speed_t>(B230400));
}

TEST(SerialPort, unpluggingIsToldOnceAndKeepsTheProcessorQuiet) {
    PtyLine line;
    OctetInbox inbox;
    SerialPort port(at(line.path()));
    ASSERT_TRUE(port.open(inbox));
    line.deliver(Octets{1, 2, 3});
    EXPECT_EQ(received(inbox, 3).size(), 3U);
    const double before_s = processorTime_s();
    line.unplug();
    Octets octets;
    Result<bool> taken = inbox.take(octets, 2.0);
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(taken.error().message.find("unplugged"), std::string::npos);
    const auto written = port.write(Octets{1});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, taken.error().message);
    // An open hung-up port signals its error some 100 000 times a second (60 % of a processor and more).
    OctetInbox waiting;
    (void)waiting.take(octets, 0.5);
    EXPECT_LT(processorTime_s() - before_s, 0.2);
    port.close();
    // The terminal's number may be another test's by now: a port that is not there has a name nobody gives.
    OctetInbox nothing;
    SerialPort gone(at("/dev/ttyNotThere"));
    const auto opened = gone.open(nothing);
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().message.find("not found"), std::string::npos) << opened.error().message;
}

TEST(SerialPort, secondOpenIsRefusedAndNamesTheHolder) {
    PtyLine line;
    OctetInbox inbox;
    SerialPort first(at(line.path()));
    ASSERT_TRUE(first.open(inbox));
    SerialPort second(at(line.path()));
    OctetInbox other;
    const auto opened = second.open(other);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(opened.error().message.find("in use by this program"), std::string::npos)
        << opened.error().message;
    first.close();
    EXPECT_TRUE(second.open(other));
}

TEST(SerialPort, whatIsNoSerialPortIsRefusedInItsOwnWords) {
    OctetInbox inbox;
    SerialPort missing(at("/dev/no-such-port"));
    const auto none = missing.open(inbox);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("not found"), std::string::npos);
    SerialPort file(at("/dev/null"));
    const auto wrong = file.open(inbox);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().code, ErrorCode::DeviceLost);
}

} // namespace
} // namespace halbench::devices
