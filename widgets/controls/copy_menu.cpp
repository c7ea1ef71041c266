#include "widgets/controls/copy_menu.h"

#include <QAbstractItemView>
#include <QAction>
#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QItemSelectionModel>
#include <QStringList>

#include <algorithm>
#include <functional>

namespace halbench::widgets {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::CopyMenu)
};

const QChar Tab(u'\t');

QString rowText(const QModelIndex& row) {
    QStringList cells;
    for (int column = 0; column < row.model()->columnCount(row.parent()); ++column) {
        cells << row.siblingAtColumn(column).data().toString();
    }
    while (!cells.isEmpty() && cells.last().isEmpty()) {
        cells.removeLast();
    }
    return cells.join(Tab);
}

/// Rows below `parent` in their order, each followed by its own.
void appendRows(QStringList& lines, const QAbstractItemModel& model, const QModelIndex& parent) {
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex index = model.index(row, 0, parent);
        lines << rowText(index);
        appendRows(lines, model, index);
    }
}

QString cell(const QAbstractItemView& view) {
    return view.currentIndex().data().toString();
}

QString selectedRows(const QAbstractItemView& view) {
    QModelIndexList rows;
    for (const QModelIndex& index : view.selectionModel()->selectedIndexes()) {
        const QModelIndex first = index.siblingAtColumn(0);
        if (!rows.contains(first)) {
            rows << first;
        }
    }
    std::sort(rows.begin(), rows.end());
    QStringList lines;
    for (const QModelIndex& row : rows) {
        lines << rowText(row);
    }
    return lines.join(QLatin1Char('\n'));
}

QString table(const QAbstractItemView& view) {
    QStringList titles;
    for (int column = 0; column < view.model()->columnCount(); ++column) {
        titles << view.model()->headerData(column, Qt::Horizontal).toString();
    }
    QStringList lines = {titles.join(Tab)};
    appendRows(lines, *view.model(), {});
    return lines.join(QLatin1Char('\n'));
}

void add(QAbstractItemView& view, const QString& words,
         const std::function<QString(const QAbstractItemView&)>& text) {
    auto* action = new QAction(words, &view);
    QObject::connect(action, &QAction::triggered, &view, [&view, text] {
        if (view.model() != nullptr) {
            QGuiApplication::clipboard()->setText(text(view));
        }
    });
    view.addAction(action);
}

} // namespace

void addCopyMenu(QAbstractItemView& view) {
    view.setContextMenuPolicy(Qt::ActionsContextMenu);
    add(view, Words::tr("Copy cell"), cell);
    add(view, Words::tr("Copy rows"), selectedRows);
    add(view, Words::tr("Copy table"), table);
}

} // namespace halbench::widgets
