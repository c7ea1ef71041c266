#pragma once

#include "control/base/result.h"
#include "widgets/figure_file.h"
#include "widgets/painting.h"
#include "widgets/panel_layers.h"

#include <vector>

namespace halbench::widgets {

/// One figure of a picture, with what lies under and over the curves of its panels.
struct PictureSheet {
    Figure figure;
    std::vector<PanelLayers> layers; ///< by panel; may be fewer
};

/// Figures below each other, each with a horizontal axis of its own and all canvases in line. A picture has
/// one at least.
struct PictureLayout {
    std::vector<FigureLayout> figures;
    std::vector<int> tops_px;
    QSize size;
};
PictureLayout layOut(const std::vector<PictureSheet>& sheets, int width_px);
void paintSheets(QPainter& painter, const std::vector<PictureSheet>& sheets, const PictureLayout& layout,
                 const Theme& theme);

/// As figureImage() and pictureFile(), in the given theme whatever the window wears.
QImage sheetsImage(const std::vector<PictureSheet>& sheets, const Theme& theme, double fineness,
                   int width_px = PictureWidth_px);
Result<QByteArray> sheetsFile(const std::vector<PictureSheet>& sheets, const Theme& theme,
                              PictureFormat format, int width_px = PictureWidth_px);

} // namespace halbench::widgets
