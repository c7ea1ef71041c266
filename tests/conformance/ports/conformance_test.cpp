#include "devices/open/port_address.h"
#include "devices/transport/hid_port.h"
#include "devices/transport/stream_codec.h"
#include "tests/conformance/ports/mock_usb.h"
#include "tests/conformance/transport/far_end.h"

#include <optional>

namespace halbench::devices {
namespace {

std::unique_ptr<Transport> transportTo(const std::string& uri) {
    auto transport = makeUsbTransport(*parseDeviceUri(uri));
    EXPECT_TRUE(transport);
    return *std::move(transport);
}

/// A board with bulk endpoints; plugged in again it has a new address, as on a real bus.
class BulkEnd : public FarEnd {
public:
    explicit BulkEnd(MockBulkBoard::Departure departure) : m_departure(departure) { plug(); }

    LineTraits traits() const override {
        LineTraits traits;
        traits.isExclusive = true;
        return traits;
    }
    std::unique_ptr<Transport> makeTransport() override { return transportTo("usb:1209:0001:HB-17"); }
    std::unique_ptr<FrameCodec> makeCodec() const override { return std::make_unique<StreamCodec>(); }
    void deliver(const Octets& octets) override { m_board->deliver(octets); }
    Octets taken() override { return m_board->takenWithin(Patience_s); }
    void setStalled(bool isStalled) override { m_board->setStalled(isStalled); }
    void unplug() override { m_board->unplug(m_departure); }
    void plug() override {
        m_board.reset();
        m_board.emplace(m_machine, m_nextAddress++, "HB-17");
    }

private:
    MockMachine m_machine;
    MockBulkBoard::Departure m_departure;
    int m_nextAddress = 2;
    std::optional<MockBulkBoard> m_board;
};

class HidEnd : public FarEnd {
public:
    HidEnd() { plug(); }

    LineTraits traits() const override {
        LineTraits traits;
        traits.isExclusive = true;
        return traits;
    }
    std::unique_ptr<Transport> makeTransport() override { return transportTo("hid:1209:0001"); }
    std::unique_ptr<FrameCodec> makeCodec() const override { return std::make_unique<StreamCodec>(); }
    void deliver(const Octets& octets) override {
        for (const HidReport& report : reportsFor(octets)) {
            m_board->deliver({report.begin(), report.end()});
        }
    }
    Octets taken() override {
        Octets octets;
        for (const Octets& report : m_board->takenWithin(Patience_s)) {
            const auto carried = octetsOf(std::span(report).subspan(1)); // behind the report number
            octets.insert(octets.end(), carried.begin(), carried.end());
        }
        return octets;
    }
    void setStalled(bool isStalled) override { m_board->setStalled(isStalled); }
    void unplug() override { m_board->unplug(); }
    void plug() override {
        m_board.reset();
        m_board.emplace(m_machine, m_nextNumber++, "HB-9");
    }

private:
    MockMachine m_machine;
    int m_nextNumber = 1;
    std::optional<MockHidBoard> m_board;
};

const LineKind Bulk{"bulk", [] { return std::make_unique<BulkEnd>(MockBulkBoard::Departure::NoDevice); }};
const LineKind BulkWithErrors{"bulkThatEndsInErrors", [] {
                                  return std::make_unique<BulkEnd>(MockBulkBoard::Departure::ProtocolError);
                              }};
const LineKind Hid{"hid", [] { return std::make_unique<HidEnd>(); }};

INSTANTIATE_TEST_SUITE_P(Ports, TransportConformance, testing::Values(Bulk, BulkWithErrors, Hid), lineName);
INSTANTIATE_TEST_SUITE_P(Ports, StreamConformance, testing::Values(Bulk, Hid), lineName);
INSTANTIATE_TEST_SUITE_P(Ports, UncheckedStreamConformance, testing::Values(Bulk, Hid), lineName);
INSTANTIATE_TEST_SUITE_P(Ports, StallConformance, testing::Values(Bulk, Hid), lineName);

} // namespace
} // namespace halbench::devices
