#pragma once

#include "app/procedures/excite/table_reference.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace halbench::app {

constexpr std::size_t MaxPoseRows = 10000;
constexpr std::size_t MaxPoseTableOctets = std::size_t{4} << 20;

/// Reads the text of a table: cells between commas, semicolons or tabs (with decimal commas where commas do
/// not separate them), byte order mark, CR LF, empty lines and comments as everywhere. Errors: InvalidInput
/// with file, line and column (no rows, one row, a cell that is not a number, another number of cells, a
/// column without a known unit or given twice, times that do not increase, too large).
Result<PoseTable> parsePoseTable(std::string_view text, const std::string& origin);

/// Reads the file of a table, which the reference then follows; nothing of other shapes. A path counts from
/// the working folder, as those of all files that a command or an experiment reads. Errors: FileSystem, of
/// parsePoseTable() and attachTable().
Result<void> readTableOf(MoveReference& reference);

} // namespace halbench::app
