#include "app/window/help/shortcut_list.h"

#include "widgets/controls/stop_button.h"

#include <QAbstractButton>
#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {
namespace {

enum Column { Keys, Function, Place, Columns };

/// Without mnemonics and ellipsis.
QString plainText(const QString& text) {
    return QAction(QString(text).remove(QChar(0x2026)), nullptr).iconText();
}

/// Sorted by function, each once.
void add(std::vector<ShortcutRow>& rows, const ShortcutRow& row) {
    const bool isNew = std::find(rows.begin(), rows.end(), row) == rows.end();
    if (isNew && !row.keys.isEmpty() && !row.function.isEmpty()) {
        const auto place = std::upper_bound(rows.begin(), rows.end(), row,
                                            [](const ShortcutRow& left, const ShortcutRow& right) {
                                                return left.function.localeAwareCompare(right.function) < 0;
                                            });
        rows.insert(place, row);
    }
}

QString keysOf(const QAction& action) {
    QStringList keys;
    for (const QKeySequence& key : action.shortcuts()) {
        keys << key.toString(QKeySequence::NativeText);
    }
    return keys.join(QStringLiteral(", "));
}

} // namespace

std::vector<ShortcutRow> shortcutRows(const QList<QAction*>& actions, const QString& place) {
    std::vector<ShortcutRow> rows;
    for (const QAction* action : actions) {
        add(rows, {keysOf(*action), plainText(action->text()), place});
    }
    return rows;
}

std::vector<ShortcutRow> shortcutRows(const QList<QAbstractButton*>& buttons, const QString& place) {
    std::vector<ShortcutRow> rows;
    for (const QAbstractButton* button : buttons) {
        const QKeySequence key = button->shortcut();
        const QString name = button->text().isEmpty() ? button->accessibleName() : button->text();
        if (key != QKeySequence::mnemonic(button->text())) {
            add(rows, {key.toString(QKeySequence::NativeText), plainText(name), place});
        }
    }
    return rows;
}

ShortcutList::ShortcutList(const std::vector<ShortcutRow>& rows, QWidget* parent)
    : QDialog(parent), m_search(new QLineEdit(this)),
      m_table(new QTableWidget(static_cast<int>(rows.size()), Columns, this)) {
    setWindowTitle(tr("Keyboard shortcuts"));
    m_search->setPlaceholderText(tr("Search keys, functions, panels"));
    m_search->setAccessibleName(tr("Search shortcuts"));
    m_search->setToolTip(tr("Shows rows that contain all words"));
    m_search->setClearButtonEnabled(true);
    m_table->setAccessibleName(tr("Shortcuts"));
    fill(rows);
    auto* stop = new widgets::StopButton(widgets::StopButton::Variant::Compact, this);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close the list (Esc, which also stops)"));
    auto* row = new QHBoxLayout;
    row->addWidget(stop);
    row->addStretch(1);
    row->addWidget(buttons);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_search);
    column->addWidget(m_table, 1);
    column->addLayout(row);
    connect(m_search, &QLineEdit::textChanged, this, &ShortcutList::filter);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(stop, &widgets::StopButton::stopRequested, this, &ShortcutList::stopRequested);
    resize(fontMetrics().averageCharWidth() * 80, fontMetrics().height() * 28);
}

void ShortcutList::fill(const std::vector<ShortcutRow>& rows) {
    m_table->setHorizontalHeaderLabels({tr("Keys"), tr("Function"), tr("Panel")});
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    int index = 0;
    for (const ShortcutRow& row : rows) {
        m_table->setItem(index, Keys, new QTableWidgetItem(row.keys));
        m_table->setItem(index, Function, new QTableWidgetItem(row.function));
        m_table->setItem(index, Place, new QTableWidgetItem(row.place));
        ++index;
    }
    m_table->resizeColumnsToContents();
    m_table->horizontalHeader()->setSectionResizeMode(Function, QHeaderView::Stretch);
}

void ShortcutList::filter(const QString& text) {
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QString all;
        for (int column = 0; column < Columns; ++column) {
            all += m_table->item(row, column)->text() + QLatin1Char(' ');
        }
        const bool isShown = std::all_of(words.begin(), words.end(), [&all](const QString& word) {
            return all.contains(word, Qt::CaseInsensitive);
        });
        m_table->setRowHidden(row, !isShown);
    }
}

} // namespace halbench::app
