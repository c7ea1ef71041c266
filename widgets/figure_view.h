#pragma once

#include "control/base/result.h"
#include "widgets/figure_file.h"
#include "widgets/figure_probe.h"

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <functional>
#include <optional>

namespace halbench::widgets {

/// A figure on the screen, as tall as its widget: the same picture as in a report, in the colours of the
/// current theme, sharp at every scale. The sample under the pointer, or walked to with the arrow keys, is
/// said in words; Ctrl+C copies the picture, the context menu saves it.
/// Thread: GUI.
class FigureView : public QWidget {
    Q_OBJECT
public:
    explicit FigureView(QWidget* parent = nullptr);

    /// Panels whose curves' x and y differ in number must not come here (figureSvg says which).
    /// The mark stays when the sample it is at keeps its place on the horizontal axis.
    void setFigure(Figure figure);
    void clear();
    const Figure& figure() const { return m_figure; }
    bool isEmpty() const { return m_figure.panels.empty(); }

    /// The sample that is marked, in words; empty when none is.
    QString probeText() const;

    /// Drawn anew, `scale` pixels to a device-independent one.
    QImage image(double scale) const;
    /// What writes the picture as it is now to a file, on any thread; .svg keeps its text, everything else is
    /// .png. Its errors: InvalidInput (nothing to save), FileSystem.
    std::function<Result<void>()> saving(const QString& path) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void exportRequested(); ///< whoever owns the view asks for a file and runs saving()

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    double scale() const;
    Figure stretched() const;
    Result<QByteArray> picture(PictureFormat format) const;
    void refresh();
    void refreshWords();
    void probe(std::optional<FigurePoint> point);
    void drawProbe(QPainter& painter, const Figure& figure, const FigureLayout& layout) const;

    Figure m_figure;
    std::optional<FigurePoint> m_probe;
    QPixmap m_drawn; ///< the picture without the mark; null when it must be drawn again
    QAction* m_copy = nullptr;
    QAction* m_export = nullptr;
};

} // namespace halbench::widgets
