#include "widgets/log/log_view.h"

#include "widgets/controls/action_button.h"
#include "widgets/language/whole_numbers.h"
#include "widgets/log/log_filter_model.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::widgets {

LogView::LogView(QWidget* parent)
    : QWidget(parent), m_model(new LogTableModel(this)), m_filter(new LogFilterModel(this)),
      m_search(new QLineEdit(this)), m_level(new QComboBox(this)), m_view(new QTableView(this)) {
    m_filter->setSourceModel(m_model);
    createActions();
    createView();
    layOut();
    connect(m_search, &QLineEdit::textChanged, m_filter, &LogFilterModel::setWords);
    connect(m_level, QOverload<int>::of(&QComboBox::activated), this,
            [this](int level) { m_filter->setLeast(static_cast<LogLevel>(level)); });
    retranslate();
    m_level->setCurrentIndex(static_cast<int>(LogLevel::Information));
}

void LogView::createActions() {
    m_copy = new QAction(themedIcon(QStringLiteral("copy")), QString(), this);
    m_copy->setShortcut(QKeySequence::Copy);
    m_copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_clear = new QAction(themedIcon(QStringLiteral("clear")), QString(), this);
    m_view->addActions({m_copy, m_clear}); // in the search line the keys copy its own words
    m_view->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(m_copy, &QAction::triggered, this, &LogView::copySelected);
    connect(m_clear, &QAction::triggered, m_model, &LogTableModel::clear);
}

void LogView::createView() {
    m_search->setClearButtonEnabled(true);
    m_view->setModel(m_filter);
    m_view->setItemDelegate(new WholeNumbers(m_view));
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setTabKeyNavigation(false);
    m_view->setShowGrid(false);
    m_view->setWordWrap(false);
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 2 * GridStep_px);
    m_view->horizontalHeader()->setStretchLastSection(true);
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    const QFontMetrics metrics(tabularFont(font()));
    const auto setWidth = [this, &metrics](int column, const QString& widest) {
        m_view->setColumnWidth(column, metrics.horizontalAdvance(widest) + GroupSpacing_px);
    };
    // A range that changes, by a new line or another size, is no scrolling by the user.
    QScrollBar* bar = m_view->verticalScrollBar();
    connect(bar, &QScrollBar::valueChanged, this,
            [this, bar](int value) { m_isFollowing = value >= bar->maximum(); });
    connect(bar, &QScrollBar::rangeChanged, this, [this, bar](int, int end) {
        if (m_isFollowing) {
            bar->setValue(end);
        }
    });
    setWidth(LogTableModel::ClockColumn, QStringLiteral("00:00:00"));
    setWidth(LogTableModel::TimeColumn, QStringLiteral("000,000.00"));
    setWidth(LogTableModel::LevelColumn, QStringLiteral("information"));
    setWidth(LogTableModel::SourceColumn, QStringLiteral("identification"));
}

void LogView::layOut() {
    auto* row = new QHBoxLayout;
    row->setSpacing(PanelMargin_px);
    row->addWidget(m_search, 1);
    row->addWidget(m_level);
    row->addWidget(new ActionButton(*m_copy, ActionButton::Shape::IconOnly, this));
    row->addWidget(new ActionButton(*m_clear, ActionButton::Shape::IconOnly, this));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(PanelMargin_px, PanelMargin_px, PanelMargin_px, PanelMargin_px);
    column->setSpacing(PanelMargin_px);
    column->addLayout(row);
    column->addWidget(m_view, 1);
}

void LogView::append(const std::vector<LogEntry>& entries) {
    m_model->append(entries);
}

QString LogView::text() const {
    QStringList lines;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        lines << m_model->lineText(row);
    }
    return lines.join(QLatin1Char('\n'));
}

void LogView::copySelected() {
    QModelIndexList rows = m_view->selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end());
    QStringList lines;
    if (rows.isEmpty()) { // nothing chosen: all that is shown
        for (int row = 0; row < m_filter->rowCount(); ++row) {
            lines << m_model->lineText(m_filter->mapToSource(m_filter->index(row, 0)).row());
        }
    }
    for (const QModelIndex& row : rows) {
        lines << m_model->lineText(m_filter->mapToSource(row).row());
    }
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

void LogView::retranslate() {
    m_search->setPlaceholderText(tr("Filter messages"));
    m_search->setToolTip(tr("Show only messages with this text"));
    m_search->setAccessibleName(tr("Filter messages"));
    const int level = m_level->currentIndex();
    m_level->clear();
    m_level->addItems({tr("Everything"), tr("Info and above"), tr("Warnings and errors"), tr("Errors")});
    m_level->setCurrentIndex(qMax(0, level));
    m_level->setToolTip(tr("Lowest level of messages shown"));
    m_level->setAccessibleName(tr("Level of messages"));
    m_copy->setText(tr("Copy"));
    m_copy->setToolTip(tr("Copy the selected messages, or all that are shown (%1)")
                           .arg(m_copy->shortcut().toString(QKeySequence::NativeText)));
    m_clear->setText(tr("Clear"));
    m_clear->setToolTip(tr("Delete all messages"));
    m_view->setAccessibleName(tr("Log"));
}

void LogView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

} // namespace halbench::widgets
