#pragma once

#include "tests/devices/firmware/avr/avr_fixture.h"

#include <cmath>
#include <optional>
#include <span>

namespace halbench::simavr {

// The board's clock counts microseconds in 32 bits (resources/help/protocol.md 3.9): it turns over every 71.6
// minutes. It is made from the count of ticks, 2000 microseconds each.
constexpr double BoardTick_s = 2e-3;
constexpr double ClockTurn_s = 4294.967296;

/// The ticks done when the clock passes its start for the n-th time.
inline std::uint32_t ticksAtTurn(int turn) {
    return static_cast<std::uint32_t>(std::ceil(turn * ClockTurn_s / BoardTick_s));
}

/// The line to a board that has been on for so many ticks when the master connects. Behind the reset of its
/// opening the count is found among the program's variables and set once; from there on the program counts.
class LongRunningLine : public AvrTransport {
public:
    LongRunningLine(std::shared_ptr<AvrBoard> board, std::uint32_t ticks)
        : AvrTransport(board), m_board(std::move(board)), m_start(ticks) {}

    Result<void> open() override {
        if (Result<void> opened = AvrTransport::open(); !opened) {
            return opened;
        }
        m_board->forgetTicks();
        m_places.clear();
        for (std::size_t place = 0; place + sizeof m_start <= m_board->core().variables().size(); ++place) {
            m_places.push_back(place);
        }
        // Whatever else happens to have the number is left behind by the second look.
        for (int look = 0; look < 2; ++look) {
            pass(0.1);
            std::erase_if(m_places, [this](std::size_t place) { return !isCount(numberAt(place)); });
        }
        if (m_places.size() != 1) {
            return failure(ErrorCode::Protocol, "the program's count of ticks is not found", "");
        }
        const std::uint64_t done = m_board->ticks().count;
        while (m_board->ticks().count == done) { // not while the program is at it
            pass(50e-6);
        }
        setNumberAt(m_places.front(), m_start);
        return {};
    }

    std::uint32_t ticks() const { return numberAt(m_places.at(0)); }

private:
    void pass(double time_s) {
        std::vector<std::uint8_t> packet;
        (void)receive(packet, time_s); // a board that is not connected says nothing
    }
    /// Ticks are counted by the program before the busy pin falls, and the first fall may be the pin's own.
    bool isCount(std::uint32_t number) const {
        const std::uint64_t done = m_board->ticks().count;
        return number + 1U >= done && number <= done + 1U;
    }
    std::uint32_t numberAt(std::size_t place) const {
        std::uint32_t number = 0;
        const std::span<const std::uint8_t> octets = m_board->core().variables();
        for (std::size_t i = 0; i < sizeof number; ++i) {
            number |= static_cast<std::uint32_t>(octets[place + i]) << (8U * i);
        }
        return number;
    }
    void setNumberAt(std::size_t place, std::uint32_t number) {
        for (std::size_t i = 0; i < sizeof number; ++i) {
            m_board->core().variables()[place + i] = static_cast<std::uint8_t>(number >> (8U * i));
        }
    }

    std::shared_ptr<AvrBoard> m_board;
    std::uint32_t m_start;
    std::vector<std::size_t> m_places;
};

/// A master at a board that has been on for so many ticks.
struct LongRunningBench : AvrBench {
    LongRunningLine* line = nullptr;
};

inline LongRunningBench openLongRunning(std::uint32_t ticks) {
    LongRunningBench bench;
    bench.board = makeBoard(perfectMotor());
    auto line = std::make_unique<LongRunningLine>(bench.board, ticks);
    bench.line = line.get();
    auto device = devices::openXcpDevice(std::move(line), {});
    EXPECT_TRUE(device) << device.error().message;
    bench.device = device ? std::move(*device) : nullptr;
    return bench;
}

/// What a stream of one signal at 100 Hz brought.
struct CountedRows {
    static constexpr double Rate_Hz = 100.0;
    std::vector<double> time_s;
    std::vector<double> values;
    std::uint64_t lost = 0;

    Result<void> stream(devices::Device& device, const std::string& signal, double duration_s) {
        if (Result<void> started = device.startStream({{signal}, Rate_Hz},
                                                      [this](const SampleBlockPtr& block) { take(*block); });
            !started) {
            return started;
        }
        Result<void> waited = device.clock().waitFor(duration_s);
        device.stopStream();
        return waited;
    }
    void take(const SampleBlock& block) {
        lost += block.lostRows;
        for (std::size_t row = 0; row < block.rows(); ++row) {
            time_s.push_back(block.time_s[row]);
            values.push_back(block.value(row, 0));
        }
    }
};

/// As many rows as the time has room for, each 10 ms behind the one before.
inline void expectEachRowOnce(const CountedRows& rows, double duration_s) {
    ASSERT_GE(static_cast<double>(rows.time_s.size()), duration_s * CountedRows::Rate_Hz - 10.0)
        << "but for those still on the line";
    ASSERT_LE(static_cast<double>(rows.time_s.size()), duration_s * CountedRows::Rate_Hz + 1.0);
    EXPECT_EQ(rows.lost, 0U);
    for (std::size_t i = 1; i < rows.time_s.size(); ++i) {
        // A double near 4300 s is exact to 1e-12.
        ASSERT_NEAR(rows.time_s[i] - rows.time_s[i - 1], 1.0 / CountedRows::Rate_Hz, 1e-9) << i;
    }
}

} // namespace halbench::simavr
