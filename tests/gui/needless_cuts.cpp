#include "tests/gui/needless_cuts.h"

#include "widgets/controls/elided_label.h"
#include "widgets/language/whole_numbers.h"

#include <QHeaderView>
#include <QTableView>
#include <QTreeView>

#include <algorithm>
#include <vector>

namespace halbench::gui {

namespace {

/// Of half a character: margins that a layout keeps between its parts are no room.
constexpr int Slack_px = 6;

/// Of the row in which the label stands: what neither it nor its neighbours cover.
int freeInRow_px(const QWidget& label) {
    const QWidget* row = label.parentWidget();
    if (row == nullptr) {
        return 0;
    }
    const QRect band = label.geometry();
    std::vector<bool> isTaken(static_cast<std::size_t>(std::max(0, row->width())), false);
    for (const QObject* child : row->children()) {
        const auto* neighbour = qobject_cast<const QWidget*>(child);
        if (neighbour == nullptr || !neighbour->isVisible() || neighbour->isWindow() ||
            neighbour->geometry().top() > band.bottom() || neighbour->geometry().bottom() < band.top()) {
            continue;
        }
        const int last = std::min(neighbour->geometry().right(), row->width() - 1);
        for (int x = std::max(0, neighbour->geometry().left() - Slack_px); x <= last; ++x) {
            isTaken[static_cast<std::size_t>(x)] = true;
        }
    }
    return static_cast<int>(std::count(isTaken.begin(), isTaken.end(), false)) - 2 * Slack_px;
}

QStringList cutLabel(const widgets::ElidedLabel& label) {
    if (label.text() == label.words()) {
        return {};
    }
    const int missing_px = label.sizeHint().width() - label.width();
    const int free_px = freeInRow_px(label);
    return missing_px > free_px ? QStringList()
                                : QStringList(QStringLiteral("'%1' lacks %2 px beside %3 free ones")
                                                  .arg(label.words())
                                                  .arg(missing_px)
                                                  .arg(free_px));
}

/// Of the columns that are shown: what their view has left behind them.
int freeBehind_px(const QHeaderView& header) {
    return header.viewport()->width() - header.length();
}

QString cutCell(const QAbstractItemView& view, const QHeaderView& header, const QModelIndex& index) {
    const QRect place = view.visualRect(index);
    if (header.isSectionHidden(index.column()) || !view.viewport()->rect().intersects(place)) {
        return {};
    }
    const int needed_px = view.sizeHintForIndex(index).width();
    const int missing_px = needed_px - place.width();
    return missing_px > 0 && missing_px <= freeBehind_px(header)
               ? QStringLiteral("cell '%1' lacks %2 px beside %3 free ones")
                     .arg(index.data().toString())
                     .arg(missing_px)
                     .arg(freeBehind_px(header))
               : QString();
}

/// A number of which the edge of the view leaves a part: it reads as another one.
QString halfNumber(const QAbstractItemView& view, const QModelIndex& index) {
    const QRect place = view.visualRect(index);
    const QRect seen = place & view.viewport()->rect();
    const QString text = index.data().toString();
    const bool isCut = !seen.isEmpty() && seen.width() < place.width();
    const bool hasDots = qobject_cast<const widgets::WholeNumbers*>(view.itemDelegate(index)) != nullptr;
    return isCut && !hasDots && widgets::readsAsNumber(text)
               ? QStringLiteral("number '%1' is cut by the edge").arg(text)
               : QString();
}

QStringList cutCells(const QTableView& table) {
    QStringList found;
    const QAbstractItemModel& model = *table.model();
    for (int row = 0; row < model.rowCount(); ++row) {
        for (int column = 0; column < model.columnCount(); ++column) {
            if (table.columnSpan(row, column) == 1) {
                found << cutCell(table, *table.horizontalHeader(), model.index(row, column));
            }
            found << halfNumber(table, model.index(row, column));
        }
    }
    return found;
}

QStringList cutCells(const QTreeView& tree, const QModelIndex& parent) {
    QStringList found;
    const QAbstractItemModel& model = *tree.model();
    for (int row = 0; row < model.rowCount(parent); ++row) {
        for (int column = 0; column < model.columnCount(parent); ++column) {
            if (!tree.isFirstColumnSpanned(row, parent)) {
                found << cutCell(tree, *tree.header(), model.index(row, column, parent));
            }
            found << halfNumber(tree, model.index(row, column, parent));
        }
        found << cutCells(tree, model.index(row, 0, parent));
    }
    return found;
}

} // namespace

QStringList needlessCuts(const QWidget& widget) {
    QStringList found;
    if (const auto* label = qobject_cast<const widgets::ElidedLabel*>(&widget)) {
        found << cutLabel(*label);
    } else if (const auto* table = qobject_cast<const QTableView*>(&widget)) {
        found << (table->model() == nullptr ? QStringList() : cutCells(*table));
    } else if (const auto* tree = qobject_cast<const QTreeView*>(&widget)) {
        found << (tree->model() == nullptr ? QStringList() : cutCells(*tree, {}));
    }
    found.removeAll({});
    return found;
}

} // namespace halbench::gui
