#include "widgets/figure_file.h"

#include "widgets/figure_painter.h"
#include "widgets/figure_svg.h"

#include <QBuffer>
#include <QHash>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>

#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr double ScreenDots = 96.0; ///< per inch
constexpr double PrintDots = 300.0;
constexpr double MetresPerInch = 0.0254;
constexpr double PointsPerPixel = 72.0 / ScreenDots;

/// The writer notes when it wrote; nobody asked, and the same picture shall be the same file.
QByteArray withoutDate(QByteArray bytes) {
    const auto key = QLatin1String("/CreationDate (D:");
    const int begin = bytes.indexOf(key.data());
    const int end = begin < 0 ? begin : bytes.indexOf(')', begin);
    for (int i = begin + key.size(); begin >= 0 && i < end; ++i) {
        if (bytes[i] >= '0' && bytes[i] <= '9') {
            bytes[i] = '0'; // as long as before: the file's table of places stays right
        }
    }
    return bytes;
}

/// The writer puts its fonts in the order of a hash; the same picture shall be the same file in every run.
class SameHashOrder {
public:
    SameHashOrder() { qSetGlobalQHashSeed(0); }
    ~SameHashOrder() { qSetGlobalQHashSeed(-1); } // random again
    SameHashOrder(const SameHashOrder&) = delete;
    SameHashOrder& operator=(const SameHashOrder&) = delete;
};

QByteArray pdf(const Figure& figure, int width_px) {
    const SameHashOrder order;
    const FigureLayout layout = layOut(figure, width_px);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(static_cast<int>(ScreenDots));
    writer.setPageSize(
        QPageSize(QSizeF(layout.size) * PointsPerPixel, QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins({});
    writer.setTitle(QString::fromStdString(figure.title));
    QPainter painter(&writer);
    paintFigure(painter, figure, layout, loadTheme("light").value());
    painter.end();
    return withoutDate(bytes);
}

QByteArray png(const Figure& figure, const Theme& theme, int width_px) {
    QImage image = figureImage(figure, theme, PrintDots / ScreenDots, width_px);
    image.setDotsPerMeterX(static_cast<int>(std::round(PrintDots / MetresPerInch)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

} // namespace

std::optional<PictureFormat> pictureFormat(const QString& path) {
    for (const auto& [ending, format] :
         {std::pair{".svg", PictureFormat::Svg}, std::pair{".pdf", PictureFormat::Pdf},
          std::pair{".png", PictureFormat::Png}}) {
        if (path.endsWith(QLatin1String(ending), Qt::CaseInsensitive)) {
            return format;
        }
    }
    return std::nullopt;
}

QImage figureImage(const Figure& figure, const Theme& theme, double fineness, int width_px) {
    const FigureLayout layout = layOut(figure, width_px);
    QImage image((QSizeF(layout.size) * fineness).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(fineness);
    image.fill(theme.panel);
    QPainter painter(&image);
    paintFigure(painter, figure, layout, theme);
    return image;
}

Result<QByteArray> pictureFile(const Figure& figure, const Theme& theme, PictureFormat format, int width_px) {
    if (const Result<void> checked = checkFigure(figure); !checked) {
        return failure(checked.error());
    }
    if (format == PictureFormat::Pdf) {
        return pdf(figure, width_px);
    }
    if (format == PictureFormat::Png) {
        return png(figure, theme, width_px);
    }
    const Result<std::string> svg = figureSvg(figure, theme, width_px);
    return svg ? Result<QByteArray>(QByteArray::fromStdString(*svg)) : failure(svg.error());
}

std::function<Result<void>()> pictureWriting(Result<QByteArray> content, const QString& path) {
    return [content = std::move(content), path]() -> Result<void> {
        if (!content) {
            return failure(content.error());
        }
        QSaveFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(*content) != content->size() || !file.commit()) {
            return failure(ErrorCode::FileSystem,
                           QStringLiteral("%1: %2").arg(path, file.errorString()).toStdString(),
                           "choose another folder or name");
        }
        return {};
    };
}

} // namespace halbench::widgets
