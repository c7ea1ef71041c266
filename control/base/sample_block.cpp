#include "control/base/sample_block.h"

namespace halbench {

int StreamLayout::indexOf(const std::string& name) const {
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (columns[i].name == name) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

void Recording::append(const SampleBlock& block) {
    if (!layout) {
        layout = block.layout;
    }
    time_s.insert(time_s.end(), block.time_s.begin(), block.time_s.end());
    values.insert(values.end(), block.values.begin(), block.values.end());
    lostRows += block.lostRows;
}

std::vector<double> Recording::column(const std::string& name) const {
    const int index = layout ? layout->indexOf(name) : -1;
    if (index < 0) {
        return {};
    }
    const std::size_t width = layout->columns.size();
    std::vector<double> result(rows());
    for (std::size_t row = 0; row < result.size(); ++row) {
        result[row] = values[row * width + static_cast<std::size_t>(index)];
    }
    return result;
}

} // namespace halbench
