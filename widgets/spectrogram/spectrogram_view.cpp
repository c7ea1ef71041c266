#include "widgets/spectrogram/spectrogram_view.h"

#include "widgets/figure/picture_actions.h"
#include "widgets/language/display_units.h"
#include "widgets/spectrogram/spectrogram_scales.h"
#include "widgets/theme/sequence_colours.h"
#include "widgets/theme/theme_style.h"

#include <QAccessible>
#include <QAction>
#include <QBuffer>
#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <qwt_plot_canvas.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_renderer.h>
#include <qwt_plot_spectrogram.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_widget.h>
#include <qwt_symbol.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace halbench::widgets {
namespace {

constexpr int Margin_px = 4;
constexpr int BarWidth_px = 14;
constexpr int MarkSize_px = 9;
constexpr int Digits = 4;
constexpr int TickRoom_characters = 10;
constexpr int FarStep = 10; ///< with Shift
constexpr int ScreenDots = 96;
constexpr double PointsPerPixel = 72.0 / ScreenDots;

/// Into the interval; nothing where it would leave it at the start.
std::size_t moved(std::size_t at, int by, std::pair<std::size_t, std::size_t> range) {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(at) + by,
                                                               static_cast<std::ptrdiff_t>(range.first),
                                                               static_cast<std::ptrdiff_t>(range.second)));
}

} // namespace

SpectrogramView::SpectrogramView(QWidget* parent)
    : QwtPlot(parent), m_raster(new QwtPlotSpectrogram), m_mark(new QwtPlotMarker),
      m_timeScale(new ValueScaleDraw), m_frequencyScale(new FrequencyScaleDraw),
      m_colourScale(new ColourScaleDraw), m_copy(new QAction(this)), m_export(new QAction(this)) {
    auto* area = new QwtPlotCanvas(this);
    area->setFrameStyle(QFrame::NoFrame);
    area->setBorderRadius(0.0);
    area->setFocusPolicy(Qt::NoFocus);
    area->setMouseTracking(true);
    area->installEventFilter(this);
    setCanvas(area);
    setAutoReplot(false);
    plotLayout()->setAlignCanvasToScales(true);
    setContentsMargins(Margin_px, Margin_px, Margin_px, Margin_px);
    setAxisScaleDraw(xBottom, m_timeScale);
    setAxisScaleDraw(yLeft, m_frequencyScale);
    setAxisScaleDraw(yRight, m_colourScale);
    enableAxis(yRight);
    axisWidget(yRight)->setColorBarEnabled(true);
    axisWidget(yRight)->setColorBarWidth(BarWidth_px);
    m_raster->setRenderThreadCount(1); // the other cores have a motor to watch
    m_raster->attach(this);
    m_mark->setLineStyle(QwtPlotMarker::Cross);
    m_mark->attach(this);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    addPictureActions(*this, *m_copy, *m_export);
    connect(m_copy, &QAction::triggered, this,
            [this] { QGuiApplication::clipboard()->setImage(image(2.0)); });
    connect(m_export, &QAction::triggered, this, &SpectrogramView::exportRequested);
    clear();
}

void SpectrogramView::setPicture(SpectrogramPicture picture) {
    const auto before = m_picture;
    m_picture = std::make_shared<SpectrogramPicture>(std::move(picture));
    m_raster->setVisible(!isEmpty());
    if (!isEmpty()) {
        m_raster->setData(new SpectrogramRaster(m_picture));
    }
    if (m_probe) {
        const auto column = m_picture->columnAt(before->time_s[m_probe->column]);
        const auto line = m_picture->lineAt(before->frequency_Hz[m_probe->line]);
        const bool isShown =
            line && *line >= shownLines(*m_picture).first && *line <= shownLines(*m_picture).second;
        m_probe = column && isShown ? std::optional(SpectrogramCell{*column, *line}) : std::nullopt;
    }
    dress(currentTheme());
    setScales();
    refreshWords();
    showMark();
}

void SpectrogramView::clear() {
    setPicture({});
}

void SpectrogramView::dress(const Theme& theme) {
    setCanvasBackground(theme.plotBackground);
    QPalette colours = palette();
    colours.setColor(QPalette::Window, theme.panel);
    colours.setColor(QPalette::WindowText, theme.plotAxis);
    colours.setColor(QPalette::Text, theme.plotAxis);
    setPalette(colours);
    setAutoFillBackground(true);
    setTitles(theme);
    auto* symbol = new QwtSymbol(QwtSymbol::Ellipse, theme.raised, theme.text, {MarkSize_px, MarkSize_px});
    m_mark->setSymbol(symbol);
    m_mark->setLinePen(theme.muted);
    m_raster->setColorMap(new SequenceColours(m_picture->isLogarithmic));
    const QwtInterval values = isEmpty() ? QwtInterval(0.1, 1.0) : m_raster->interval(Qt::ZAxis);
    axisWidget(yRight)->setColorMap(values, new SequenceColours(m_picture->isLogarithmic));
}

void SpectrogramView::setTitles(const Theme& theme) {
    const auto title = [&](int axis, const QString& words) {
        QwtText text(words, QwtText::PlainText);
        text.setFont(font());
        text.setColor(theme.text);
        setAxisFont(axis, font());
        setAxisTitle(axis, text);
    };
    // Qwt counts the height of digits: below the lowest label a decimal comma would lose its tail.
    axisWidget(yRight)->setMinBorderDist(fontMetrics().height(), fontMetrics().height());
    title(xBottom, tr("time [s]"));
    title(yLeft, tr("frequency [Hz]"));
    title(yRight, colourTitle(*m_picture));
}

/// Labels that an axis of this length has room for.
int SpectrogramView::labelsIn(int room_px) const {
    return std::max(2, room_px / (TickRoom_characters * fontMetrics().averageCharWidth()));
}

/// Ticks as far apart as their labels need.
void SpectrogramView::setScales() {
    const QwtInterval empty(0.0, 1.0);
    const auto scale = [&](int axis, ValueScaleDraw& draw, const QwtInterval& range, int count) {
        const double step = niceStep(range.width(), count);
        draw.setDecimals(decimalsOf(step));
        setAxisScaleEngine(axis, new QwtLinearScaleEngine);
        setAxisScaleDiv(axis, divisionOf(range.minValue(), range.maxValue(), step));
    };
    scale(xBottom, *m_timeScale, isEmpty() ? empty : m_raster->interval(Qt::XAxis),
          labelsIn(canvas()->width()));
    const QwtInterval lines = isEmpty() ? empty : m_raster->interval(Qt::YAxis);
    const bool isLogarithmic = m_picture->isFrequencyLogarithmic && lines.minValue() > 0.0;
    m_frequencyScale->setLogarithmic(isLogarithmic);
    if (isLogarithmic) {
        setAxisScaleEngine(yLeft, new QwtLogScaleEngine);
        setAxisScaleDiv(yLeft, decadesOf(lines, labelsIn(canvas()->height())));
    } else {
        scale(yLeft, *m_frequencyScale, lines, labelsIn(canvas()->height()));
    }
    setColourScale();
    replot();
}

void SpectrogramView::setColourScale() {
    const QwtInterval values = isEmpty() ? QwtInterval(0.1, 1.0) : m_raster->interval(Qt::ZAxis);
    const int count = labelsIn(canvas()->height());
    m_colourScale->setDecade_dB(m_picture->isLogarithmic ? m_picture->decade_dB : 0.0);
    if (m_picture->isLogarithmic) {
        setAxisScaleEngine(yRight, new QwtLogScaleEngine);
        setAxisScaleDiv(yRight, m_picture->decade_dB > 0.0 ? decibelsOf(values, m_picture->decade_dB, count)
                                                           : decadesOf(values, count));
    } else {
        setAxisScaleEngine(yRight, new QwtLinearScaleEngine);
        setAxisScaleDiv(yRight,
                        divisionOf(values.minValue(), values.maxValue(), niceStep(values.width(), 5)));
    }
}

void SpectrogramView::refreshWords() {
    m_copy->setText(tr("Copy picture"));
    m_export->setText(tr("Save picture…"));
    for (QAction* action : {m_copy, m_export}) {
        action->setEnabled(!isEmpty());
    }
    setAccessibleName(isEmpty() ? tr("Spectrogram") : m_picture->title);
    if (isEmpty()) {
        setAccessibleDescription(tr("No data to show"));
    } else {
        const SpectrogramCell highest = highestCell(*m_picture);
        setAccessibleDescription(m_probe ? probeText() : tr("highest %1").arg(textOf(highest)));
    }
}

/// In dB too where the colours say it.
QString SpectrogramView::valueText(double value) const {
    const bool hasDecibels = m_picture->isLogarithmic && m_picture->decade_dB > 0.0 && value > 0.0;
    return hasDecibels
               ? QStringLiteral("%1 dB, %2")
                     .arg(fixedText(m_picture->decade_dB * std::log10(value), 1), numberText(value, Digits))
               : numberText(value, Digits);
}

QString SpectrogramView::textOf(const SpectrogramCell& cell) const {
    return tr("%1 s, %2 Hz: %3 %4")
        .arg(fixedText(m_picture->time_s[cell.column], 3),
             numberText(m_picture->frequency_Hz[cell.line], Digits + 1),
             valueText(m_picture->value(cell.column, cell.line)), m_picture->unit)
        .trimmed();
}

QString SpectrogramView::probeText() const {
    return m_probe ? textOf(*m_probe) : QString();
}

void SpectrogramView::probe(std::optional<SpectrogramCell> cell) {
    if (cell == m_probe) {
        return;
    }
    m_probe = cell;
    refreshWords();
    showMark();
    replot();
    QAccessibleEvent said(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&said);
}

void SpectrogramView::showMark() {
    m_mark->setVisible(m_probe.has_value());
    if (!m_probe) {
        return;
    }
    m_mark->setValue(m_picture->time_s[m_probe->column], m_picture->frequency_Hz[m_probe->line]);
    const Theme theme = currentTheme();
    QwtText words(probeText(), QwtText::PlainText);
    words.setFont(font());
    words.setColor(theme.text);
    words.setBackgroundBrush(theme.raised);
    words.setBorderPen(theme.line);
    m_mark->setLabel(words);
    const bool isRight = 2 * m_probe->column > m_picture->time_s.size();
    const auto [first, last] = shownLines(*m_picture);
    const bool isHigh = 2 * m_probe->line > first + last;
    m_mark->setLabelAlignment((isRight ? Qt::AlignLeft : Qt::AlignRight) |
                              (isHigh ? Qt::AlignBottom : Qt::AlignTop));
}

bool SpectrogramView::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseMove && !isEmpty()) {
        const QPoint at = static_cast<QMouseEvent*>(event)->pos();
        const auto column = m_picture->columnAt(invTransform(xBottom, at.x()));
        const auto line = m_picture->lineAt(invTransform(yLeft, at.y()));
        probe(column && line ? std::optional(SpectrogramCell{*column, *line}) : std::nullopt);
    } else if (event->type() == QEvent::Leave && !hasFocus()) {
        probe(std::nullopt);
    }
    return QwtPlot::eventFilter(watched, event);
}

/// The walk begins at the highest value.
void SpectrogramView::keyPressEvent(QKeyEvent* event) {
    const int step = (event->modifiers() & Qt::ShiftModifier) != 0 ? FarStep : 1;
    const int right = event->key() == Qt::Key_Right ? step : event->key() == Qt::Key_Left ? -step : 0;
    const int up = event->key() == Qt::Key_Up ? step : event->key() == Qt::Key_Down ? -step : 0;
    if (isEmpty() || (right == 0 && up == 0)) {
        QwtPlot::keyPressEvent(event); // Esc stops the motor, it belongs to the window
        return;
    }
    probe(m_probe ? SpectrogramCell{moved(m_probe->column, right, {0, m_picture->time_s.size() - 1}),
                                    moved(m_probe->line, up, shownLines(*m_picture))}
                  : highestCell(*m_picture));
}

void SpectrogramView::changeEvent(QEvent* event) {
    QwtPlot::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) {
        dress(currentTheme());
        setScales();
        showMark();
    } else if (event->type() == QEvent::LanguageChange) {
        setTitles(currentTheme());
        refreshWords();
    }
}

void SpectrogramView::resizeEvent(QResizeEvent* event) {
    QwtPlot::resizeEvent(event);
    setScales();
}

void SpectrogramView::focusInEvent(QFocusEvent* event) {
    QwtPlot::focusInEvent(event);
    update();
}

void SpectrogramView::focusOutEvent(QFocusEvent* event) {
    QwtPlot::focusOutEvent(event);
    update();
}

void SpectrogramView::paintEvent(QPaintEvent* event) {
    QwtPlot::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(this);
        painter.setPen(QPen(currentTheme().accent, 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

QImage SpectrogramView::image(double scale) {
    QImage image(size() * scale, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(scale);
    image.fill(currentTheme().panel);
    QPainter painter(&image);
    QwtPlotRenderer().render(this, &painter, rect());
    return image;
}

PictureSaving SpectrogramView::taken() {
    std::map<PictureFormat, QByteArray> pictures;
    if (!isEmpty()) {
        for (const PictureFormat format : {PictureFormat::Svg, PictureFormat::Pdf, PictureFormat::Png}) {
            pictures[format] = drawn(format);
        }
    }
    return [pictures = std::move(pictures)](const QString& path) {
        const auto found = pictures.find(pictureFormat(path).value_or(PictureFormat::Png));
        return pictureWriting(found != pictures.end()
                                  ? Result<QByteArray>(found->second)
                                  : failure(ErrorCode::InvalidInput, "no picture to save", ""),
                              path);
    };
}

/// Axes as lines and text where the format has them; the raster is an image in each.
QByteArray SpectrogramView::drawn(PictureFormat format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    const auto paint = [this](QPaintDevice& device) {
        QPainter painter(&device);
        QwtPlotRenderer().render(this, &painter, rect());
    };
    if (format == PictureFormat::Svg) {
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        svg.setSize(size());
        svg.setViewBox(rect());
        svg.setTitle(m_picture->title);
        paint(svg);
    } else if (format == PictureFormat::Pdf) {
        QPdfWriter pdf(&buffer);
        pdf.setResolution(ScreenDots);
        pdf.setPageSize(
            QPageSize(QSizeF(size()) * PointsPerPixel, QPageSize::Point, {}, QPageSize::ExactMatch));
        pdf.setPageMargins({});
        pdf.setTitle(m_picture->title);
        dress(loadTheme("light").value());
        paint(pdf);
        dress(currentTheme());
    } else {
        image(2.0).save(&buffer, "PNG");
    }
    return bytes;
}

} // namespace halbench::widgets
