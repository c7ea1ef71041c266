#pragma once

#include "control/history/sample_history.h"
#include "widgets/live_plot/history_curve.h"
#include "widgets/live_plot/live_plot_spec.h"
#include "widgets/live_plot/plot_marks.h"
#include "widgets/live_plot/reference_traces.h"
#include "widgets/live_plot/signal_colours.h"
#include "widgets/theme/theme.h"

#include <QImage>
#include <QStringList>
#include <qwt_plot.h>

#include <memory>
#include <optional>
#include <vector>

namespace halbench::widgets {

class ValueScaleDraw;

/// How an axis title is written: the unit behind the quantity or below it, in letters of a part of the font's
/// size.
struct TitleForm {
    bool isUnitBelow = false;
    double size_ratio = 1.0;
    bool operator==(const TitleForm&) const = default;
};

/// Ranges in which the user holds the axes of values; nothing while they follow the data.
struct HeldRanges {
    std::optional<ValueRange> left;
    std::optional<ValueRange> right;
};

/// One plot of a stack: curves from the history over the stack's time axis. It decides nothing about time:
/// the stack tells it which stretch to show, and it tells the stack what the user did. Window thread.
class LivePlot : public QwtPlot {
    Q_OBJECT
public:
    explicit LivePlot(QWidget* parent = nullptr);
    ~LivePlot() override;

    /// `colours`: of the signals; those it does not know are coloured by their position in the plot.
    void setSpec(const PlotSpec& spec, const control::SampleHistory* history,
                 const SignalColours& colours = {});
    /// Colours, patterns and names of its curves anew; zoom and hidden curves stay.
    void setLooks(const SignalColours& colours, const CurveLooks& looks);
    const PlotSpec& spec() const { return m_spec; }
    const control::SampleHistory* history() const { return m_history; }
    void setTheme(const Theme& theme);
    const std::vector<HistoryCurve*>& curves() const { return m_curves; }

    /// One frame: `view` on the axis, `drawn` of it with curves. Repaints when the event loop comes to it.
    void showFrame(control::TimeRange view, double timeStep_s, control::TimeRange drawn);
    /// The moment from which the time axis counts; its grid lines stand with it.
    void setEvent(const std::optional<double>& event_s);
    /// Drawn when its signal is one of the curves.
    void setLevel(const std::optional<PlotLevel>& level);
    /// Faint curves below those of the same signals; null: none.
    void setReference(ReferencePtr reference);
    const std::vector<HistoryCurve*>& referenceCurves() const { return m_referenceCurves; }
    void setCursors(const CursorPairs& cursors);
    void setMarkers(const std::vector<PlotMarker>& markers, std::optional<std::size_t> chosen) {
        m_overlay->setMarkers(markers, chosen);
    }
    /// From the left, where there are several; for who cannot see where it stands.
    void setColumn(std::optional<int> column);
    void setNamesShown(bool areShown) { m_overlay->setNamesShown(areShown); }

    /// The range the user chose; nothing while the axis follows the data.
    const std::optional<ValueRange>& userRange() const { return m_userRange; }
    /// Nothing: follow the data. A range too small or too large to show is ignored.
    void setUserRange(const std::optional<ValueRange>& range);
    ValueRange shownRange() const;
    ValueRange shownRange(bool isRight) const;
    HeldRanges heldRanges() const { return {m_userRange, m_rightUserRange}; }
    void setHeldRanges(const HeldRanges& ranges);
    /// Shows these values of the left axis, and of the right one what is beside them now.
    void zoomValues(const ValueRange& left);
    /// Fits the axes to what is drawn, now.
    void fitValues();
    /// Forgets what the axis has been fitted to; a range that the user holds too, unless it is to be kept.
    void rescale(bool keepsHeld);

    /// Width that tick labels need, and the width to give them so that stacked plots align.
    int neededExtent() const;
    int neededRightExtent() const;
    void setExtent(int extent_px);
    /// Nothing: no plot of the stack has a right axis.
    void setRightExtent(std::optional<int> extent_px);
    /// Whether the axis title is as short as the axis in this form; and the form to give it, the same for all
    /// of a stack, so that their axes align.
    bool isTitleWhole(const TitleForm& form) const;
    void setTitleForm(const TitleForm& form);
    /// The canvas in coordinates of this widget.
    QRect canvasRect() const;
    /// Whether all that was drawn last is as the samples are; else the disk has not given some of it yet.
    bool isWhole() const { return m_isWhole; }
    double timeAt(double canvasX) const;
    /// What is read at the pointer as it was drawn last; nothing while it is elsewhere or drags.
    const std::optional<HoverReadout>& hover() const { return m_overlay->hover(); }

Q_SIGNALS:
    void zoomRequested(double factor, double at_s);
    void boxChosen(halbench::control::TimeRange time, halbench::widgets::ValueRange values);
    void panRequested(double by_s);
    void valuesChanged();     ///< the user zoomed the value axis
    void viewAboutToChange(); ///< before a value zoom or a drag: what zoom back returns to
    void fitRequested();
    void cursorMoved(int index, double time_s);
    void pairPicked(int pair);     ///< before one of its cursors moves
    void markerPicked(int marker); ///< by a click on its note or its line
    void levelMoved(double level); ///< in SI
    void signalsDropped(QStringList names);
    void signalsDroppedBeside(QStringList names); ///< at its right edge

protected:
    void drawCanvas(QPainter* painter) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    enum class Drag { None, Box, Pan, Cursor, Level };
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    struct Grip { ///< a cursor under the mouse
        int pair = 0;
        int index = 0;
    };
    std::optional<Grip> cursorNear(double canvasX) const;
    bool isLevelNear(double canvasY) const;
    const PlotCurve* levelCurve() const;
    void finishBox(const QPoint& end);
    QRect besidePlace() const;
    void showDropPlace(std::optional<QRectF> place);
    void panTo(const QPoint& place);
    void setHoverPlace(std::optional<QPoint> place);
    std::optional<HoverReadout> readAtPointer() const;
    void followData();
    std::optional<ValueRange> dataRange(bool isRight) const;
    double smallestLength(bool isRight) const;
    double sensorLength(const PlotCurve& curve) const;
    void colourCurves();
    int titleRoom() const;
    void updateTitle();
    void nameItself();
    void setTitle(int axis, const QString& quantity, const QString& unit);
    int extentOf(const ValueScaleDraw& scale) const;
    void showScale(bool isRight);
    void makeReferenceCurves();
    void showReference(control::TimeRange view);
    void showLevel();
    static int axisOf(const PlotCurve& curve) { return curve.isRight ? yRight : yLeft; }

    PlotSpec m_spec;
    const control::SampleHistory* m_history = nullptr;
    Theme m_theme;
    std::vector<HistoryCurve*> m_curves; ///< owned by the plot
    std::vector<int> m_places;           ///< of each curve among the colours and patterns
    ReferencePtr m_reference;
    std::vector<HistoryCurve*> m_referenceCurves; ///< owned by the plot
    GridItem* m_grid;
    BandItem* m_bands;
    OverlayItem* m_overlay;
    ValueScaleDraw* m_valueScale; ///< owned by the plot's axis, as the next
    ValueScaleDraw* m_rightScale;
    AutoRange m_autoRange{0.0};
    AutoRange m_rightAutoRange{0.0};
    std::optional<ValueRange> m_userRange;
    std::optional<ValueRange> m_rightUserRange;
    TitleForm m_titleForm;
    control::TimeRange m_drawn;
    std::optional<int> m_column;
    bool m_isWhole = true;
    QImage m_image; ///< what the canvas shows; curves set its pixels
    Drag m_drag = Drag::None;
    Grip m_dragged;
    std::optional<QPoint> m_hoverPlace;
    QPoint m_pressed;
    QPoint m_last;
    CursorPairs m_cursors;
    std::optional<double> m_event_s;
    std::optional<PlotLevel> m_level;
};

} // namespace halbench::widgets
