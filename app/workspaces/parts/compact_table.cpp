#include "app/workspaces/parts/compact_table.h"

#include "widgets/theme/theme_style.h"

#include <QHeaderView>
#include <QTableView>

namespace halbench::app {

void setCompact(QTableView& table) {
    table.verticalHeader()->hide();
    table.horizontalHeader()->setHighlightSections(false); // bold is wider
    table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 2 * widgets::GridStep_px);
}

} // namespace halbench::app
