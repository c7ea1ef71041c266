#include "app/batch/recording_file.h"

#include "app/batch/numbers.h"
#include "app/batch/output_file.h"
#include "control/base/units.h"

#include <algorithm>

namespace halbench::app {

namespace {

std::string columnName(const StreamLayout::Column& column) {
    std::string name = column.name;
    std::replace(name.begin(), name.end(), '.', '_');
    const std::optional<Unit> unit = findUnit(column.unit);
    return unit && !unit->suffix.empty() ? name + "_" + std::string(unit->suffix) : name;
}

} // namespace

Result<void> writeRecording(const std::string& path, const Recording& recording, const devices::Device&,
                            const std::string&) {
    std::string text = "time_s";
    const std::size_t columns = recording.layout ? recording.layout->columns.size() : 0;
    for (std::size_t column = 0; column < columns; ++column) {
        text += "," + columnName(recording.layout->columns[column]);
    }
    text += '\n';
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        text += formatNumber(recording.time_s[row]);
        for (std::size_t column = 0; column < columns; ++column) {
            text += "," + formatNumber(recording.values[row * columns + column]);
        }
        text += '\n';
    }
    return writeFile(path, text);
}

} // namespace halbench::app
