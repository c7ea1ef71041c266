#include "widgets/figure/figure_file.h"

#include "widgets/figure/figure_painter.h"
#include "widgets/figure/figure_svg.h"
#include "widgets/figure/painting.h"

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

/// The file's table of places: those behind `from` move by `shift`, and so does the table itself.
void movePlaces(QByteArray& bytes, int from, int shift) {
    constexpr int PlaceDigits = 10; // "0000000086 00000 n"
    const int table = bytes.lastIndexOf("\nxref\n") + 1;
    const int trailer = bytes.indexOf("trailer", table);
    for (int at = bytes.indexOf(" 00000 n", table); at > 0 && at < trailer;
         at = bytes.indexOf(" 00000 n", at + 1)) {
        const int place = bytes.mid(at - PlaceDigits, PlaceDigits).toInt();
        if (place > from) {
            bytes.replace(at - PlaceDigits, PlaceDigits,
                          QByteArray::number(place + shift).rightJustified(PlaceDigits, '0'));
        }
    }
    const int begin = bytes.indexOf('\n', bytes.indexOf("startxref", trailer)) + 1;
    bytes.replace(begin, bytes.indexOf('\n', begin) - begin, QByteArray::number(table));
}

/// The writer notes when it wrote, and how far its clock is from UTC; nobody asked, and the same picture
/// shall be the same file.
QByteArray withoutDate(QByteArray bytes) {
    const auto key = QLatin1String("/CreationDate (D:");
    const QByteArray none = "00000000000000Z";
    const int begin = bytes.indexOf(key.data()) + key.size();
    const int length = bytes.indexOf(')', begin) - begin;
    if (begin < key.size() || length < 0) {
        return bytes;
    }
    bytes.replace(begin, length, none);
    movePlaces(bytes, begin, none.size() - length);
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

QByteArray pdf(const Painting& painting) {
    const SameHashOrder order;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(static_cast<int>(ScreenDots));
    writer.setPageSize(
        QPageSize(QSizeF(painting.size) * PointsPerPixel, QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins({});
    writer.setTitle(QString::fromStdString(painting.title));
    QPainter painter(&writer);
    painting.paint(painter, paperTheme());
    painter.end();
    return withoutDate(bytes);
}

QByteArray png(const Painting& painting, const Theme& theme) {
    QImage image = imageOf(painting, theme, PrintDots / ScreenDots);
    image.setDotsPerMeterX(static_cast<int>(std::round(PrintDots / MetresPerInch)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

Painting paintingOf(const Figure& figure, int width_px) {
    const FigureLayout layout = layOut(figure, width_px);
    return {figure.title, layout.size, [&figure, layout](QPainter& painter, const Theme& theme) {
                paintFigure(painter, figure, layout, theme);
            }};
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

Theme paperTheme() {
    return loadTheme("light").value();
}

QImage imageOf(const Painting& painting, const Theme& theme, double fineness) {
    QImage image((QSizeF(painting.size) * fineness).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(fineness);
    image.fill(theme.panel);
    QPainter painter(&image);
    painting.paint(painter, theme);
    return image;
}

Result<QByteArray> fileOf(const Painting& painting, const Theme& theme, PictureFormat format) {
    if (format == PictureFormat::Pdf) {
        return pdf(painting);
    }
    if (format == PictureFormat::Png) {
        return png(painting, theme);
    }
    const Result<std::string> svg = svgOf(painting, theme);
    return svg ? Result<QByteArray>(QByteArray::fromStdString(*svg)) : failure(svg.error());
}

QImage figureImage(const Figure& figure, const Theme& theme, double fineness, int width_px) {
    return imageOf(paintingOf(figure, width_px), theme, fineness);
}

Result<QByteArray> pictureFile(const Figure& figure, const Theme& theme, PictureFormat format, int width_px) {
    if (const Result<void> checked = checkFigure(figure); !checked) {
        return failure(checked.error());
    }
    return fileOf(paintingOf(figure, width_px), theme, format);
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
