#pragma once

#include "control/base/result.h"
#include "widgets/figure/figure.h"
#include "widgets/theme/theme.h"

#include <QByteArray>
#include <QImage>
#include <QString>

#include <functional>
#include <optional>

namespace halbench::widgets {

enum class PictureFormat { Svg, Pdf, Png };

/// By the ending of the file's name.
std::optional<PictureFormat> pictureFormat(const QString& path);

/// That of a report's pictures, 23 cm.
constexpr int PictureWidth_px = 880;

/// `figure` has a panel. Sizes are those of a screen with 96 dots per inch, the image is so many times finer.
QImage figureImage(const Figure& figure, const Theme& theme, double fineness, int width_px = PictureWidth_px);

/// The content of a file for print: lines and text in SVG and PDF, 300 dots per inch in PNG. PDF is for paper
/// and light in every theme; it bears no date, so that equal figures give equal files. Errors: InvalidInput
/// (no panel, a curve with more x than y).
Result<QByteArray> pictureFile(const Figure& figure, const Theme& theme, PictureFormat format,
                               int width_px = PictureWidth_px);

/// What writes it, on any thread. Errors: FileSystem, that of `content`.
std::function<Result<void>()> pictureWriting(Result<QByteArray> content, const QString& path);

/// A picture of one moment: what writes it to the file that was chosen, on any thread.
using PictureSaving = std::function<std::function<Result<void>()>(const QString& path)>;

} // namespace halbench::widgets
