#include "devices/acquisition/stream_rate.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::devices {
namespace {

/// Signals s0, s1, ... of a board that samples at these rates.
Catalogue catalogueOf(const std::vector<double>& rates_Hz) {
    Catalogue catalogue;
    for (std::size_t i = 0; i < rates_Hz.size(); ++i) {
        SignalSpec spec;
        spec.name = "s" + std::to_string(i);
        spec.maxRate_Hz = rates_Hz[i];
        catalogue.signals.push_back(spec);
    }
    return catalogue;
}

std::vector<std::string> namesOf(const Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const SignalSpec& spec : catalogue.signals) {
        names.push_back(spec.name);
    }
    return names;
}

DeviceInfo boardAt(const std::string& transport, const std::string& uri) {
    DeviceInfo info;
    info.transport = transport;
    info.uri = uri;
    return info;
}

double greatest(const std::string& transport, const std::string& uri, const Catalogue& catalogue) {
    return greatestRate_Hz(boardAt(transport, uri), catalogue, namesOf(catalogue));
}

TEST(StreamRate, isThatOfTheSlowestSignalWhereTheLinkCarriesMore) {
    EXPECT_EQ(greatest("loopback", "sim:htm", catalogueOf({1000.0, 10000.0})), 1000.0);
    EXPECT_EQ(greatest("tcp", "tcp:127.0.0.1:5555", catalogueOf(std::vector<double>(32, 10000.0))), 10000.0);
    EXPECT_EQ(greatest("usb", "usb:1209:0001", catalogueOf({8000.0})), 8000.0);
}

/// protocol.md 3.14: 15 signals at 115200 Bd come without loss at 167 Hz, at 200 Hz they do not.
TEST(StreamRate, ofASerialLineIsWhatItsBitsCarry) {
    const Catalogue fifteen = catalogueOf(std::vector<double>(15, 1000.0));
    EXPECT_NEAR(greatest("serial", "serial:/dev/ttyACM0", fifteen), 1000.0 / 6.0, 1e-9);
    // 11520 octets a second, 12 of a row of one signal: 960 Hz, so that every second row comes.
    EXPECT_NEAR(greatest("serial", "serial:/dev/ttyACM0", catalogueOf({1000.0})), 500.0, 1e-9);
    // A tenth of the bits: 16.9 rows of 15 signals; 1000 / 60 is the next part.
    EXPECT_NEAR(greatest("serial", "serial:/dev/ttyACM0?baud=11520", fifteen), 1000.0 / 60.0, 1e-9);
    EXPECT_EQ(greatest("serial", "serial:/dev/ttyACM0?baud=12000000", fifteen), 1000.0);
}

TEST(StreamRate, ofAHidBoardIsAReportAMillisecond) {
    EXPECT_EQ(greatest("hid", "hid:1209:0001", catalogueOf(std::vector<double>(16, 4000.0))), 1000.0);
    EXPECT_EQ(greatest("hid", "hid:1209:0001", catalogueOf(std::vector<double>(17, 4000.0))), 500.0);
}

TEST(StreamRate, isNoneForWhatDoesNotComePeriodically) {
    EXPECT_EQ(greatest("serial", "serial:/dev/ttyACM0", catalogueOf({1000.0, 0.0})), 0.0);
    EXPECT_EQ(greatest("tcp", "tcp:127.0.0.1:5555", catalogueOf({})), 0.0);
    EXPECT_EQ(greatestRate_Hz(boardAt("tcp", "tcp:127.0.0.1:5555"), catalogueOf({}), {"none"}), 0.0);
}

TEST(StreamRate, aWholePartIsTheGreatestThatIsNotAbove) {
    EXPECT_EQ(wholePart_Hz(1000.0, 1000.0), 1000.0);
    EXPECT_EQ(wholePart_Hz(1000.0, 999.0), 500.0);
    EXPECT_EQ(wholePart_Hz(1000.0, 200.0), 200.0);
    EXPECT_EQ(wholePart_Hz(1000.0, std::numeric_limits<double>::infinity()), 1000.0);
    EXPECT_EQ(wholePart_Hz(0.0, 100.0), 0.0);
    EXPECT_EQ(wholePart_Hz(1000.0, 0.0), 0.0);
}

TEST(StreamRate, aRateAboveIsRefusedWithTheGreatestThatIsPossible) {
    const Catalogue catalogue = catalogueOf({1000.0, 1000.0});
    const DeviceInfo info = boardAt("loopback", "sim:htm");
    EXPECT_TRUE(checkStreamRate(info, catalogue, namesOf(catalogue), 1000.0));
    const Result<void> refused = checkStreamRate(info, catalogue, namesOf(catalogue), 2000.0);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(refused.error().message,
              "2 signals at 2000 Hz are not possible: maximum of device and link 1000 Hz");
    EXPECT_EQ(refused.error().hint.find("baud"), std::string::npos) << "no serial line";
    EXPECT_EQ(checkStreamRate(info, catalogue, {namesOf(catalogue)[0]}, 2000.0).error().message,
              "one signal at 2000 Hz is not possible: maximum of device and link 1000 Hz");
    const Result<void> serial =
        checkStreamRate(boardAt("serial", "serial:/dev/ttyACM0"), catalogue, namesOf(catalogue), 1000.0);
    ASSERT_FALSE(serial);
    EXPECT_NE(serial.error().hint.find("?baud=12000000"), std::string::npos);
}

} // namespace
} // namespace halbench::devices
