#pragma once

#include "devices/transport/transport.h"
#include "devices/xcp/daq_list.h"
#include "devices/xcp/packets.h"

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

/// How a slave of another maker may differ (resources/help/protocol.md, gate 7).
struct SlaveTraits {
    ByteOrder order = ByteOrder::LittleEndian;
    IdField idField = IdField::Absolute;
    std::uint16_t maxDaq = 4;
    std::uint8_t maxCto = 64;
    std::uint16_t maxDto = 64;
    std::size_t dtoAlignment = 1; ///< DTOs are filled up to a multiple of this
    std::uint8_t timestampSize = 4;
    std::uint8_t timestampUnit = 3; ///< 1 us
    std::uint64_t firstTick = 0;    ///< where the slave's clock stands at time 0
    bool hasShortDownload = true;
    bool hasPages = true;
    bool isPage1ReadOnly = false;
    bool hasChecksum = true;
    bool hasBlockMode = false;
    bool marksOverload = false;
    std::string name;      ///< GET_ID 1; empty: the slave has none
    std::string epk;       ///< GET_ID 5
    double clockRatio = 1; ///< ticks of the slave's clock over those of the host's
    bool hasClockCommand = true;
    bool hasGap = false; ///< a hole between p.a and p.b, so that they cannot be written together
};

inline constexpr std::uint32_t TestSegmentAddress = 0x4000;
inline constexpr std::size_t TestSegmentSize = 64;
inline constexpr double TestSamplePeriod_s = 0.010;

inline std::deque<Packet> slaveOk() {
    return {{0xFF}};
}
inline std::deque<Packet> slaveError(SlaveError code) {
    return {{0xFE, static_cast<std::uint8_t>(code)}};
}

/// A small XCP slave written for tests from resources/help/protocol.md, with nothing of the product's board
/// in it: signals count (ULONG, number of the sample), wave (FLOAT32 = count / 4), byte (UBYTE), big (FLOAT64
/// = count / 8); parameters p.a, p.b (FLOAT32), p.n (UWORD); event 0 every 10 ms. It is its own transport on
/// a virtual clock.
class TestSlave : public Transport {
public:
    explicit TestSlave(SlaveTraits traits = {});

    // what a test may look at and bend
    std::vector<Packet> commands; ///< everything the master sent
    std::function<void(const Packet& command, std::deque<Packet>& answers)> bendAnswers;
    std::function<void(Packet& sample)> bendSample; ///< may empty it: then it is not sent
    std::optional<std::string> descriptionText;     ///< instead of the slave's own
    std::optional<double> unplugAt_s;
    std::optional<std::size_t> unplugAtCommand; ///< the link dies when this command (0 = first) is sent
    double answerDelay_s = 0.0;
    void say(Packet packet) { m_outgoing.push_back({m_now_s, std::move(packet)}); }
    float parameter(std::size_t page, std::size_t offset) const;
    std::uint8_t runningPage() const { return m_runningPage; }
    std::size_t count(Command command) const;

    std::string ownDescription() const;

    // Transport
    Result<void> open() override;
    void close() noexcept override {}
    Result<void> send(std::span<const std::uint8_t> packet) override;
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override;
    double now_s() const override { return m_now_s; }
    TransportStatistics statistics() const override { return {}; }
    std::string description() const override { return "test slave"; }

private:
    struct Outgoing {
        double due_s;
        Packet packet;
    };
    struct Entry {
        std::uint32_t address;
        std::uint8_t size;
    };

    std::deque<Packet> answer(const Packet& command);
    std::deque<Packet> answerInfo(const Packet& command);
    Packet identity(std::uint8_t type) const;
    std::deque<Packet> clockAnswer();
    std::uint64_t ticksAt(double time_s) const;
    std::deque<Packet> answerMemory(const Packet& command);
    std::deque<Packet> answerPages(const Packet& command);
    std::deque<Packet> answerDaq(const Packet& command);
    std::deque<Packet> upload(std::size_t count);
    std::vector<std::uint8_t>* memoryAt(std::uint8_t extension, std::uint32_t address, std::size_t& place);
    bool writeMemory(std::uint8_t extension, std::uint32_t address, Octets data);
    bool readMemory(std::uint8_t extension, std::uint32_t address, std::size_t count, Packet& data);
    void sample();
    void refreshSignals();
    std::uint64_t word(const Packet& packet, std::size_t place, std::size_t size) const;
    Packet response(std::initializer_list<std::pair<std::uint64_t, std::size_t>> fields) const;

    bool isUnplugged() const;

    SlaveTraits m_traits;
    double m_now_s = 0.0;
    double m_nextSample_s = 0.010;
    std::uint64_t m_samples = 0;
    std::deque<Outgoing> m_outgoing;
    std::array<std::vector<std::uint8_t>, 2> m_pages;
    std::vector<std::uint8_t> m_signals;
    std::string m_text;
    std::uint8_t m_runningPage = 0;
    std::uint8_t m_masterPage = 0;
    std::uint8_t m_extension = 0;
    std::uint32_t m_address = 0;
    std::vector<std::vector<Entry>> m_odts;
    std::size_t m_writeOdt = 0;
    std::size_t m_writeEntry = 0;
    bool m_isSampling = false;
    bool m_isSelected = false;
    std::uint8_t m_prescaler = 1;
    bool m_isConnected = false;
};

} // namespace halbench::devices::xcp
