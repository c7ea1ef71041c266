#pragma once

#include "control/history/sample_history.h"
#include "widgets/live_plot/axes/time_view.h"
#include "widgets/live_plot/live_plot_spec.h"
#include "widgets/live_plot/plot_marks.h"
#include "widgets/live_plot/reference_traces.h"
#include "widgets/live_plot/signal_colours.h"
#include "widgets/theme/theme.h"

#include <QStringList>
#include <QWidget>

#include <map>
#include <optional>
#include <utility>
#include <vector>

class QAction;
class QBoxLayout;
class QTimer;

namespace halbench::widgets {

class CursorBar;
class LiveLegend;
class LivePlot;
class MarkerBar;
class ShareSplitter;
class TimeAxisBar;

/// Plots above and beside each other over one time axis, fed from a history: what the Monitor shows. Lives in
/// the window's thread. One timer draws all plots, 30 times a second at most and only when something changed;
/// the owner brings new blocks into the history when frameStarting() is emitted.
///
///     wheel              zoom time at the pointer; with Ctrl the values
///     left drag          zoom into a box           Ctrl + left drag, middle drag   pan
///     double click, F    fit: the values while following, else all of the history
///     Backspace          zoom back                 Home                            all of the history
///     Ctrl + plus, minus zoom the values           Up, Down (Shift)                scroll them
///     Shift+F            fit the values of the plot with the focus
///     Space              pause, data are kept      End                             follow the newest sample
///     C                  cursors; arrows move the active one, Shift coarsely, A and B choose it
///     N, Shift+N         another pair of cursors, removes the pair that measures
///     P, Shift+P         the next pair, the one before; F2 names it
///     G, Shift+C         the view goes to the pair, the pair comes into the view
///     M, Shift+M         marker, with a note       Insert                          add signals
///     J, Shift+J         the next marker, the one before; Delete removes it, Ctrl+J lists all
///     O, Shift+O         the plot has its own time axis or not, one time axis for all
///     L, Shift+L         the plot goes into the column at the right, at the left
///     Ctrl+Shift+Right   a new plot in a column of its own, at the right
///     Shift+Delete       the plot goes
///     V, W (Shift)       the plot gets taller, its column wider (less so); E: all equally large
///     K, Shift+K         keep what is shown as faint reference, remove it
///
/// Where a plot has its own time axis, keys act on that axis while the plot or its legend has the focus, and
/// on the one of all other plots elsewhere; pause holds all of them.
///
/// In a legend, by its menu too: F2 names the chosen curve, its menu has colour and line; R puts the chosen
/// curve on the other axis, U offers its units, Ctrl and an arrow key puts it into the plot on that side, on
/// the axis that has its unit or is free, Ctrl+Shift+Down and Ctrl+Shift+Right into a plot of its own.
///
/// Columns stand beside each other, each with its own axis below that shows the same time. plots() has them
/// from left to right, the plots of one from top to bottom, with the shares of the room that the user gave
/// them. A column goes with its last plot.
///
/// A list without plots becomes one empty plot, which says what it is for.
class LivePlotStack : public QWidget {
    Q_OBJECT
public:
    enum class Command {
        Pause,
        Follow,
        Fit,
        ShowAll,
        ZoomBack,
        ZoomIn,
        ZoomOut,
        ScrollBack,
        ScrollOn,
        ZoomValuesIn,
        ZoomValuesOut,
        FitValues,
        Cursors,
        CursorA,
        CursorB,
        NewPair,
        RemovePair,
        NextPair,
        PreviousPair,
        NamePair,
        ShowPair,
        PairHere,
        Marker,
        MarkerNote,
        NextMarker,
        PreviousMarker,
        RemoveMarker,
        ListMarkers,
        KeepReference,
        RemoveReference,
        OwnTime,
        OneTimeAxis,
        PlotRight,
        PlotLeft,
        NewBeside,
        RemovePlot,
        Taller,
        Shorter,
        Wider,
        Narrower,
        EqualSizes,
        AddSignals
    };

    explicit LivePlotStack(QWidget* parent = nullptr);
    ~LivePlotStack() override;

    /// Not owned; must outlive the stack or be replaced. May be null.
    void setHistory(const control::SampleHistory* history);
    const control::SampleHistory* history() const { return m_history; }
    void setPlots(std::vector<PlotSpec> plots);
    const std::vector<PlotSpec>& plots() const { return m_specs; }
    /// Of the signals of all plots.
    const SignalColours& colours() const { return m_colours; }
    /// Colour, line and name of signals as the user wants them; those that are not shown keep theirs.
    void setLooks(CurveLooks looks);
    const CurveLooks& looks() const { return m_looks; }
    /// Adds to a plot, or as a new plot below when `plot` is none of them. A signal is shown once in a plot.
    void addCurve(int plot, const PlotCurve& curve);
    void removeCurve(int plot, const std::string& signal);
    /// A new plot at that place, 0 to as many as there are, in the column of the one before it; those from
    /// there on go down, with their time axes.
    void openPlot(int at, PlotSpec plot);
    /// To the other side of its plot, or into another one. False: no axis there takes it.
    bool moveToAxis(int plot, const std::string& signal, bool isRight);
    bool moveCurve(int plot, const std::string& signal, int to);
    /// Into a new plot below its own. False: it is alone there already.
    bool separateCurve(int plot, const std::string& signal);
    /// Into a new plot in a new column, right of its own. False: that is how it stands already.
    bool separateBeside(int plot, const std::string& signal);
    /// In one of its units, by key (curve_units.h says where it is seen then). False: nothing changed.
    bool showInUnit(int plot, const std::string& signal, const std::string& unit);
    /// A plot in a new column, right of that plot's. Its index.
    int openBeside(int plot, PlotSpec added);
    /// Into the column beside its own, a new one beyond the outermost. False: it is alone in that.
    bool movePlot(int plot, int by);
    void removePlot(int plot);
    int columnCount() const { return static_cast<int>(m_columns.size()); }
    /// Wears the application's theme from the start and when it changes; this is for another.
    void setTheme(const Theme& theme);

    /// Since when nothing is updated any more, in words; empty: it is.
    void setStale(const QString& words);
    /// False: nothing is added to the history, as to that of a recording; there is nothing to follow.
    void setLive(bool isLive);
    void setFollowing(bool isFollowing);
    bool isFollowing() const { return m_view.isFollowing(); }
    void setPaused(bool isPaused);
    bool isPaused() const { return m_view.isPaused(); }
    void fitAll();
    void zoomBack();
    /// Length of the shown stretch of time.
    void setTimeSpan(double length_s);
    const control::TimeRange& timeRange() const { return m_view.range(); }
    /// What this plot shows, which has its own time axis or not.
    const control::TimeRange& timeRange(int plot) const { return viewOf(plot).range(); }
    /// As it is now; none: it shares the time axis of the stack.
    std::optional<OwnTime> ownTime(int plot) const;
    void setOwnTime(int plot, const std::optional<OwnTime>& own);
    /// Whether any plot has its own.
    bool hasOwnTimes() const;
    /// Those on the time axis that keys act on.
    std::vector<int> plotsOfActiveAxis() const;
    void showTimeRange(control::TimeRange range);
    /// The values' axes fit the next data at once, also inwards; those that the user holds stay, unless what
    /// is shown has nothing to do with what was.
    void rescale(bool keepsHeld);
    ValueRange valueRange(int plot, bool isRight = false) const;
    /// Where the user holds an axis of values; none: it follows the data.
    std::optional<ValueRange> heldRange(int plot, bool isRight = false) const;

    void setCursorsVisible(bool areVisible);
    /// The pair that measures.
    CursorPair cursors() const { return m_pairs.cursors(); }
    const CursorPairs& cursorPairs() const { return m_pairs; }
    void setCursorPairs(CursorPairs pairs);
    void setCursor(int index, double time_s);
    /// The moment of a trigger's event, from which the time axis counts while it is given.
    void setEvent(std::optional<double> event_s);
    const std::optional<double>& event_s() const { return m_event_s; }
    /// Where a trigger waits; drawn in the plots of its signal, where it can be dragged.
    void setLevel(const std::optional<PlotLevel>& level);
    const std::optional<PlotLevel>& level() const { return m_level; }
    void setMarkers(std::vector<PlotMarker> markers);
    const std::vector<PlotMarker>& markers() const { return m_markers; }
    void addMarker(PlotMarker marker);
    /// The one whose note is in the row below the plots; its place in the list.
    std::optional<std::size_t> chosenMarker() const { return m_chosenMarker; }
    void chooseMarker(std::optional<std::size_t> marker);
    /// Whether markers can be dropped, noted and removed.
    void setMarkersEditable(bool areEditable);

    /// What is in view of the curves that are shown becomes the reference.
    void keepReference();
    /// Null: none.
    void setReference(ReferencePtr reference);
    const ReferencePtr& reference() const { return m_reference; }
    /// How much later it is drawn than it was.
    double referenceShift_s() const;

    /// Draws now if something changed; otherwise the timer does.
    void refresh();
    /// For tool bars and menus: text, shortcut and tooltip are set.
    QAction* action(Command command) const { return m_actions.at(command); }

Q_SIGNALS:
    void frameStarting();
    /// `plot`: index into plots(), -1 for below the plots.
    void signalsDropped(int plot, QStringList names);
    void signalsDroppedBeside(int plot, QStringList names); ///< at the right edge of that plot
    /// Insert was pressed.
    void addSignalsRequested(int plot);
    void plotsChanged(); ///< by the user, e.g. a curve was removed
    void pausedChanged(bool isPaused);
    void followingChanged(bool isFollowing);
    void cursorsChanged();
    void markersChanged();
    void levelMoved(double level); ///< by the mouse, in SI
    void referenceChanged();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QWidget* box = nullptr;
        LivePlot* plot = nullptr;
        LiveLegend* legend = nullptr;
        QBoxLayout* parts = nullptr; ///< plot and, in a narrow column, its legend below
        TimeAxisBar* timeAxis = nullptr;
        std::optional<TimeView> time = {}; ///< where it has its own axis
        bool isConfigured = false;
    };
    struct Column {
        QWidget* box = nullptr;
        ShareSplitter* rows = nullptr;
        TimeAxisBar* timeAxis = nullptr; ///< of the plots that share the stack's
        int count = 0;                   ///< of plots, when they were placed last
        int extent_px = 0;               ///< what the labels of its axes needed so far
        int rightExtent_px = 0;
    };
    struct Snapshot { ///< an entry of the zoom history
        TimeView view;
        std::vector<std::pair<std::optional<ValueRange>, std::optional<ValueRange>>> values;
        std::vector<std::optional<TimeView>> ownTimes;
    };
    void createActions();
    void addAction(Command command, const QString& text, const QString& shortcut, const QString& what);
    void run(Command command);
    Row makeRow();
    Column makeColumn();
    void connectPlot(LivePlot* plot);
    void connectLegend(LivePlot* plot, LiveLegend* legend);
    void connectLooks(LivePlot* plot, LiveLegend* legend);
    void nameCurves();
    void connectUnits(LivePlot* plot, LiveLegend* legend);
    int indexOf(const LivePlot* plot) const;
    void choose(int plot, const std::string& signal);
    void matchRows();
    void addRow(std::size_t at);
    void removeRow(std::size_t at);
    void place();
    void matchColumns(std::size_t count);
    void shareRoom();
    void takeHeights(const ShareSplitter& rows);
    void runOnSizes(Command command);
    void createSizeActions();
    void put(int plot, int column, std::ptrdiff_t position);
    void chainFocus() const;
    void shapeChanged();
    std::vector<const Row*> rowsOf(int column) const;
    std::optional<int> plotBeside(int plot, int by) const;
    std::optional<PlotSpec> ownPlotOf(int plot, const std::string& signal) const;
    void moveAndChoose(int plot, const std::string& signal, std::optional<int> to);
    void runOnPlots(Command command);
    void createPlotActions();
    void configureRow(std::size_t index);
    void fitTitles(int column);
    void align(int column);
    bool placeLegends(int column, int wanted_px);
    void updateViews();
    void drawFrame();
    void showState();
    bool showNumbers();
    void remember();
    const TimeView& viewOf(int plot) const;
    TimeView& viewOf(int plot) { return const_cast<TimeView&>(std::as_const(*this).viewOf(plot)); }
    int axisPlot() const;
    TimeView& activeView();
    const TimeView& activeView() const;
    void createTimeActions();
    void runOnTime(Command command);
    void toggleOwnTime(int plot);
    void shareTime();
    void matchTime(std::size_t index);
    void zoomTime(TimeView& view, double factor, double at_s);
    void changed(bool wasFollowing, bool wasPaused);
    void showChecks();
    void connectCursorBar();
    void createCursorActions();
    void runOnPairs(Command command);
    control::TimeRange thirdsOfView() const;
    void showPair();
    void namePair(const QString& name);
    void placeCursors();
    void moveCursor(int columns);
    void createValueActions();
    void runOnValues(Command command);
    void scrollValues(int sign, bool isCoarse);
    void showValues(int plot, const ValueRange& left);
    std::optional<double> samplePeriod_s() const;
    void createMarkerActions();
    void connectMarkerBar();
    void runOnMarkers(Command command);
    std::size_t dropMarker();
    void noteMarker();
    void goToMarker(std::optional<std::size_t> marker);
    void setNote(const QString& note);
    void removeMarker();
    void changeMarkers(std::vector<PlotMarker> markers);
    void cancelNote();
    double markedTime_s() const;
    void placeMarkers();
    std::optional<int> focusedPlot() const;
    int activePlot() const { return focusedPlot().value_or(0); }
    int deviceColumns(int column) const;
    double timeStep_s(const TimeView& view, int column) const;
    void drawColumn(int column);
    QString stateWords() const;
    void showOwnState(const Row& row);

    const control::SampleHistory* m_history = nullptr;
    Theme m_theme;
    std::vector<PlotSpec> m_specs;
    SignalColours m_colours;
    CurveLooks m_looks;
    std::vector<Row> m_rows;
    TimeView m_view;
    CursorPairs m_pairs;
    std::vector<PlotMarker> m_markers;
    std::optional<std::size_t> m_chosenMarker;
    bool m_isMarkerNew = false; ///< dropped for the note that is being typed
    bool m_areMarkersEditable = true;
    bool m_isLive = true;
    std::optional<double> m_event_s;
    std::optional<PlotLevel> m_level;
    ReferencePtr m_reference;
    std::vector<Snapshot> m_zoomHistory;
    bool m_isWheeling = false; ///< turns of the wheel in a row are one step of the zoom history
    std::map<Command, QAction*> m_actions;
    ShareSplitter* m_splitter; ///< of the columns
    std::vector<Column> m_columns;
    CursorBar* m_cursorBar;
    MarkerBar* m_markerBar;
    QTimer* m_timer;
    std::optional<std::uint64_t> m_drawnRevision;
    QString m_stale;
    bool m_isDirty = true;
    int m_framesSinceNumbers = 0;
    bool m_areNumbersWhole = true;
};

} // namespace halbench::widgets
