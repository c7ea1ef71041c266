#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace halbench {

/// Columns of a block: names, units, distance of rows. Shared by all blocks of one stream.
struct StreamLayout {
    struct Column {
        std::string name; ///< signal name, e.g. "hall.a"
        std::string unit; ///< SI unit symbol, e.g. "T"; empty for counts and states
    };
    std::vector<Column> columns;
    double period_s = 0.0; ///< nominal distance of rows

    /// Index of a signal name, or -1.
    int indexOf(const std::string& name) const;
};

/// Rows of one stream, made once on the connection side and never changed afterwards.
/// `values` is row-major: value(row, column) = values[row * columns + column].
struct SampleBlock {
    std::shared_ptr<const StreamLayout> layout;
    std::vector<double> time_s; ///< device clock, seconds since the stream's start; strictly increasing
    std::vector<double> values;
    double hostArrival_s = 0.0; ///< host clock of the last packet
    std::uint64_t lostRows = 0; ///< rows known to be lost directly before this block
    bool isBreak = false; ///< the device's clock started again before it: how long that took is not known

    std::size_t rows() const { return time_s.size(); }
    double value(std::size_t row, std::size_t column) const {
        return values[row * layout->columns.size() + column];
    }
};

using SampleBlockPtr = std::shared_ptr<const SampleBlock>;

/// A block on another time axis, e.g. that of a window in which several streams follow each other. The block
/// itself is shared and stays as it came.
struct TimedBlock {
    TimedBlock() = default;
    TimedBlock(SampleBlockPtr rows, double later_s = 0.0) : block(std::move(rows)), shift_s(later_s) {}

    SampleBlockPtr block;
    double shift_s = 0.0; ///< of the axis from the block's own times

    std::size_t rows() const { return block->rows(); }
    double time_s(std::size_t row) const { return block->time_s[row] + shift_s; }
    double begin_s() const { return time_s(0); }
    double end_s() const { return time_s(rows() - 1); }
};

using TimedBlockSink = std::function<void(const TimedBlock&)>;

/// From a time on the rows of a recording have another distance: the stream was slower for a while.
struct RateChange {
    double time_s = 0.0; ///< of the first row
    double period_s = 0.0;
};

/// A finished recording held in memory: concatenated blocks of one layout.
struct Recording {
    std::shared_ptr<const StreamLayout> layout;
    std::vector<double> time_s;
    std::vector<double> values;
    std::uint64_t lostRows = 0;
    std::vector<RateChange> rates = {}; ///< by time; empty: layout->period_s throughout

    std::size_t rows() const { return time_s.size(); }
    void append(const SampleBlock& block);
    /// One signal as a column; empty when the signal is not part of the recording.
    std::vector<double> column(const std::string& name) const;
};

} // namespace halbench
