#pragma once

#include "control/base/result.h"
#include "widgets/figure/figure_file.h"
#include "widgets/spectrogram/spectrogram_picture.h"

#include <QImage>
#include <qwt_plot.h>

#include <memory>
#include <optional>

class QAction;
class QwtPlotMarker;
class QwtPlotSpectrogram;

namespace halbench::widgets {

class ColourScaleDraw;
class FrequencyScaleDraw;
class ValueScaleDraw;

/// A spectrogram on the screen: frequency over time in colours, with their scale at the right. The value
/// under the pointer, or walked to with the arrow keys, is said in words; Ctrl+C copies the picture, Ctrl+E
/// and the context menu save it.
/// Thread: GUI.
class SpectrogramView : public QwtPlot {
    Q_OBJECT
public:
    explicit SpectrogramView(QWidget* parent = nullptr);

    /// The mark stays at its time and frequency.
    void setPicture(SpectrogramPicture picture);
    void clear();
    const SpectrogramPicture& picture() const { return *m_picture; }
    bool isEmpty() const { return m_picture->isEmpty(); }

    /// The value that is marked, in words; empty when none is.
    QString probeText() const;

    /// As it stands, `scale` pixels to a device-independent one.
    QImage image(double scale);
    /// The picture as it is now, to be written to a file that is chosen later. PDF is for paper and light.
    /// Errors of the writing: InvalidInput (nothing to save), FileSystem.
    PictureSaving taken();

Q_SIGNALS:
    void exportRequested(); ///< whoever owns the view calls taken(), then asks for a file

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void dress(const Theme& theme);
    void setTitles(const Theme& theme);
    int labelsIn(int room_px) const;
    void setScales();
    void setColourScale();
    void refreshWords();
    void probe(std::optional<SpectrogramCell> cell);
    void showMark();
    QString valueText(double value) const;
    QString textOf(const SpectrogramCell& cell) const;
    QByteArray drawn(PictureFormat format);

    std::shared_ptr<const SpectrogramPicture> m_picture = std::make_shared<SpectrogramPicture>();
    std::optional<SpectrogramCell> m_probe;
    QwtPlotSpectrogram* m_raster = nullptr;
    QwtPlotMarker* m_mark = nullptr;
    ValueScaleDraw* m_timeScale = nullptr;
    FrequencyScaleDraw* m_frequencyScale = nullptr;
    ColourScaleDraw* m_colourScale = nullptr;
    QAction* m_copy = nullptr;
    QAction* m_export = nullptr;
};

} // namespace halbench::widgets
