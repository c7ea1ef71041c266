#pragma once

class QTableView;

namespace halbench::app {

/// Rows as low as the font allows, without numbers in front of them.
void setCompact(QTableView& table);

} // namespace halbench::app
