#include "app/window/start/start_list.h"

#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/message_bar.h"

#include <QAction>
#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

enum Column { Title, Detail, ColumnCount };

constexpr double MostOfWidth_ratio = 0.65; ///< for a title; the rest for what stands beside it

} // namespace

StartList::StartList(const Words& words, Kind kind, QWidget* parent) : QWidget(parent) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* column = addSection(outer, words.title, this);
    m_rows = new QTreeWidget(this);
    m_rows->setAccessibleName(words.title);
    m_rows->setToolTip(words.tip);
    m_rows->setAccessibleDescription(words.tip);
    m_rows->setColumnCount(ColumnCount);
    m_rows->setHeaderHidden(true);
    m_rows->setRootIsDecorated(false);
    m_rows->setUniformRowHeights(true);
    m_rows->setAllColumnsShowFocus(true);
    m_rows->setTextElideMode(Qt::ElideMiddle);
    m_rows->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_rows->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_rows->header()->setStretchLastSection(false);
    m_rows->header()->setSectionResizeMode(Title, QHeaderView::ResizeToContents);
    m_rows->header()->setSectionResizeMode(Detail, QHeaderView::Stretch);
    m_empty = makeNote(this);
    m_empty->setText(words.empty);
    m_message = new widgets::MessageBar(this);
    column->addWidget(m_rows);
    column->addWidget(m_empty);
    column->addWidget(m_message);
    setFocusProxy(m_rows);
    buildMenu(kind);
    connect(m_rows, &QTreeWidget::itemActivated, this, &StartList::openCurrent);
    connect(m_rows, &QTreeWidget::currentItemChanged, this, [this] {
        m_message->clear(); // it was of another row
        refreshMenu();
    });
    connect(m_message, &widgets::MessageBar::actionTriggered, this, &StartList::removeCurrent);
    setEntries({});
}

QAction& StartList::addMenuAction(const QString& text, void (StartList::*act)()) {
    auto* action = new QAction(text, m_rows);
    connect(action, &QAction::triggered, this, act);
    m_rows->addAction(action);
    return *action;
}

void StartList::buildMenu(Kind kind) {
    m_rows->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_open = &addMenuAction(tr("Open"), &StartList::openCurrent);
    if (kind == Kind::BuiltIn) {
        return;
    }
    m_folder = &addMenuAction(tr("Open folder"), &StartList::openFolder);
    addMenuAction(tr("Copy path"), &StartList::copyPath);
    QAction& removal = addMenuAction(tr("Remove from the list"), &StartList::removeCurrent);
    removal.setShortcut(QKeySequence::Delete);
    removal.setShortcutContext(Qt::WidgetShortcut);
}

/// The row that was current stays so, whatever came before it; of one that is gone the next takes its place.
void StartList::setEntries(std::vector<StartEntry> entries) {
    const StartEntry* before = current();
    const QString path = before != nullptr ? before->path : QString();
    const auto place = before != nullptr ? before - m_entries.data() : 0;
    {
        const QSignalBlocker quiet(m_rows);
        m_entries = std::move(entries);
        m_rows->clear();
        for (const StartEntry& entry : m_entries) {
            addRow(entry);
        }
        const auto same = std::find_if(m_entries.begin(), m_entries.end(),
                                       [&](const StartEntry& entry) { return entry.path == path; });
        if (!path.isEmpty() && !m_entries.empty()) {
            const auto last = static_cast<std::ptrdiff_t>(m_entries.size()) - 1;
            const auto row = same == m_entries.end() ? std::min(place, last) : same - m_entries.begin();
            m_rows->setCurrentItem(m_rows->topLevelItem(static_cast<int>(row)));
        }
        if (same == m_entries.end()) {
            m_message->clear(); // it was of a row that is gone
        }
    }
    m_rows->setVisible(!m_entries.empty());
    m_empty->setVisible(m_entries.empty());
    fitRows();
    refreshMenu();
}

void StartList::addRow(const StartEntry& entry) {
    auto* row =
        new QTreeWidgetItem(m_rows, {entry.title, entry.fault.isEmpty() ? entry.detail : entry.fault});
    const QString path = QDir::toNativeSeparators(entry.path);
    const QString tip = entry.toolTip.isEmpty() ? path : entry.toolTip;
    for (int column = 0; column < ColumnCount; ++column) {
        row->setToolTip(column, entry.fault.isEmpty() ? tip : entry.fault + QLatin1Char('\n') + tip);
    }
    row->setData(Title, Qt::AccessibleTextRole,
                 QStringLiteral("%1, %2").arg(row->text(Title), row->text(Detail)));
    row->setForeground(Detail, palette().brush(QPalette::PlaceholderText));
    if (!entry.fault.isEmpty()) {
        row->setForeground(Title, palette().brush(QPalette::Disabled, QPalette::Text));
    }
}

const StartEntry* StartList::current() const {
    const int row = m_rows->indexOfTopLevelItem(m_rows->currentItem());
    return row < 0 ? nullptr : &m_entries[static_cast<std::size_t>(row)];
}

void StartList::fitRows() {
    const int row_px = std::max(m_rows->sizeHintForRow(0), m_rows->fontMetrics().height());
    const int count = std::max(1, static_cast<int>(m_entries.size()));
    m_rows->setFixedHeight(count * row_px + 2 * m_rows->frameWidth());
    m_rows->header()->setMaximumSectionSize(
        std::max(1, static_cast<int>(MostOfWidth_ratio * m_rows->viewport()->width())));
}

void StartList::refreshMenu() {
    m_open->setEnabled(current() != nullptr && current()->fault.isEmpty());
    if (m_folder != nullptr) {
        m_folder->setEnabled(m_open->isEnabled());
    }
}

void StartList::openCurrent() {
    const StartEntry* entry = current();
    if (entry == nullptr) {
        return;
    }
    m_message->clear();
    if (entry->fault.isEmpty()) {
        Q_EMIT openRequested(QString(entry->path)); // the answer may make the list anew
        return;
    }
    m_message->showMessage({widgets::Severity::Warning,
                            QStringLiteral("%1: %2").arg(entry->title, entry->fault),
                            QDir::toNativeSeparators(entry->path), tr("Remove from the list")});
}

void StartList::removeCurrent() {
    if (const StartEntry* entry = current()) {
        m_message->clear();
        Q_EMIT removeRequested(QString(entry->path));
    }
}

void StartList::openFolder() {
    if (const StartEntry* entry = current()) {
        QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(entry->path).absolutePath()));
    }
}

void StartList::copyPath() {
    if (const StartEntry* entry = current()) {
        QGuiApplication::clipboard()->setText(QDir::toNativeSeparators(entry->path));
    }
}

void StartList::showError(const QString& text, const QString& remedy) {
    m_message->showMessage({widgets::Severity::Error, text, remedy, {}});
}

void StartList::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fitRows();
    Q_EMIT shown();
}

void StartList::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitRows();
}

/// Another theme has other rows and colours.
void StartList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (m_rows != nullptr && (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange)) {
        setEntries(std::vector<StartEntry>(m_entries));
    }
}

} // namespace halbench::app
