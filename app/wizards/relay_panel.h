#pragma once

#include "app/procedures/relay_procedure.h"
#include "app/wizards/wizard_panel.h"

#include <QElapsedTimer>

class QLabel;
class QPushButton;

namespace halbench::widgets {
class EstimateTable;
class FigureView;
class ProgressRow;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

class Preflight;
class RelayForm;
class WordsAndPictures;

/// The relay experiment step by step: what will move, the swing, the ultimate gain with its interval. It
/// drives the same runRelay() as the batch program and saves the same file (resources/help/identification.md
/// section 9). Thread: GUI.
class RelayPanel : public WizardPanel {
    Q_OBJECT
public:
    explicit RelayPanel(Workbench& bench, QWidget* parent = nullptr);

Q_SIGNALS:
    void useRequested(double ultimateGain_A_per_rad, double ultimatePeriod_s); ///< by Ziegler and Nichols

protected:
    void refreshWords() override;
    void onFileChooser() override;

private:
    enum Page { PreparePage, RunPage, ResultPage };
    enum Step { PrepareStep, SwingStep, FitStep, ResultStep };

    QWidget* buildPrepare();
    QWidget* buildStartRow();
    QWidget* buildRun();
    QWidget* buildResult();
    QWidget* buildResultWords();
    QWidget* buildResultButtons();
    void onDevice();
    void replan();
    void refreshPlan();
    void start();
    void onStage(ProcedureState stage);
    void onProgress(double fraction, const QString& text);
    void finish(const ResultHeader& header, const Result<RelayResult>& result);
    void showResult();

    std::vector<double> m_asked; ///< what the plan is of: making one takes a tenth of a second
    std::optional<RelayConfig> m_config;
    Result<RelayPlan> m_plan;
    std::optional<RelayResult> m_found; ///< what is shown, refused or not
    ResultHeader m_header;              ///< of the same
    bool m_isCancelling = false;
    QElapsedTimer m_sinceStart;

    QLabel* m_intro = nullptr;
    RelayForm* m_form = nullptr;
    QLabel* m_outlook = nullptr;
    Preflight* m_preflight = nullptr;
    QPushButton* m_start = nullptr;
    widgets::ProgressRow* m_progress = nullptr;
    QLabel* m_running = nullptr;
    widgets::VerdictView* m_verdict = nullptr;
    widgets::EstimateTable* m_table = nullptr;
    QLabel* m_swing = nullptr;
    QLabel* m_provenance = nullptr;
    widgets::FigureView* m_record = nullptr;
    WordsAndPictures* m_both = nullptr;
    QPushButton* m_use = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_again = nullptr;
};

} // namespace halbench::app
