#pragma once

#include "control/base/sample_block.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace halbench::control {

inline std::shared_ptr<const StreamLayout> layoutOf(const std::vector<std::string>& names, double period_s) {
    auto layout = std::make_shared<StreamLayout>();
    for (const std::string& name : names) {
        layout->columns.push_back({name, "T"});
    }
    layout->period_s = period_s;
    return layout;
}

/// Rows first ... first + count - 1 of a stream: time is row * period, values come from value(row, column).
inline SampleBlock blockOf(const std::shared_ptr<const StreamLayout>& layout, std::size_t first,
                           std::size_t count, const std::function<double(std::size_t, std::size_t)>& value) {
    SampleBlock block;
    block.layout = layout;
    for (std::size_t row = first; row < first + count; ++row) {
        block.time_s.push_back(static_cast<double>(row) * layout->period_s);
        for (std::size_t column = 0; column < layout->columns.size(); ++column) {
            block.values.push_back(value(row, column));
        }
    }
    return block;
}

} // namespace halbench::control
