#pragma once

#include "app/workspaces/file_chooser.h"
#include "app/workspaces/file_queue.h"
#include "app/workspaces/latest_task.h"
#include "app/workspaces/spectrum_figure.h"
#include "app/workspaces/workbench.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QStackedWidget;
class QTableWidget;
class QToolBar;

namespace halbench::widgets {
class EmptyState;
class FigureView;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

class FieldGrid;
class SignalBox;

/// Which frequencies are in a signal, live: of its last seconds, computed on another thread four times a
/// second at most (resources/help/monitor.md, "Spectrum").
class SpectrumPanel : public QWidget {
    Q_OBJECT

public:
    explicit SpectrumPanel(Workbench& bench, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }

Q_SIGNALS:
    void connectRequested(); ///< of the simulated motor, while there is nothing to analyse

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* buildContent();
    void buildBoxes(FieldGrid& grid);
    void buildNumbers(FieldGrid& grid);
    void buildPeaks(QWidget* parent);
    QAction* addSwitch(QToolBar& bar, const QString& text, const QString& what, const char* key, bool isOn);
    void onDevice();
    void want();
    void ask();
    void askAnew();
    void showSpectrum(const Result<control::Spectrum>& spectrum, const SpectrumLook& look);
    void showPeaks(const std::vector<SpectrumPeak>& peaks, const QString& unit);
    control::SpectrumConfig config() const;
    SpectrumLook look() const;

    Workbench& m_bench;
    FileChooser m_chooser;
    QStackedWidget* m_pages = nullptr;
    SignalBox* m_signal = nullptr;
    QComboBox* m_scale = nullptr;
    QComboBox* m_window = nullptr;
    widgets::QuantityEdit* m_stretch = nullptr;
    widgets::QuantityEdit* m_segment = nullptr;
    widgets::QuantityEdit* m_overlap = nullptr;
    QAction* m_logFrequency = nullptr;
    QAction* m_logValue = nullptr;
    QAction* m_hold = nullptr;
    widgets::FigureView* m_view = nullptr;
    QTableWidget* m_peaks = nullptr;
    QLabel* m_words = nullptr;
    QTimer m_timer;
    std::optional<std::uint64_t> m_seen; ///< revision of the history
    std::optional<control::Spectrum> m_spectrum;
    FileQueue m_files;
    LatestTask m_task; ///< last: what it computes ends first
};

} // namespace halbench::app
