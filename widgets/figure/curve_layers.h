#pragma once

#include "widgets/figure/figure.h"

#include <QImage>
#include <QRectF>
#include <QTransform>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

class QPainter;

namespace halbench::widgets {

/// Pictures of the curves that stay as they are while others move: a run of them is drawn once and laid in at
/// its place among the others, which gives the same picture to the rounding of colours. A layer holds while
/// its curves, their axes and their canvas are the very ones that it was drawn of. Thread: GUI.
class CurveLayers {
public:
    /// Neighbouring curves of one panel.
    struct Run {
        std::size_t panel = 0;
        std::size_t first = 0;
        std::size_t end = 0;

        bool operator==(const Run&) const = default;
    };
    using Drawing = std::function<void(QPainter& painter, std::size_t first, std::size_t end)>;

    /// Before a figure is painted: what stays is told by comparing its curves with those of the one before.
    void begin(std::shared_ptr<const Figure> figure);
    /// For other colours.
    void clear();

    /// The curves from this one on that stay; an empty run where it does not.
    Run runFrom(std::size_t panel, std::size_t curve) const;
    /// Lays a run in. `axes`: every number that decides where its curves go on the canvas. False where the
    /// painter's pixels do not allow it: then it is drawn as ever.
    bool lay(QPainter& painter, const Run& run, const QRectF& canvas, const std::vector<double>& axes,
             const Drawing& draw);

private:
    struct Layer {
        Run run;
        QRectF canvas;
        std::vector<double> axes;
        QTransform transform;
        QImage image;
        QPoint corner; ///< of the image, in pixels of the device
    };
    bool stays(std::size_t panel, std::size_t curve) const;

    std::shared_ptr<const Figure> m_figure;
    std::vector<std::vector<bool>> m_stays; ///< by panel and curve
    std::vector<Layer> m_layers;
};

} // namespace halbench::widgets
