#include "devices/xcp/stream_assembler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace halbench::devices::xcp {
namespace {

constexpr double Period_s = 1e-3;
constexpr std::uint8_t FirstPid = 3;

StreamAssembler assemblerOf(std::size_t timestampSize = 4) {
    DaqAbility ability;
    ability.format.maxDto = 64;
    ability.format.maxEntrySize = 8;
    ability.format.timestampSize = timestampSize;
    ability.tick_s = 1e-6;
    ability.ticksPerSecond = 1e6;
    SamplingPlan plan;
    plan.entries.push_back({Address{}, DataType::ULong});
    StreamLayout layout;
    layout.columns.push_back({"count", ""});
    layout.period_s = Period_s;
    plan.layout = std::make_shared<const StreamLayout>(layout);
    plan.boardPeriod_s = Period_s;
    const auto entries = plan.entries;
    return {plan, ability, DtoDecoder(ability.format, entries, DaqPlan{{0}}, 0, FirstPid)};
}

void appendLong(std::vector<std::uint8_t>& packet, std::uint32_t value) {
    for (int octet = 0; octet < 4; ++octet) {
        packet.push_back(static_cast<std::uint8_t>(value >> (8 * octet)));
    }
}

/// One row numbered `row`, stamped by the board's clock.
void feedRow(StreamAssembler& stream, std::uint32_t row, double clock_s, double arrival_s,
             std::uint64_t packetsLost = 0) {
    std::vector<std::uint8_t> packet{FirstPid};
    appendLong(packet, static_cast<std::uint32_t>(std::llround(1e6 * clock_s)));
    appendLong(packet, row);
    stream.feed(packet, arrival_s, packetsLost);
}

Recording taken(StreamAssembler& stream) {
    Recording recording;
    for (const SampleBlockPtr& block : stream.takeBlocks()) {
        recording.append(*block);
    }
    return recording;
}

/// So many rows 1 ms apart, of which each is read at its arrival.
Recording recorded(std::uint32_t rows, const std::function<double(std::uint32_t)>& clock_s,
                   const std::function<double(std::uint32_t)>& arrival_s) {
    StreamAssembler stream = assemblerOf();
    stream.noteStart(0.0);
    for (std::uint32_t row = 0; row < rows; ++row) {
        feedRow(stream, row, clock_s(row), arrival_s(row));
    }
    EXPECT_EQ(stream.dropped(), 0U);
    return taken(stream);
}

double onTime(std::uint32_t row) {
    return Period_s * (row + 1);
}

TEST(StreamAssembler, rowsThatWereReadLateAreAllThere) {
    // At the start, in the middle, and again and again: for this long nothing is read, then all at once.
    for (const double pause_s : {0.5, 1.5, 5.0, 60.0}) {
        for (const double begin_s : {0.0, 0.7}) {
            const Recording all = recorded(3000, onTime, [&](std::uint32_t row) {
                const double sent_s = onTime(row);
                return sent_s > begin_s ? std::max(sent_s, begin_s + pause_s) : sent_s;
            });
            EXPECT_EQ(all.rows(), 3000U) << pause_s << " s from " << begin_s;
            EXPECT_EQ(all.lostRows, 0U);
        }
    }
}

TEST(StreamAssembler, aSlowStartWhoseStartWasNotNotedLosesNothingEither) {
    StreamAssembler stream = assemblerOf();
    for (std::uint32_t row = 0; row < 2000; ++row) {
        feedRow(stream, row, onTime(row), std::max(1.9, onTime(row)));
    }
    EXPECT_EQ(taken(stream).rows(), 2000U);
}

TEST(StreamAssembler, rowsThatTheSocketLostDuringASlowStartAreAGapOfTheirLength) {
    StreamAssembler stream = assemblerOf();
    stream.noteStart(0.0);
    for (std::uint32_t row = 0; row < 3000; ++row) {
        if (row < 200 || row >= 1900) { // the socket holds 200 rows, the program reads from 1.9 s on
            feedRow(stream, row, onTime(row), std::max(1.9, onTime(row)), row < 200 ? 0 : 1700);
        }
    }
    const Recording recording = taken(stream);
    EXPECT_EQ(recording.rows(), 1300U);
    EXPECT_EQ(recording.lostRows, 1700U);
}

TEST(StreamAssembler, lateStampsAreNoLoss) {
    const Recording recording = recorded(
        3999, [](std::uint32_t row) { return onTime(row) + (row % 20 == 11 ? 0.6 * Period_s : 0.0); },
        [](std::uint32_t row) { return onTime(row) + 1e-3; });
    EXPECT_EQ(recording.rows(), 3999U);
    EXPECT_EQ(recording.lostRows, 0U);
}

TEST(StreamAssembler, aBoardThatWasHeldUpAndCatchesUpLosesNothing) {
    // Rows 500 to 599 are stamped when the processor was free again, 20 us apart, as are the rows behind
    // them.
    const auto stamp_s = [](std::uint32_t row) {
        return row < 500 ? onTime(row)
                         : std::max(onTime(row), onTime(600) + 0.37 * Period_s + 2e-5 * (row - 500));
    };
    const Recording recording = recorded(3000, stamp_s, stamp_s);
    EXPECT_EQ(recording.rows(), 3000U);
    EXPECT_EQ(recording.lostRows, 0U);
}

TEST(StreamAssembler, rowsBehindALongStepComeSoonWhetherOneWasLostOrNot) {
    StreamAssembler stream = assemblerOf();
    std::uint32_t row = 0;
    for (; row < 100; ++row) {
        feedRow(stream, row, onTime(row), onTime(row));
    }
    EXPECT_EQ(taken(stream).rows(), 100U);
    ++row; // lost, and all that follow are 0.3 periods late
    constexpr std::uint32_t Behind = RowGrid::LookAhead + 1;
    for (; row < 101 + Behind; ++row) {
        feedRow(stream, row, onTime(row) + 0.3 * Period_s, onTime(row));
    }
    const Recording recording = taken(stream);
    EXPECT_EQ(recording.rows(), Behind);
    EXPECT_EQ(recording.lostRows, 1U);
}

TEST(StreamAssembler, rowsThatStillWaitWhenTheLineEndsAreDelivered) {
    for (const double late_ratio : {0.3, 0.4, -0.3}) {
        StreamAssembler stream = assemblerOf();
        for (std::uint32_t row = 0; row < 100; ++row) {
            feedRow(stream, row, onTime(row), onTime(row));
        }
        EXPECT_EQ(taken(stream).rows(), 100U);
        // Row 101 waits for the next ones to tell a loss from a late stamp.
        feedRow(stream, 101, onTime(101) + late_ratio * Period_s, onTime(101));
        EXPECT_EQ(taken(stream).rows(), 0U) << late_ratio;
        stream.finish();
        const Recording recording = taken(stream);
        EXPECT_EQ(recording.rows(), 1U) << late_ratio;
        EXPECT_EQ(recording.lostRows, 0U) << late_ratio << ": nobody can tell any more";
    }
}

TEST(StreamAssembler, withoutTimeStampsTheTransportTellsWhatWasLost) {
    StreamAssembler stream = assemblerOf(0);
    std::uint64_t lost = 0;
    for (std::uint32_t row = 0; row < 100; ++row) {
        lost += row == 40 || row == 60 || row == 61 ? 1 : 0;
        if (row == 40 || row == 60 || row == 61) {
            continue;
        }
        std::vector<std::uint8_t> packet{FirstPid};
        appendLong(packet, row);
        stream.feed(packet, onTime(row), lost);
    }
    const Recording recording = taken(stream);
    EXPECT_EQ(recording.lostRows, 3U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        EXPECT_NEAR(recording.time_s[row], Period_s * recording.values[row], 1e-12);
    }
}

/// A board whose clock jumps by `jump_s` after row 1000, which the host does not read for `pause_s`.
Recording withJump(double jump_s, double pause_s, std::uint64_t& restarts) {
    StreamAssembler stream = assemblerOf();
    stream.noteStart(0.0);
    const double begin_s = 100.0; // of the board's clock
    for (std::uint32_t row = 0; row < 3000; ++row) {
        const double host_s = onTime(row) + (row > 1000 ? pause_s : 0.0);
        feedRow(stream, row, begin_s + host_s + (row > 1000 ? jump_s : 0.0), host_s);
    }
    EXPECT_EQ(stream.dropped(), 0U);
    restarts = stream.clockRestarts();
    return taken(stream);
}

TEST(StreamAssembler, aClockThatStartsAgainMakesAGapAsLongAsTheHostsClockSays) {
    for (const double jump_s : {-101.0, -1.5, -50.0, 30.0, 2000.0}) {
        for (const double pause_s : {0.0, 0.25}) {
            std::uint64_t restarts = 0;
            const Recording recording = withJump(jump_s, pause_s, restarts);
            EXPECT_EQ(restarts, 1U) << jump_s;
            EXPECT_EQ(recording.rows(), 3000U) << "all rows arrived";
            EXPECT_EQ(recording.lostRows, pause_s > 0.0 ? 250U : 0U) << jump_s;
            EXPECT_NEAR(recording.time_s[1001] - recording.time_s[1000], pause_s + Period_s, 1e-9);
            EXPECT_NEAR(recording.time_s[2999] - recording.time_s[1001], 1.998, 1e-9);
        }
    }
}

// Rows that come ten at a time, as USB and networks deliver them: between two handfuls nothing is lost.
TEST(StreamAssembler, aClockThatStartsAgainIsMarkedAndCountsNothingThatArrived) {
    for (const std::uint32_t restart : {500U, 503U, 509U, 510U}) {
        StreamAssembler stream = assemblerOf();
        stream.noteStart(0.0);
        for (std::uint32_t row = 0; row < 1000; ++row) {
            const double read_s = onTime(row / 10 * 10 + 9);
            feedRow(stream, row, row < restart ? 100.0 + onTime(row) : onTime(row - restart), read_s);
        }
        EXPECT_EQ(stream.clockRestarts(), 1U);
        int breaks = 0;
        std::size_t rows = 0;
        for (const SampleBlockPtr& block : stream.takeBlocks()) {
            EXPECT_EQ(block->lostRows, 0U) << restart;
            if (block->isBreak) {
                EXPECT_EQ(block->values.front(), restart);
                ++breaks;
            }
            rows += block->rows();
        }
        EXPECT_EQ(breaks, 1) << restart;
        EXPECT_EQ(rows, 1000U);
    }
}

TEST(StreamAssembler, singleStampsThatAreSpoiledAreNoRestart) {
    StreamAssembler stream = assemblerOf();
    stream.noteStart(0.0);
    for (std::uint32_t row = 0; row < 1000; ++row) {
        const bool isSpoiled = row % 10 == 5 || row % 10 == 6;
        feedRow(stream, row, isSpoiled ? (row % 20 < 10 ? 3000.0 : 0.0) : 10.0 + onTime(row), onTime(row));
    }
    EXPECT_EQ(stream.clockRestarts(), 0U);
    stream.finish();
    const Recording recording = taken(stream);
    EXPECT_EQ(recording.rows(), 800U);
    EXPECT_EQ(recording.lostRows, 200U);
}

} // namespace
} // namespace halbench::devices::xcp
