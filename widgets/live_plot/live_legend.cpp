#include "widgets/live_plot/live_legend.h"

#include "widgets/live_plot/look_menu.h"
#include "widgets/live_plot/unit_menu.h"

#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QItemSelection>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMenu>
#include <QPaintEvent>
#include <QPainter>
#include <QScrollBar>

#include <algorithm>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr int CellPadding = 8;
constexpr int InsideAlpha = 216;   ///< of 255: numbers stay readable over curves
constexpr int MostRowsBelow = 4;   ///< of a legend below its plot; further ones are scrolled to
constexpr int LongestName = 22;    ///< characters of a curve's name before it is shortened
constexpr int LineSampleRoom = 40; ///< beside the name
constexpr int LeastLetters = 6;    ///< of a shortened name
constexpr int RowPadding = 6;      ///< of a row, beyond the height of its letters

/// The beginning that no other of the names has, and dots for the rest.
QString tellingPart(const QString& name, const QStringList& names) {
    int shared = LeastLetters - 1;
    for (const QString& other : names) {
        const auto parting = std::mismatch(name.begin(), name.end(), other.begin(), other.end()).first;
        shared = std::max(shared, static_cast<int>(parting - name.begin()));
    }
    return shared + 2 < name.size() ? name.left(shared + 1) + QChar(0x2026) : name;
}

} // namespace

LiveLegend::LiveLegend(QWidget* parent) : QTableView(parent) {
    setModel(&m_table);
    setFrameShape(QFrame::NoFrame);
    setProperty("surface", QStringLiteral("legend")); // part of its plot: no border of its own
    setShowGrid(false);
    setWordWrap(false);
    setTextElideMode(Qt::ElideRight);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTabKeyNavigation(false); // Tab leaves the legend
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + RowPadding);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setMinimumSectionSize(8);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setTextElideMode(Qt::ElideRight); // a narrow name's column says so
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, &LiveLegend::drop);
    setCursorColumnsShown(false, false);
    setAccessibleName(tr("Legend with live values"));
    setAccessibleDescription(
        tr("Space hides or shows the curve, F2 renames it, R changes its axis, U its "
           "unit, Ctrl with an arrow key moves it to the next plot, Ctrl+Shift+Down to a new plot, "
           "Ctrl+Shift+Right to a new plot beside, Delete removes it."));
    setToolTip(accessibleDescription());
    connect(this, &QTableView::doubleClicked, this,
            [this](const QModelIndex& index) { Q_EMIT toggleRequested(index.row()); });
}

void LiveLegend::setTheme(const Theme& theme) {
    m_table.setTheme(theme);
    m_theme = theme;
    drop();
    viewport()->update();
}

/// The sheet leaves the ground to the legend: in a plot the curves shine through it.
void LiveLegend::paintEvent(QPaintEvent* event) {
    if (!m_picture.isNull() && !m_isKeeping) {
        QPainter(viewport()).drawPixmap(0, 0, m_picture);
        return;
    }
    QColor ground = m_isInside ? m_theme.plotBackground : m_theme.panel;
    ground.setAlpha(m_isInside ? InsideAlpha : 255);
    QPainter(viewport()).fillRect(event->rect(), ground);
    QTableView::paintEvent(event);
}

void LiveLegend::keepPicture() {
    if (!m_isInside || !m_picture.isNull() || !isVisible()) {
        return;
    }
    const double ratio = devicePixelRatioF();
    QPixmap picture(viewport()->size() * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    m_isKeeping = true;
    viewport()->render(&picture, QPoint(), QRegion(), QWidget::RenderFlags());
    m_isKeeping = false;
    m_picture = picture;
}

/// Whatever happens to the view but painting may change how it looks.
bool LiveLegend::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::Paint) {
        drop();
    }
    return QTableView::viewportEvent(event);
}

void LiveLegend::dataChanged(const QModelIndex& from, const QModelIndex& to, const QVector<int>& roles) {
    drop();
    QTableView::dataChanged(from, to, roles);
}

void LiveLegend::reset() {
    drop();
    QTableView::reset();
}

void LiveLegend::scrollContentsBy(int dx, int dy) {
    drop();
    QTableView::scrollContentsBy(dx, dy);
}

void LiveLegend::selectionChanged(const QItemSelection& chosen, const QItemSelection& before) {
    drop();
    QTableView::selectionChanged(chosen, before);
}

void LiveLegend::currentChanged(const QModelIndex& now, const QModelIndex& before) {
    drop();
    QTableView::currentChanged(now, before);
}

void LiveLegend::setCursorColumnsShown(bool areShown, bool hasHeader) {
    for (const int column : {LegendTableModel::AtA, LegendTableModel::AtB, LegendTableModel::Difference}) {
        setColumnHidden(column, !areShown);
    }
    horizontalHeader()->setVisible(areShown && hasHeader);
}

LiveLegend::Widths LiveLegend::neededWidths() const {
    Widths widths{};
    for (int row = 0; row < m_table.rowCount(); ++row) {
        const QString name = m_table.widestText(row, LegendTableModel::Name);
        const int name_px =
            std::min(fontMetrics().horizontalAdvance(name), LongestName * fontMetrics().averageCharWidth());
        widths[LegendTableModel::Name] = std::max(widths[LegendTableModel::Name], name_px + LineSampleRoom);
        for (int column = LegendTableModel::Value; column < LegendTableModel::Columns; ++column) {
            const QString text = m_table.widestText(row, static_cast<LegendTableModel::Column>(column));
            int& width = widths[static_cast<std::size_t>(column)];
            width = std::max(width, fontMetrics().horizontalAdvance(text) + CellPadding);
        }
    }
    return widths;
}

int LiveLegend::leastNameWidth() const {
    QStringList names;
    for (int row = 0; row < m_table.rowCount(); ++row) {
        names << m_table.widestText(row, LegendTableModel::Name);
    }
    int width = 0;
    for (int row = 0; row < names.size(); ++row) {
        QStringList others = names;
        others.removeAt(row);
        const QString part = tellingPart(names[row], others);
        width = std::max(width, fontMetrics().horizontalAdvance(part) + LineSampleRoom);
    }
    return std::max(width, horizontalHeader()->isHidden()
                               ? 0
                               : horizontalHeader()->sectionSizeHint(LegendTableModel::Name));
}

void LiveLegend::setWidths(const Widths& widths, int total_px) {
    int rest = total_px - 2 * frameWidth();
    rest -= verticalScrollBar()->isVisible() ? verticalScrollBar()->width() : 0;
    for (int column = LegendTableModel::Value; column < LegendTableModel::Columns; ++column) {
        const bool isCounted = column == LegendTableModel::Value || !isColumnHidden(column);
        setColumnWidth(column, widths[static_cast<std::size_t>(column)]);
        rest -= isCounted ? widths[static_cast<std::size_t>(column)] : 0;
    }
    // Beside the values at both cursors in a narrow column, the live one goes before the names do.
    const bool isNowHidden = !isColumnHidden(LegendTableModel::AtA) && rest < widths[LegendTableModel::Name];
    rest += isNowHidden ? widths[LegendTableModel::Value] : 0;
    setColumnHidden(LegendTableModel::Value, isNowHidden);
    setColumnWidth(LegendTableModel::Name, std::max(rest, 0));
    setMinimumWidth(m_isBelow ? 0 : total_px);
    setMaximumWidth(m_isBelow ? QWIDGETSIZE_MAX : total_px);
}

void LiveLegend::setBelow(bool isBelow) {
    m_isBelow = isBelow;
    if (isBelow && std::exchange(m_isInside, false)) {
        drop();
        viewport()->update();
    }
    if (isBelow) {
        verticalHeader()->setDefaultSectionSize(fontMetrics().height() + RowPadding);
    }
    const int height_px = wantedHeight(std::clamp(m_table.rowCount(), 1, MostRowsBelow));
    setMinimumHeight(isBelow ? height_px : 0);
    setMaximumHeight(isBelow ? height_px : QWIDGETSIZE_MAX);
}

int LiveLegend::headerHeight() const {
    return horizontalHeader()->isHidden() ? 0 : horizontalHeader()->sizeHint().height();
}

int LiveLegend::wantedHeight(int rows) const {
    return headerHeight() + rows * verticalHeader()->defaultSectionSize() + 2 * frameWidth();
}

/// As high as reads well; closer together where all rows have room then.
void LiveLegend::fitRows(int height_px) {
    const int tight_px = fontMetrics().height();
    verticalHeader()->setMinimumSectionSize(tight_px);
    const int rows = std::max(m_table.rowCount(), 1);
    const int each_px = (height_px - headerHeight() - 2 * frameWidth()) / rows;
    const int row_px = each_px < tight_px ? tight_px + RowPadding : std::min(each_px, tight_px + RowPadding);
    if (row_px != verticalHeader()->defaultSectionSize()) {
        verticalHeader()->setDefaultSectionSize(row_px);
    }
}

void LiveLegend::setInside(const QRect& canvas, int width_px) {
    if (!std::exchange(m_isInside, true)) {
        drop();
        viewport()->update();
    }
    fitRows(canvas.height());
    int rows = m_table.rowCount(); // whole ones; further ones are scrolled to
    while (rows > 1 && wantedHeight(rows) > canvas.height()) {
        --rows;
    }
    const int height_px = std::min(wantedHeight(rows), canvas.height());
    const QRect place(canvas.topLeft(), QSize(std::min(width_px, canvas.width()), height_px));
    setVisible(m_table.rowCount() > 0);
    if (geometry() != place) {
        setGeometry(place);
        raise();
    }
}

/// What a key does with the chosen curve; false: nothing.
bool LiveLegend::run(const QKeySequence& keys) {
    const int row = currentIndex().row();
    if (row < 0) {
        return false;
    }
    if (keys == QKeySequence(Qt::Key_Space)) {
        Q_EMIT toggleRequested(row);
    } else if (keys == QKeySequence(Qt::Key_F2)) {
        edit(m_table.index(row, LegendTableModel::Name));
    } else if (keys == QKeySequence(QKeySequence::Copy)) {
        copy(row);
    } else if (keys == QKeySequence(Qt::Key_R)) {
        Q_EMIT axisRequested(row);
    } else if (keys == QKeySequence(Qt::Key_U)) {
        showUnits(row);
    } else if (keys == QKeySequence(QStringLiteral("Ctrl+Up"))) {
        Q_EMIT moveRequested(row, -1);
    } else if (keys == QKeySequence(QStringLiteral("Ctrl+Down"))) {
        Q_EMIT moveRequested(row, 1);
    } else if (keys == QKeySequence(QStringLiteral("Ctrl+Left"))) {
        Q_EMIT moveBesideRequested(row, -1);
    } else if (keys == QKeySequence(QStringLiteral("Ctrl+Right"))) {
        Q_EMIT moveBesideRequested(row, 1);
    } else if (keys == QKeySequence(QStringLiteral("Ctrl+Shift+Down"))) {
        Q_EMIT separateRequested(row);
    } else if (keys == QKeySequence(QStringLiteral("Ctrl+Shift+Right"))) {
        Q_EMIT separateBesideRequested(row);
    } else if (keys == QKeySequence(Qt::Key_Delete)) {
        Q_EMIT removeRequested(row);
    } else {
        return false;
    }
    return true;
}

bool LiveLegend::event(QEvent* event) {
    if (event->type() != QEvent::Paint) {
        drop(); // focus, style, font, size
    }
    if (event->type() == QEvent::ShortcutOverride) { // they are the stack's elsewhere, as Space is its pause
        const auto* press = static_cast<QKeyEvent*>(event);
        const int key = press->key();
        const auto modifiers = press->modifiers() & ~Qt::KeypadModifier;
        const bool isPlain =
            modifiers == Qt::NoModifier && (key == Qt::Key_Space || key == Qt::Key_Delete ||
                                            key == Qt::Key_R || key == Qt::Key_U || key == Qt::Key_F2);
        const bool isBeside = modifiers == (Qt::ControlModifier | Qt::ShiftModifier) && key == Qt::Key_Right;
        const bool isCopy = press->matches(QKeySequence::Copy);
        if (currentIndex().isValid() && (isPlain || isBeside || isCopy)) {
            event->accept();
            return true;
        }
    }
    return QTableView::event(event);
}

void LiveLegend::keyPressEvent(QKeyEvent* event) {
    const int modifiers = static_cast<int>(event->modifiers() & ~Qt::KeypadModifier);
    if (!run(QKeySequence(event->key() | modifiers))) {
        QTableView::keyPressEvent(event);
    }
}

/// Null where there is nothing to choose.
QMenu* LiveLegend::makeUnitMenu(int row) {
    return unitMenu(m_table.curve(row), *this,
                    [this, row](const std::string& unit) { Q_EMIT unitRequested(row, unit); });
}

/// Below the chosen curve, from its unit on.
void LiveLegend::showUnits(int row) {
    if (QMenu* units = makeUnitMenu(row)) {
        units->setAttribute(Qt::WA_DeleteOnClose);
        units->popup(viewport()->mapToGlobal(visualRect(currentIndex()).bottomLeft()));
    }
}

/// Name, value and unit of the row as they are shown.
void LiveLegend::copy(int row) const {
    QStringList texts;
    for (const auto column : {LegendTableModel::Name, LegendTableModel::Value, LegendTableModel::Unit}) {
        texts << m_table.index(row, column).data().toString();
    }
    QGuiApplication::clipboard()->setText(texts.join(QLatin1Char('\t')));
}

QAction* LiveLegend::addKey(QMenu& menu, const QString& text, const QKeySequence& keys) {
    QAction* action = menu.addAction(text);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, [this, keys] { run(keys); });
    return action;
}

void LiveLegend::addMoves(QMenu& menu) {
    addKey(menu, tr("Plot above"), QKeySequence(QStringLiteral("Ctrl+Up")));
    addKey(menu, tr("Plot below"), QKeySequence(QStringLiteral("Ctrl+Down")));
    addKey(menu, tr("Plot on the left"), QKeySequence(QStringLiteral("Ctrl+Left")));
    addKey(menu, tr("Plot on the right"), QKeySequence(QStringLiteral("Ctrl+Right")));
    menu.addSeparator();
    addKey(menu, tr("New plot"), QKeySequence(QStringLiteral("Ctrl+Shift+Down")));
    addKey(menu, tr("New plot on the right"), QKeySequence(QStringLiteral("Ctrl+Shift+Right")));
}

void LiveLegend::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() == QContextMenuEvent::Mouse) {
        setCurrentIndex(indexAt(event->pos()));
    }
    const int row = currentIndex().row();
    if (row < 0) {
        return;
    }
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setAccessibleName(tr("Selected curve"));
    addKey(*menu, m_table.isShown(row) ? tr("Hide") : tr("Show"), QKeySequence(Qt::Key_Space));
    addKey(*menu, tr("Rename"), QKeySequence(Qt::Key_F2));
    menu->addMenu(colourMenu(m_table.item(row), m_theme, *this, [this, row](std::optional<int> colour) {
        Q_EMIT colourRequested(row, colour);
    }));
    menu->addMenu(lineMenu(m_table.item(row), m_theme, *this,
                           [this, row](LinePattern pattern) { Q_EMIT lineRequested(row, pattern); }));
    menu->addSeparator();
    addKey(*menu, m_table.isRight(row) ? tr("Use left axis") : tr("Use right axis"), QKeySequence(Qt::Key_R));
    if (QMenu* units = makeUnitMenu(row)) {
        menu->addMenu(units)->setText(tr("Unit") + QStringLiteral("\tU"));
    }
    addMoves(*menu->addMenu(tr("Move to")));
    menu->addSeparator();
    addKey(*menu, tr("Copy value"), QKeySequence(QKeySequence::Copy));
    addKey(*menu, tr("Remove from the plot"), QKeySequence(Qt::Key_Delete));
    menu->popup(event->globalPos());
}

} // namespace halbench::widgets
