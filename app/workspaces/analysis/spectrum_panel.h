#pragma once

#include "app/workspaces/analysis/spectrum_figure.h"
#include "app/workspaces/parts/live_picture.h"

class QComboBox;
class QLabel;
class QStackedWidget;
class QTableWidget;
class QToolBar;

namespace halbench::widgets {
class QuantityEdit;
class SpectrogramView;
} // namespace halbench::widgets

namespace halbench::app {

class FieldGrid;
class SpectrogramRange;

/// Which frequencies are in a signal, live: of its last seconds, computed on another thread four times a
/// second at most; all at once or over time (resources/help/monitor.md, "Spectrum").
class SpectrumPanel : public LivePicture {
    Q_OBJECT

public:
    explicit SpectrumPanel(Workbench& bench, QWidget* parent = nullptr);

protected:
    void takeCatalogue(const devices::Catalogue& catalogue) override;
    void compute() override;
    bool isHeld() const override;
    Table table() const override;

private:
    QWidget* buildContent();
    QWidget* buildPictures(QWidget* parent);
    void buildBoxes(FieldGrid& grid);
    void buildNumbers(FieldGrid& grid);
    void buildPeaks(QWidget* parent);
    QAction* addSwitch(QToolBar& bar, const QString& text, const QString& what, const char* key, bool isOn);
    void computeOverTime();
    void showOverTime(bool isOverTime);
    void showSpectrogram(const Result<control::Spectrogram>& spectrogram, const SpectrumLook& look);
    void showAgain();
    void dressRange();
    void showSpectrum(const Result<control::Spectrum>& spectrum, const SpectrumLook& look);
    int aroundPeaks_px() const; ///< frame and scroll bar of the table
    void showPeaks(const std::vector<SpectrumPeak>& peaks, const QString& unit);
    control::SpectrumConfig config() const;
    SpectrumLook look() const;

    SignalBox* m_signal = nullptr;
    QComboBox* m_scale = nullptr;
    QComboBox* m_window = nullptr;
    widgets::QuantityEdit* m_stretch = nullptr;
    widgets::QuantityEdit* m_segment = nullptr;
    widgets::QuantityEdit* m_overlap = nullptr;
    QAction* m_logFrequency = nullptr;
    QAction* m_logValue = nullptr;
    QAction* m_hold = nullptr;
    QAction* m_overTime = nullptr;
    QAction* m_decibel = nullptr;
    SpectrogramRange* m_range = nullptr;
    QStackedWidget* m_pictures = nullptr;
    widgets::SpectrogramView* m_gram = nullptr;
    widgets::FigureView* m_view = nullptr;
    QTableWidget* m_peaks = nullptr;
    QLabel* m_words = nullptr;
    std::optional<control::Spectrum> m_spectrum;
    std::optional<control::Spectrogram> m_spectrogram;
    std::string m_unit;                 ///< of the signal that the numbers are of
    control::SpectrumScale m_shownAs{}; ///< their scale
};

} // namespace halbench::app
