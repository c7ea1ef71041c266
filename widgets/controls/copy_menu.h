#pragma once

class QAbstractItemView;

namespace halbench::widgets {

/// Adds to the context menu of a list, tree or table: copy the cell, the selected rows, or all of it with its
/// headings, as text with tabs. What the view had in its menu stays before them.
void addCopyMenu(QAbstractItemView& view);

} // namespace halbench::widgets
