#include "widgets/figure/figure_svg.h"

#include "widgets/figure/figure_painter.h"
#include "widgets/figure/painting.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgGenerator>

namespace halbench::widgets {

Result<void> checkFigure(const Figure& figure) {
    if (figure.panels.empty()) {
        return failure(ErrorCode::InvalidInput, "The figure '" + figure.title + "' has no panel.");
    }
    for (const Panel& panel : figure.panels) {
        for (const Curve& curve : panel.curves) {
            if (curve.x.size() != curve.y.size()) {
                return failure(ErrorCode::InvalidInput, "The curve '" + curve.label + "' of '" +
                                                            figure.title + "' has " +
                                                            std::to_string(curve.x.size()) + " x and " +
                                                            std::to_string(curve.y.size()) + " y values.");
            }
        }
    }
    return {};
}

namespace {

QString attribute(const QString& tag, const char* name) {
    const QRegularExpression pattern(QStringLiteral("%1=\"([^\"]*)\"").arg(QLatin1String(name)));
    return pattern.match(tag).captured(1);
}

QString plainText(const QString& escaped) {
    QString text = escaped;
    return text.replace(QLatin1String("&lt;"), QLatin1String("<"))
        .replace(QLatin1String("&gt;"), QLatin1String(">"))
        .replace(QLatin1String("&quot;"), QLatin1String("\""))
        .replace(QLatin1String("&amp;"), QLatin1String("&"));
}

/// Adds to every text the length it was laid out with, so that a reader without our font sees the same
/// alignment.
QString withTextLengths(const QString& svg) {
    static const QRegularExpression element(QStringLiteral("<text ([^>]*)>([^<]*)</text>"));
    QString result;
    int copied = 0;
    QRegularExpressionMatchIterator matches = element.globalMatch(svg);
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        const bool isTitle = attribute(match.captured(1), "font-weight").toInt() > 500;
        const double length_px =
            QFontMetricsF(figureFont(isTitle)).horizontalAdvance(plainText(match.captured(2)));
        result += svg.midRef(copied, match.capturedStart(1) - copied);
        result +=
            QStringLiteral("textLength=\"%1\" lengthAdjust=\"spacingAndGlyphs\" ").arg(length_px, 0, 'f', 1);
        result += svg.midRef(match.capturedStart(1), match.capturedEnd(0) - match.capturedStart(1));
        copied = match.capturedEnd(0);
    }
    return result + svg.midRef(copied);
}

/// Our own head in place of the generator's (which carries an XML declaration and sizes in millimetres).
QString withOwnHead(const QString& svg, const std::string& name, const QSize& size) {
    const QString title = QString::fromStdString(name).toHtmlEscaped();
    const QString head =
        QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"%1\" "
                       "viewBox=\"0 0 %2 %3\" width=\"%2\" height=\"%3\">\n<title>%1</title>\n")
            .arg(title)
            .arg(size.width())
            .arg(size.height());
    const int body = svg.indexOf(QLatin1String("<g "));
    return head + svg.mid(body);
}

} // namespace

Result<std::string> svgOf(const Painting& painting, const Theme& theme) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(96);
    generator.setSize(painting.size);
    generator.setViewBox(QRect(QPoint(0, 0), painting.size));
    QPainter painter;
    if (!painter.begin(&generator)) {
        return failure(ErrorCode::Internal, "The figure '" + painting.title + "' cannot be painted.");
    }
    painting.paint(painter, theme);
    painter.end();
    return withOwnHead(withTextLengths(QString::fromUtf8(buffer.data())), painting.title, painting.size)
        .toStdString();
}

Result<std::string> figureSvg(const Figure& figure, const Theme& theme, int width_px) {
    if (const auto checked = checkFigure(figure); !checked) {
        return failure(checked.error());
    }
    const FigureLayout layout = layOut(figure, width_px);
    return svgOf({figure.title, layout.size,
                  [&](QPainter& painter, const Theme& worn) { paintFigure(painter, figure, layout, worn); }},
                 theme);
}

} // namespace halbench::widgets
