#pragma once

#include "widgets/live_plot/legend_table_model.h"

#include <QPixmap>
#include <QTableView>

#include <array>
#include <optional>
#include <string>

class QAction;
class QMenu;

namespace halbench::widgets {

/// The curves of one plot with their live values; keys and a menu are for the chosen one: Space hides or
/// shows it, F2 names it, Ctrl+C copies its value, R puts it on the other axis, U offers its units, Ctrl and
/// an arrow key puts it into the plot on that side, Ctrl+Shift+Down and Ctrl+Shift+Right into one of its own
/// below or beside, Delete takes it away.
class LiveLegend : public QTableView {
    Q_OBJECT
public:
    /// Widths of the columns, shared by all legends of a stack so that their plots align; that of the name is
    /// what it would like to have.
    using Widths = std::array<int, LegendTableModel::Columns>;

    explicit LiveLegend(QWidget* parent = nullptr);

    LegendTableModel& table() { return m_table; }
    void setTheme(const Theme& theme);
    /// `hasHeader`: with names above the columns, which the topmost legend of a stack says for all.
    void setCursorColumnsShown(bool areShown, bool hasHeader);
    /// What this legend's numbers and units need and what its names would like; they get what remains.
    Widths neededWidths() const;
    /// Of the column of the names: what tells them apart, and its title where that is shown.
    int leastNameWidth() const;
    void setWidths(const Widths& widths, int total_px);
    /// Below its plot it is as wide as that and as high as its curves need.
    void setBelow(bool isBelow);
    /// Inside its plot it stands over the canvas, as high as its curves need and the canvas has; the curves
    /// shine through.
    void setInside(const QRect& canvas, int width_px);
    /// At each frame: keeps what a legend in its plot looks like, for all paint events until it looks
    /// different. The canvas below it is drawn anew thirty times a second, its numbers change ten times.
    void keepPicture();

Q_SIGNALS:
    void toggleRequested(int curve);
    void removeRequested(int curve);
    void axisRequested(int curve);               ///< the other one
    void moveRequested(int curve, int by);       ///< into the plot so many below
    void moveBesideRequested(int curve, int by); ///< into the one so many columns to the right
    void separateRequested(int curve);           ///< into a new plot below
    void separateBesideRequested(int curve);     ///< into a new plot in a new column at the right
    void colourRequested(int curve,
                         std::optional<int> colour); ///< of the theme's; none: automatic, as the line
    void lineRequested(int curve, LinePattern pattern);
    void unitRequested(int curve, const std::string& key);

protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void dataChanged(const QModelIndex& from, const QModelIndex& to, const QVector<int>& roles) override;
    void reset() override;
    void scrollContentsBy(int dx, int dy) override;
    void selectionChanged(const QItemSelection& chosen, const QItemSelection& before) override;
    void currentChanged(const QModelIndex& now, const QModelIndex& before) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    bool run(const QKeySequence& keys);
    QMenu* makeUnitMenu(int row);
    void showUnits(int row);
    void copy(int row) const;
    void addMoves(QMenu& menu);
    QAction* addKey(QMenu& menu, const QString& text, const QKeySequence& keys);

    int headerHeight() const;
    int wantedHeight(int rows) const;
    void fitRows(int height_px);
    void drop() { m_picture = QPixmap(); }

    LegendTableModel m_table;
    Theme m_theme;
    bool m_isBelow = false;
    bool m_isInside = false;
    QPixmap m_picture; ///< null: out of date
    bool m_isKeeping = false;
};

} // namespace halbench::widgets
