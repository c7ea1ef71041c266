#include "tests/gui/seen_text.h"

#include <QAbstractItemView>
#include <QHeaderView>
#include <QLineEdit>
#include <QTabBar>

namespace halbench::gui {

namespace {

/// Of a view, for its rows are alike; all of them would take the walk minutes.
constexpr int Rows = 3;
/// From a corner of a cell: a point that is surely in it.
constexpr int Inside_px = 2;

void addHeader(const QHeaderView& header, std::vector<SeenWords>& seen) {
    if (header.orientation() != Qt::Horizontal || header.model() == nullptr) {
        return;
    }
    for (int section = 0; section < header.count(); ++section) {
        if (!header.isSectionHidden(section)) {
            seen.push_back({header.model()->headerData(section, Qt::Horizontal).toString(),
                            QRect(header.sectionViewportPosition(section), 0, header.sectionSize(section),
                                  header.height())});
        }
    }
}

void addTabs(const QTabBar& bar, std::vector<SeenWords>& seen) {
    for (int tab = 0; tab < bar.count(); ++tab) {
        if (bar.isTabVisible(tab) && bar.isTabEnabled(tab)) {
            seen.push_back({bar.tabText(tab), bar.tabRect(tab)});
        }
    }
}

/// A port that another program has can still be chosen, to hear why; it looks like what is disabled.
bool isUsable(const QAbstractItemView& view, const QModelIndex& cell) {
    const auto colour = cell.data(Qt::ForegroundRole).value<QBrush>();
    return (cell.flags() & Qt::ItemIsEnabled) != 0 &&
           (colour.style() == Qt::NoBrush ||
            colour.color() != view.palette().color(QPalette::Disabled, QPalette::Text));
}

void addCells(const QAbstractItemView& view, std::vector<SeenWords>& seen) {
    const QAbstractItemModel* model = view.model();
    QModelIndex row = model == nullptr ? QModelIndex() : view.indexAt({Inside_px, Inside_px});
    for (int i = 0; i < Rows && row.isValid(); ++i) {
        const QRect first = view.visualRect(row);
        for (int column = 0; column < model->columnCount(row.parent()); ++column) {
            const QModelIndex cell = row.sibling(row.row(), column);
            if (isUsable(view, cell) && !cell.data(Qt::DecorationRole).isValid()) {
                seen.push_back({cell.data().toString(), view.visualRect(cell)});
            }
        }
        row = view.indexAt({Inside_px, first.bottom() + 1 + Inside_px});
    }
}

} // namespace

std::vector<SeenWords> seenWords(const QWidget& widget) {
    std::vector<SeenWords> seen;
    if (!widget.isEnabled()) {
        return seen;
    }
    if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) {
        addTabs(*bar, seen);
    }
    if (const auto* field = qobject_cast<const QLineEdit*>(&widget)) {
        const bool isEmpty = field->text().isEmpty();
        seen.push_back({isEmpty ? field->placeholderText() : QString(), field->contentsRect()});
    }
    // A view paints in its viewport, which is the widget that is looked at.
    if (const auto* header = qobject_cast<const QHeaderView*>(widget.parentWidget());
        header != nullptr && header->viewport() == &widget) {
        addHeader(*header, seen);
    } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
               view != nullptr && header == nullptr && view->viewport() == &widget) {
        addCells(*view, seen);
    }
    std::erase_if(seen, [&](const SeenWords& words) {
        return words.text.trimmed().isEmpty() || !widget.rect().contains(words.place) ||
               widget.visibleRegion().intersected(words.place) != QRegion(words.place);
    });
    return seen;
}

} // namespace halbench::gui
