#include "widgets/picture_sheets.h"

#include "widgets/figure_svg.h"

#include <QPainter>

#include <algorithm>

namespace halbench::widgets {
namespace {

constexpr int Gap_px = 6; ///< between two figures

} // namespace

PictureLayout layOut(const std::vector<PictureSheet>& sheets, int width_px) {
    FigureMargins widest;
    for (const PictureSheet& sheet : sheets) {
        const FigureMargins own = marginsOf(sheet.figure);
        widest.left_px = std::max(widest.left_px, own.left_px);
        widest.right_px = std::max(widest.right_px, own.right_px);
    }
    PictureLayout layout;
    int top_px = 0;
    for (const PictureSheet& sheet : sheets) {
        layout.figures.push_back(layOut(sheet.figure, width_px, widest));
        layout.tops_px.push_back(top_px);
        top_px += layout.figures.back().size.height() + Gap_px;
    }
    layout.size = QSize(width_px, top_px - Gap_px);
    return layout;
}

void paintSheets(QPainter& painter, const std::vector<PictureSheet>& sheets, const PictureLayout& layout,
                 const Theme& theme) {
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        painter.save();
        painter.translate(0.0, layout.tops_px[i]);
        paintFigure(painter, sheets[i].figure, layout.figures[i], theme, QLatin1Char('.'), sheets[i].layers);
        painter.restore();
    }
}

namespace {

Result<Painting> paintingOf(const std::vector<PictureSheet>& sheets, int width_px) {
    if (sheets.empty()) {
        return failure(checkFigure({}).error());
    }
    for (const PictureSheet& sheet : sheets) {
        if (const Result<void> checked = checkFigure(sheet.figure); !checked) {
            return failure(checked.error());
        }
    }
    const PictureLayout layout = layOut(sheets, width_px);
    return Painting{sheets.front().figure.title, layout.size,
                    [&sheets, layout](QPainter& painter, const Theme& theme) {
                        paintSheets(painter, sheets, layout, theme);
                    }};
}

} // namespace

QImage sheetsImage(const std::vector<PictureSheet>& sheets, const Theme& theme, double fineness,
                   int width_px) {
    const Result<Painting> painting = paintingOf(sheets, width_px);
    return painting ? imageOf(*painting, theme, fineness) : QImage();
}

Result<QByteArray> sheetsFile(const std::vector<PictureSheet>& sheets, const Theme& theme,
                              PictureFormat format, int width_px) {
    const Result<Painting> painting = paintingOf(sheets, width_px);
    return painting ? fileOf(*painting, theme, format) : failure(painting.error());
}

} // namespace halbench::widgets
