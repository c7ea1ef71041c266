#pragma once

#include "control/base/result.h"
#include "widgets/figure/curve_layers.h"
#include "widgets/figure/figure_file.h"
#include "widgets/figure/figure_handle.h"
#include "widgets/figure/figure_probe.h"

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace halbench::widgets {

/// A figure on the screen, as tall as its widget: the same picture as in a report, in the colours of the
/// current theme, sharp at every scale. The sample under the pointer, or walked to with the arrow keys, is
/// said in words; in linked panels a line runs through all of them and each says what it has there, and a
/// click keeps it. Ctrl+C copies the picture, the context menu saves it. Its handles are moved with the mouse
/// or, with Ctrl, by the arrow keys; the axes stay as they are while one is held. Whoever owns the view moves
/// them.
/// Thread: GUI.
class FigureView : public QWidget {
    Q_OBJECT
public:
    explicit FigureView(QWidget* parent = nullptr);

    /// Panels whose curves' x and y differ in number must not come here (figureSvg says which).
    /// The mark stays when the sample it is at keeps its place on the horizontal axis; where the curves run
    /// along something (figure_cursor.h), at the sample nearest to where it was along it.
    void setFigure(Figure figure);
    /// What a .csv is written from instead, when a picture is drawn in other units than files have; until the
    /// next figure.
    void setNumbers(Figure figure) { m_numbers = std::move(figure); }
    void clear();
    const Figure& figure() const { return m_figure; }
    bool isEmpty() const { return m_figure.panels.empty(); }

    /// What can be moved. One that is held stays so as long as it is among them.
    void setHandles(std::vector<FigureHandle> handles);
    const std::vector<FigureHandle>& handles() const { return m_handles; }
    bool isHeld() const { return m_grip.has_value(); }
    /// Where a handle is, in pixels of the widget; nothing when it cannot be seen.
    std::optional<QPoint> handlePlace(int handle) const;

    /// The sample that is marked, in words; empty when none is.
    QString probeText() const;
    /// Where it is along the curves, in the unit of that axis; nothing where they run along nothing.
    std::optional<double> probedAlong() const;
    void probeAlong(double value);

    /// Drawn anew, `scale` pixels to a device-independent one.
    QImage image(double scale) const;
    /// The picture as it is now, to be written to a file that is chosen later; .svg and .pdf keep their text,
    /// .csv has its numbers (figure_table.h), everything else is .png. Errors of the writing: InvalidInput
    /// (nothing to save), FileSystem.
    PictureSaving taken() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void exportRequested(); ///< whoever owns the view calls taken(), then asks for a file
    void handleTaken(int handle);
    void handleMoved(int handle, double x, double y); ///< in the units of its panel's axes
    void handleReleased(int handle);
    void handleStepped(int handle, int steps); ///< by the keyboard; more is to the right or up

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// The figure as it fills the widget, and where everything is.
    struct Arrangement {
        Figure figure;
        FigureLayout layout; ///< points into the figure
        QSize size;          ///< of the widget
        double scale;
    };
    /// What a figure asks of its surroundings.
    struct Wish {
        QSize best;
        QSize least;
        double scale;
        bool operator==(const Wish&) const = default;
    };
    /// A handle in the hand.
    struct Grip {
        int handle;
        QPointF offset;                           ///< of the handle from the pointer, in pixels of the figure
        std::shared_ptr<const Arrangement> drawn; ///< when it was taken
    };
    double scale() const;
    std::shared_ptr<const Arrangement> arranged() const;
    const Wish& wish() const;
    std::optional<int> handleUnder(const QPoint& at) const;
    void showUnder(std::optional<int> handle);
    void letGo();
    bool step(const QKeyEvent& event);
    void drawHandles(QPainter& painter, const Figure& figure, const FigureLayout& layout) const;
    QString handleWords() const;
    void refresh();
    void refreshWords();
    void probe(std::optional<FigurePoint> point);
    void probeAt(const QPoint& at);
    void pinAt(const QPoint& at);
    void keepProbe(const Figure& before);
    std::optional<FigurePoint> pointUnder(const QPoint& at) const;
    void drawProbe(QPainter& painter, const Figure& figure, const FigureLayout& layout) const;

    Figure m_figure;
    std::optional<Figure> m_numbers;
    std::optional<FigurePoint> m_probe;
    bool m_isPinned = false; ///< by a click: the pointer does not take it along
    std::vector<FigureHandle> m_handles;
    std::optional<int> m_under; ///< handle under the pointer
    std::optional<Grip> m_grip;
    QPixmap m_drawn;     ///< the picture without the mark; null when it must be drawn again
    CurveLayers m_stays; ///< of that picture
    mutable std::shared_ptr<const Arrangement> m_arranged; ///< null until it is asked for
    mutable std::optional<Wish> m_wish;                    ///< likewise
    QAction* m_copy = nullptr;
    QAction* m_export = nullptr;
};

} // namespace halbench::widgets
