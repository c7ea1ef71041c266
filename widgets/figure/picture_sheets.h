#pragma once

#include "control/base/result.h"
#include "widgets/figure/figure_file.h"
#include "widgets/figure/painting.h"
#include "widgets/figure/panel_layers.h"

#include <vector>

namespace halbench::widgets {

/// One figure of a picture, with what lies under and over the curves of its panels.
struct PictureSheet {
    Figure figure;
    std::vector<PanelLayers> layers; ///< by panel; may be fewer
    int column = 0;                  ///< of the picture, from the left; sheets come in their order
    double width_ratio = 1.0;        ///< of its column, to the mean of all; the first sheet's counts
};

/// Figures below each other, each with a horizontal axis of its own and all canvases in line; those of other
/// columns beside them. Where the picture is too narrow for that, all are below each other. A picture has one
/// at least, and its title is the first one's.
struct PictureLayout {
    std::vector<FigureLayout> figures;
    std::vector<int> tops_px;
    std::vector<int> lefts_px;
    QSize size;
};
PictureLayout layOut(const std::vector<PictureSheet>& sheets, int width_px);
/// Panels of lower columns get what is left, so that the picture's columns end in line.
void levelColumns(std::vector<PictureSheet>& sheets, int width_px);
/// Wide enough for so many columns beside each other; that of a report's pictures for one or two.
int widthForColumns(int columns);
void paintSheets(QPainter& painter, const std::vector<PictureSheet>& sheets, const PictureLayout& layout,
                 const Theme& theme);

/// As figureImage() and pictureFile(), in the given theme whatever the window wears.
QImage sheetsImage(const std::vector<PictureSheet>& sheets, const Theme& theme, double fineness,
                   int width_px = PictureWidth_px);
Result<QByteArray> sheetsFile(const std::vector<PictureSheet>& sheets, const Theme& theme,
                              PictureFormat format, int width_px = PictureWidth_px);

} // namespace halbench::widgets
