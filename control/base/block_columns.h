#pragma once

#include "control/base/sample_block.h"

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace halbench {

/// Where the values of one column lie: value(row) = values[row * stride].
struct ColumnSource {
    const double* values = nullptr;
    std::size_t stride = 1;
};

/// What the history writes for a block beside its own values, so that the block need not be copied to be
/// changed. All columns here have a value for each row of the block.
struct BlockColumns {
    double shift_s = 0.0;                                ///< of the history's time from the block's
    std::map<std::size_t, std::vector<double>> replaced; ///< what is shown instead, by column of the block
    std::shared_ptr<const StreamLayout> layout; ///< columns of the block, then of `added`; none: the block's
    std::vector<std::vector<double>> added;

    /// A value as it is written. `column`: one of the block.
    double value(const SampleBlock& block, std::size_t row, std::size_t column) const {
        const auto other = replaced.find(column);
        return other == replaced.end() ? block.value(row, column) : other->second[row];
    }
    /// All columns that are written. Valid as long as the block and this.
    std::vector<ColumnSource> sources(const SampleBlock& block) const;
};

} // namespace halbench
