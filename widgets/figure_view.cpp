#include "widgets/figure_view.h"

#include "widgets/figure_file.h"
#include "widgets/figure_scales.h"
#include "widgets/figure_table.h"
#include "widgets/painting.h"
#include "widgets/picture_actions.h"
#include "widgets/theme_style.h"

#include <QAction>
#include <QBuffer>
#include <QClipboard>
#include <QEvent>
#include <QFontInfo>
#include <QGuiApplication>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr double PlainFont_px = 13.0; ///< of the application, at which the figure has its own size
constexpr int LeastPanel_px = 44;     ///< two tick labels and their space
constexpr int LeastWidth_px = 260;

int heightOfPanels(const Figure& figure) {
    int height_px = 0;
    for (const Panel& panel : figure.panels) {
        height_px += panel.height_px;
    }
    return height_px;
}

/// Of a picture: device-independent pixels, how many pixels each of them is, and how much larger than the
/// figure's own they are.
struct Extent {
    QSize size;
    double pixelRatio;
    double scale;
};

QImage drawn(const Figure& figure, const FigureLayout& layout, const Extent& extent, const Theme& theme) {
    QImage image(extent.size * extent.pixelRatio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(extent.pixelRatio);
    image.fill(theme.panel);
    if (!figure.panels.empty()) {
        QPainter painter(&image);
        painter.scale(extent.scale, extent.scale);
        paintFigure(painter, figure, layout, theme, QLocale().decimalPoint());
    }
    return image;
}

/// As it stands on the screen.
QByteArray png(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

} // namespace

FigureView::FigureView(QWidget* parent)
    : QWidget(parent), m_copy(new QAction(this)), m_export(new QAction(this)) {
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    addPictureActions(*this, *m_copy, *m_export);
    connect(m_copy, &QAction::triggered, this,
            [this] { QGuiApplication::clipboard()->setImage(image(2.0)); });
    connect(m_export, &QAction::triggered, this, &FigureView::exportRequested);
    refreshWords();
}

void FigureView::setFigure(Figure figure) {
    const Figure before = std::exchange(m_figure, std::move(figure));
    m_numbers.reset();
    if (m_grip) {
        m_figure = withAxesOf(std::move(m_figure), m_grip->drawn, m_grip->layout);
    }
    keepProbe(before);
    updateGeometry();
    refresh();
    refreshWords();
}

void FigureView::clear() {
    setFigure({});
}

void FigureView::refresh() {
    m_drawn = {};
    update();
}

void FigureView::refreshWords() {
    m_copy->setText(tr("Copy picture"));
    m_export->setText(tr("Save picture…"));
    for (QAction* action : {m_copy, m_export}) {
        action->setEnabled(!isEmpty());
    }
    setAccessibleName(isEmpty() ? tr("Picture") : QString::fromStdString(m_figure.title));
    const QString summary = isEmpty() ? tr("Nothing to show yet") : figureSummary(m_figure);
    setAccessibleDescription(m_probe ? probeText() : summary + handleWords());
}

double FigureView::scale() const {
    return std::max(0.5, QFontInfo(font()).pixelSize() / PlainFont_px);
}

Figure FigureView::stretched() const {
    Figure figure = m_figure;
    const double width_px = width() / scale();
    const FigureLayout natural = layOut(figure, static_cast<int>(width_px));
    const int panels_px = heightOfPanels(figure);
    const double room_px = height() / scale() - (natural.size.height() - panels_px);
    const double stretch = room_px / panels_px;
    for (Panel& panel : figure.panels) {
        panel.height_px = std::max(LeastPanel_px, static_cast<int>(std::floor(panel.height_px * stretch)));
    }
    if (figure.isEqualScale) {
        makeEqualScale(figure, static_cast<int>(width_px));
    }
    return figure;
}

QImage FigureView::image(double pixelRatio) const {
    const Figure figure = isEmpty() ? Figure{} : stretched();
    return drawn(figure, layOut(figure, static_cast<int>(width() / scale())), {size(), pixelRatio, scale()},
                 paperTheme());
}

std::function<Result<void>()> FigureView::saving(const QString& path) const {
    if (isEmpty()) {
        return
            [] { return Result<void>(failure(ErrorCode::InvalidInput, "there is no picture to save", "")); };
    }
    if (path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        return pictureWriting(QByteArray::fromStdString(figureTable(m_numbers.value_or(m_figure))), path);
    }
    const PictureFormat format = pictureFormat(path).value_or(PictureFormat::Png);
    return pictureWriting(format == PictureFormat::Png ? png(image(2.0)) : picture(format), path);
}

/// Of its own size, or as it stands where sizes mean something.
Result<QByteArray> FigureView::picture(PictureFormat format) const {
    return m_figure.isEqualScale
               ? pictureFile(stretched(), paperTheme(), format, static_cast<int>(width() / scale()))
               : pictureFile(m_figure, paperTheme(), format);
}

QSize FigureView::sizeHint() const {
    const FigureLayout layout = layOut(m_figure, 560);
    return QSizeF(layout.size.width() * scale(), std::max(200, layout.size.height()) * scale()).toSize();
}

QSize FigureView::minimumSizeHint() const {
    const int rows_px = layOut(m_figure, LeastWidth_px).size.height() - heightOfPanels(m_figure);
    const int panels = static_cast<int>(m_figure.panels.size());
    return QSizeF(LeastWidth_px * scale(), (rows_px + panels * LeastPanel_px) * scale()).toSize();
}

void FigureView::paintEvent(QPaintEvent*) {
    const Figure figure = isEmpty() ? Figure{} : stretched();
    const FigureLayout layout = layOut(figure, static_cast<int>(width() / scale()));
    if (m_drawn.isNull() || m_drawn.size() != size() * devicePixelRatioF()) {
        m_drawn =
            QPixmap::fromImage(drawn(figure, layout, {size(), devicePixelRatioF(), scale()}, currentTheme()));
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_drawn);
    if (isEmpty()) {
        return;
    }
    painter.scale(scale(), scale());
    if (hasFocus()) {
        painter.setPen(QPen(currentTheme().accent, 2.0));
        painter.drawRect(QRectF(1.0, 1.0, width() / scale() - 2.0, height() / scale() - 2.0));
    }
    drawHandles(painter, figure, layout);
    drawProbe(painter, figure, layout);
}

void FigureView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::PaletteChange) {
        refresh();
    } else if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::widgets
