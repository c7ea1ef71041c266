#include "control/base/block_columns.h"

namespace halbench {

std::vector<ColumnSource> BlockColumns::sources(const SampleBlock& block) const {
    const std::size_t width = block.layout->columns.size();
    std::vector<ColumnSource> sources;
    sources.reserve(width + added.size());
    for (std::size_t column = 0; column < width; ++column) {
        sources.push_back({block.values.data() + column, width});
    }
    for (const auto& [column, values] : replaced) {
        sources[column] = {values.data(), 1};
    }
    for (const std::vector<double>& values : added) {
        sources.push_back({values.data(), 1});
    }
    return sources;
}

} // namespace halbench
