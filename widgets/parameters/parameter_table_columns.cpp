// How wide the columns of the parameter table are.
#include "widgets/parameters/parameter_filter_model.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QHeaderView>
#include <QScopedValueRollback>
#include <QTreeView>

#include <algorithm>

namespace halbench::widgets {

/// Of the column's numbers: the names of choices may be longer.
int ParameterTable::numberWidth(int column) const {
    int width_px = m_view->header()->sectionSizeHint(column);
    for (int group = 0; group < m_filter->rowCount(); ++group) {
        const QModelIndex heading = m_filter->index(group, 0);
        for (int row = 0; row < m_filter->rowCount(heading); ++row) {
            const QModelIndex cell = m_filter->index(row, column, heading);
            if (cell.data(ParameterTableModel::ChoicesRole).toStringList().isEmpty()) {
                width_px = std::max(width_px, m_view->sizeHintForIndex(cell).width());
            }
        }
    }
    return width_px;
}

/// As wide as what they hold. What is edited is seen with its unit without scrolling: where there is less
/// room than that, first the choices give way, then the names, which have their tooltip.
void ParameterTable::fitColumns() {
    using Model = ParameterTableModel;
    if (m_isWidthChosen) {
        return;
    }
    const QScopedValueRollback fitting(m_isFitting, true);
    int shown_px = 0;
    for (int column = 0; column < Model::Columns; ++column) {
        m_view->resizeColumnToContents(column);
        shown_px += column <= Model::UnitColumn ? m_view->columnWidth(column) : 0;
    }
    const int room_px = m_view->viewport()->width();
    for (const int column : {Model::DeviceColumn, Model::EditedColumn}) {
        const int all_px = m_view->columnWidth(column);
        const int given_px = std::clamp(shown_px - room_px, 0, std::max(0, all_px - numberWidth(column)));
        m_view->setColumnWidth(column, all_px - given_px);
        shown_px -= given_px;
    }
    constexpr int LeastCharacters = 12;
    const int least_px = LeastCharacters * fontMetrics().averageCharWidth();
    const int name_px = m_view->columnWidth(Model::NameColumn);
    const int given_px = std::clamp(shown_px - room_px, 0, std::max(0, name_px - least_px));
    m_view->setColumnWidth(Model::NameColumn, name_px - given_px);
}

bool ParameterTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_view->viewport() && event->type() == QEvent::Resize && m_hasFittedColumns) {
        fitColumns();
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace halbench::widgets
