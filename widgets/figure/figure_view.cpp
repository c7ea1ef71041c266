#include "widgets/figure/figure_view.h"

#include "widgets/figure/figure_file.h"
#include "widgets/figure/figure_scales.h"
#include "widgets/figure/figure_table.h"
#include "widgets/figure/painting.h"
#include "widgets/figure/panel_layers.h"
#include "widgets/figure/picture_actions.h"
#include "widgets/theme/theme_style.h"

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

QImage drawn(const Figure& figure, const FigureLayout& layout, const Extent& extent, const Theme& theme,
             CurveLayers* stays) {
    QImage image(extent.size * extent.pixelRatio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(extent.pixelRatio);
    image.fill(theme.panel);
    if (!figure.panels.empty()) {
        QPainter painter(&image);
        painter.scale(extent.scale, extent.scale);
        paintFigure(painter, figure, layout, theme, QLocale().decimalPoint(), {}, stays);
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

/// As tall as there is room for.
Figure stretched(Figure figure, int width_px, double height_px) {
    const int panels_px = heightOfPanels(figure);
    const double room_px = height_px - (layOut(figure, width_px).size.height() - panels_px);
    const double stretch = room_px / panels_px;
    for (Panel& panel : figure.panels) {
        panel.height_px = std::max(LeastPanel_px, static_cast<int>(std::floor(panel.height_px * stretch)));
    }
    if (figure.isEqualScale) {
        makeEqualScale(figure, width_px);
    }
    return figure;
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
    const Wish wished = wish();
    const Figure before = std::exchange(m_figure, std::move(figure));
    m_numbers.reset();
    if (m_grip) {
        m_figure = withAxesOf(std::move(m_figure), m_grip->drawn->figure, m_grip->drawn->layout);
    }
    keepProbe(before);
    m_arranged.reset();
    m_wish.reset();
    if (!(wish() == wished)) {
        updateGeometry(); // else the whole window would be arranged anew for the same places
    }
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
    const QString summary = isEmpty() ? tr("No data to show") : figureSummary(m_figure);
    setAccessibleDescription(m_probe ? probeText() : summary + handleWords());
}

double FigureView::scale() const {
    return std::max(0.5, QFontInfo(font()).pixelSize() / PlainFont_px);
}

std::shared_ptr<const FigureView::Arrangement> FigureView::arranged() const {
    const double scaleNow = scale();
    if (!m_arranged || m_arranged->size != size() || m_arranged->scale != scaleNow) {
        const auto width_px = static_cast<int>(width() / scaleNow);
        auto made = std::make_shared<Arrangement>();
        made->figure = isEmpty() ? Figure{} : stretched(m_figure, width_px, height() / scaleNow);
        made->layout = layOut(made->figure, width_px);
        made->size = size();
        made->scale = scaleNow;
        m_arranged = std::move(made);
    }
    return m_arranged;
}

QImage FigureView::image(double pixelRatio) const {
    const auto shown = arranged();
    return drawn(shown->figure, shown->layout, {size(), pixelRatio, scale()}, paperTheme(), nullptr);
}

PictureSaving FigureView::taken() const {
    if (isEmpty()) {
        return [](const QString&) {
            return [] { return Result<void>(failure(ErrorCode::InvalidInput, "no picture to save", "")); };
        };
    }
    return [shown = arranged(), figure = m_figure, numbers = m_numbers.value_or(m_figure), size = size(),
            scale = scale()](const QString& path) {
        if (path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
            return pictureWriting(QByteArray::fromStdString(figureTable(numbers)), path);
        }
        const PictureFormat format = pictureFormat(path).value_or(PictureFormat::Png);
        if (format == PictureFormat::Png) {
            return pictureWriting(
                png(drawn(shown->figure, shown->layout, {size, 2.0, scale}, paperTheme(), nullptr)), path);
        }
        // Of its own size, or as it stands where sizes mean something.
        return pictureWriting(figure.isEqualScale ? pictureFile(shown->figure, paperTheme(), format,
                                                                static_cast<int>(size.width() / scale))
                                                  : pictureFile(figure, paperTheme(), format),
                              path);
    };
}

const FigureView::Wish& FigureView::wish() const {
    constexpr int BestWidth_px = 560;
    const double scaleNow = scale();
    if (!m_wish || m_wish->scale != scaleNow) {
        const FigureMargins margins = marginsOf(m_figure);
        const int best_px = layOutWithin(m_figure, BestWidth_px, margins).size.height();
        const int rows_px =
            layOutWithin(m_figure, LeastWidth_px, margins).size.height() - heightOfPanels(m_figure);
        const int panels = static_cast<int>(m_figure.panels.size());
        m_wish =
            Wish{QSizeF(BestWidth_px * scaleNow, std::max(200, best_px) * scaleNow).toSize(),
                 QSizeF(LeastWidth_px * scaleNow, (rows_px + panels * LeastPanel_px) * scaleNow).toSize(),
                 scaleNow};
    }
    return *m_wish;
}

QSize FigureView::sizeHint() const {
    return wish().best;
}

QSize FigureView::minimumSizeHint() const {
    return wish().least;
}

void FigureView::paintEvent(QPaintEvent*) {
    const auto shown = arranged();
    const Figure& figure = shown->figure;
    const FigureLayout& layout = shown->layout;
    if (m_drawn.isNull() || m_drawn.size() != size() * devicePixelRatioF()) {
        m_stays.begin({shown, &figure});
        m_drawn = QPixmap::fromImage(
            drawn(figure, layout, {size(), devicePixelRatioF(), scale()}, currentTheme(), &m_stays));
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
        m_stays.clear(); // in other colours
        refresh();
    } else if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::widgets
