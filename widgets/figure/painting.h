#pragma once

#include "control/base/result.h"
#include "widgets/figure/figure_file.h"
#include "widgets/theme/theme.h"

#include <QByteArray>
#include <QImage>
#include <QSize>

#include <functional>
#include <string>

class QPainter;

namespace halbench::widgets {

/// What a picture is made of, whatever it is kept as.
struct Painting {
    std::string title; ///< also its accessible name
    QSize size;
    std::function<void(QPainter& painter, const Theme& theme)> paint;
};

/// What a picture wears that leaves the window: light, for paper and documents, whatever the window wears.
Theme paperTheme();

/// As figureImage(), pictureFile() and figureSvg() make them.
QImage imageOf(const Painting& painting, const Theme& theme, double fineness);
Result<QByteArray> fileOf(const Painting& painting, const Theme& theme, PictureFormat format);
Result<std::string> svgOf(const Painting& painting, const Theme& theme);

} // namespace halbench::widgets
