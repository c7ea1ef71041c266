#pragma once

#include "app/procedures/frequency/axes_frequency.h"
#include "app/wizards/excitation_panel.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QTabWidget;

namespace halbench::widgets {
class FigureView;
class OptionalNumberEdit;
} // namespace halbench::widgets

namespace halbench::app {

class ResultWords;
class WordsAndPictures;

/// Frequency response of a device with several axes step by step: axes and band, the run, margins with
/// intervals, loops and coupling. It drives runAxesFrequency() and saves the same file as the command
/// (resources/help/identification.md section 8). Thread: GUI.
class AxesFrequencyPanel : public ExcitationPanel {
    Q_OBJECT
public:
    explicit AxesFrequencyPanel(Workbench& bench, QWidget* parent = nullptr);

Q_SIGNALS:
    void useRequested(const halbench::app::AxesFrequencyResult& result); ///< its points in Tune

protected:
    void refreshWords() override;
    void onFileChooser() override;
    void makePlan() override;
    void start() override;

private:
    enum Field { From, To, Effort, Periods, Fields };

    QWidget* buildForm();
    QWidget* buildResult();
    std::vector<QPushButton*> buildSaving();
    void refreshAxes();
    Result<AxesFrequencyConfig> config() const;
    void finish(const ResultHeader& header, const Result<AxesFrequencyResult>& result);
    void showResult();
    void saveTable();

    QWidget* m_form = nullptr;
    QComboBox* m_axis = nullptr;
    std::array<widgets::OptionalNumberEdit*, Fields> m_numbers{};
    std::string m_model; ///< whose axes are listed

    std::optional<AxesFrequencyResult> m_found; ///< what is shown, refused or not
    ResultHeader m_header;                      ///< of the same
    ResultWords* m_words = nullptr;
    WordsAndPictures* m_both = nullptr;
    QTabWidget* m_figures = nullptr;
    std::array<widgets::FigureView*, 3> m_views{}; ///< loops, coupling, singular values
    QPushButton* m_save = nullptr;
    QPushButton* m_table = nullptr;
};

} // namespace halbench::app
