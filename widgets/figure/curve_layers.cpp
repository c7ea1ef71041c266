#include "widgets/figure/curve_layers.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace halbench::widgets {

namespace {

/// As it is drawn. A curve with gaps is never the same: what is no number equals nothing.
bool isSame(const Curve& one, const Curve& other) {
    return one.style == other.style && one.colour == other.colour && one.isRight == other.isRight &&
           one.x == other.x && one.y == other.y;
}

} // namespace

void CurveLayers::begin(std::shared_ptr<const Figure> figure) {
    const std::shared_ptr<const Figure> before = std::exchange(m_figure, std::move(figure));
    m_stays.assign(m_figure->panels.size(), {});
    for (std::size_t panel = 0; panel < m_figure->panels.size(); ++panel) {
        const std::vector<Curve>& curves = m_figure->panels[panel].curves;
        m_stays[panel].assign(curves.size(), false);
        const bool hasBefore = before && before->panels.size() == m_figure->panels.size();
        for (std::size_t i = 0; hasBefore && i < curves.size(); ++i) {
            const std::vector<Curve>& old = before->panels[panel].curves;
            m_stays[panel][i] = i < old.size() && isSame(curves[i], old[i]);
        }
    }
    std::erase_if(m_layers, [this](const Layer& layer) {
        for (std::size_t curve = layer.run.first; curve < layer.run.end; ++curve) {
            if (!stays(layer.run.panel, curve)) {
                return true;
            }
        }
        return false;
    });
}

void CurveLayers::clear() {
    m_figure.reset();
    m_stays.clear();
    m_layers.clear();
}

bool CurveLayers::stays(std::size_t panel, std::size_t curve) const {
    return panel < m_stays.size() && curve < m_stays[panel].size() && m_stays[panel][curve];
}

CurveLayers::Run CurveLayers::runFrom(std::size_t panel, std::size_t curve) const {
    Run run{panel, curve, curve};
    while (stays(panel, run.end)) {
        ++run.end;
    }
    return run;
}

bool CurveLayers::lay(QPainter& painter, const Run& run, const QRectF& canvas,
                      const std::vector<double>& axes, const Drawing& draw) {
    const double ratio = painter.device()->devicePixelRatioF();
    const QTransform transform = painter.deviceTransform();
    if ((ratio != 1.0 && ratio != 2.0) || transform.type() > QTransform::TxScale) {
        return false; // an image would be scaled
    }
    auto found = std::find_if(m_layers.begin(), m_layers.end(), [&](const Layer& layer) {
        return layer.run == run && layer.canvas == canvas && layer.axes == axes &&
               layer.transform == transform;
    });
    if (found == m_layers.end()) {
        constexpr int PenRoom_px = 4; // beyond the canvas, in pixels of the device
        const QRect place = transform.mapRect(canvas).toAlignedRect().adjusted(-PenRoom_px, -PenRoom_px,
                                                                               PenRoom_px, PenRoom_px);
        std::erase_if(m_layers, [&](const Layer& layer) {
            return layer.run.panel == run.panel && layer.run.first < run.end && run.first < layer.run.end;
        });
        Layer layer{run,
                    canvas,
                    axes,
                    transform,
                    QImage(place.size(), QImage::Format_ARGB32_Premultiplied),
                    place.topLeft()};
        layer.image.fill(Qt::transparent);
        QPainter on(&layer.image);
        on.setRenderHints(painter.renderHints());
        on.setTransform(transform * QTransform::fromTranslate(-place.left(), -place.top()));
        draw(on, run.first, run.end);
        on.end();
        layer.image.setDevicePixelRatio(ratio);
        found = m_layers.insert(m_layers.end(), std::move(layer));
    }
    painter.save();
    painter.resetTransform();
    painter.drawImage(QPointF(found->corner) / ratio, found->image);
    painter.restore();
    return true;
}

} // namespace halbench::widgets
