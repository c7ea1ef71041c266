#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace halbench {

/// What the columns of a block mean. Shared by all blocks of one stream.
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

/// A finished recording held in memory: concatenated blocks of one layout.
struct Recording {
    std::shared_ptr<const StreamLayout> layout;
    std::vector<double> time_s;
    std::vector<double> values;
    std::uint64_t lostRows = 0;

    std::size_t rows() const { return time_s.size(); }
    void append(const SampleBlock& block);
    /// One signal as a column; empty when the signal is not part of the recording.
    std::vector<double> column(const std::string& name) const;
};

} // namespace halbench
