#pragma once

#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/wizards/excitation_panel.h"

class QPushButton;

namespace halbench::app {

class AxesFrequencyPanel;
class FrequencyForm;
class FrequencyResultView;

/// The frequency response of the loop step by step: what will move, the measurement, the result with its
/// coherence. It drives the same runFrequency() as the batch program and saves the same file
/// (resources/help/identification.md section 8). A device with several axes has AxesFrequencyPanel in its
/// place. Thread: GUI.
class FrequencyPanel : public ExcitationPanel {
    Q_OBJECT
public:
    explicit FrequencyPanel(Workbench& bench, QWidget* parent = nullptr);

Q_SIGNALS:
    void useRequested(const halbench::app::FrequencyResult& result); ///< its points in Tune
    void axesUseRequested(const halbench::app::AxesFrequencyResult& result);

protected:
    void refreshWords() override;
    void onFileChooser() override;
    void makePlan() override;
    void start() override;

private:
    void showAxes();
    QWidget* buildResult();
    std::vector<QPushButton*> buildSaving();
    void finish(const ResultHeader& header, const Result<FrequencyResult>& result);
    void saveTable();

    FrequencyResult m_found; ///< what is shown, refused or not
    ResultHeader m_header;   ///< of the same

    FrequencyForm* m_form = nullptr;
    FrequencyResultView* m_result = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_table = nullptr;
    AxesFrequencyPanel* m_axes = nullptr; ///< once a device with several axes was there
};

} // namespace halbench::app
