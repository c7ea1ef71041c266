#pragma once

#include "app/procedures/frequency_procedure.h"
#include "app/wizards/wizard_panel.h"

#include <QElapsedTimer>

class QLabel;
class QPushButton;

namespace halbench::widgets {
class ProgressRow;
} // namespace halbench::widgets

namespace halbench::app {

class FrequencyForm;
class FrequencyResultView;
class Preflight;

/// The frequency response of the loop step by step: what will move, the measurement, the result with its
/// coherence. It drives the same runFrequency() as the batch program and saves the same file
/// (resources/help/identification.md section 8). Thread: GUI.
class FrequencyPanel : public WizardPanel {
    Q_OBJECT
public:
    explicit FrequencyPanel(Workbench& bench, QWidget* parent = nullptr);

Q_SIGNALS:
    void useRequested(const halbench::app::FrequencyResult& result); ///< its points in Tune

protected:
    void refreshWords() override;
    void onFileChooser() override;

private:
    enum Page { PreparePage, RunPage, ResultPage };
    enum Step { PrepareStep, ExciteStep, FitStep, ResultStep };

    QWidget* buildPrepare();
    QWidget* buildStartRow();
    QWidget* buildRun();
    QWidget* buildResult();
    QWidget* buildResultButtons();
    void onDevice();
    void refreshPlan();
    void start();
    void onStage(ProcedureState stage);
    void onProgress(double fraction, const QString& text);
    void finish(const ResultHeader& header, const Result<FrequencyResult>& result);
    void saveTable();

    FrequencyResult m_found; ///< what is shown, refused or not
    ResultHeader m_header;   ///< of the same
    bool m_isCancelling = false;
    QElapsedTimer m_sinceStart;

    QLabel* m_intro = nullptr;
    FrequencyForm* m_form = nullptr;
    QLabel* m_outlook = nullptr;
    Preflight* m_preflight = nullptr;
    QPushButton* m_start = nullptr;
    widgets::ProgressRow* m_progress = nullptr;
    QLabel* m_running = nullptr;
    FrequencyResultView* m_result = nullptr;
    QPushButton* m_use = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_table = nullptr;
    QPushButton* m_again = nullptr;
};

} // namespace halbench::app
