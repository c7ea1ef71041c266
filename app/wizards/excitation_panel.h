#pragma once

#include "app/wizards/wizard_panel.h"

#include <QElapsedTimer>

#include <functional>

namespace halbench::widgets {
class ProgressRow;
} // namespace halbench::widgets

namespace halbench::app {

class Preflight;

/// Pages of the panels that turn the rotor steadily and excite it on top of that: one that says what will
/// move, one while it runs, one with the result. The experiment itself is the panel's. Thread: GUI.
class ExcitationPanel : public WizardPanel {
    Q_OBJECT
protected:
    ExcitationPanel(Workbench& bench, QWidget* parent);

    /// Once, by the panel's constructor: `result` is shown when `finished` says that there is one.
    void addPages(QWidget& form, QWidget& result, const std::vector<QPushButton*>& resultButtons);

    QLabel& intro() { return *m_intro; }
    QLabel& running() { return *m_running; }
    QPushButton& startButton() { return *m_start; }
    QPushButton& useButton() { return *m_use; }
    QPushButton& againButton() { return *m_again; }
    /// While it is computed: set by refreshWords().
    void setComputingWords(const QString& words) { m_computing = words; }

    /// Nothing can be started, and why.
    void refuse(const Error& error);
    /// What will happen, said with the warmest coil in degC, of a plan of this heat in one phase.
    void promise(double meanSquare_A2, double duration_s,
                 const std::function<QString(double warmest_degC)>& words);
    /// The same in words, with the warmest coil of a run that starts at a temperature; empty: not known.
    void announce(const QString& words, std::function<double(double start_degC)> warmest_degC);
    /// Whether what was promised may begin.
    bool isReady() const;

    /// The procedure runs.
    void showRunning(const QString& words);
    /// It ended without a result.
    void showFailure(const Error& error, const QString& cancelledText);
    /// It ended with one.
    void showFound(bool isUsable);

    /// Something of the plan has changed. A panel that nobody sees makes its plan when it is shown: that takes up
    /// to a tenth of a second.
    void refreshPlan();
    /// What is set now, promised or refused.
    virtual void makePlan() = 0;
    virtual void start() = 0;
    void showEvent(QShowEvent* event) override;

private:
    enum Page { PreparePage, RunPage, ResultPage };
    enum Step { PrepareStep, ExciteStep, FitStep, ResultStep };

    QWidget* buildRun();
    void onDevice();
    void onStage(ProcedureState stage);
    void onProgress(double fraction, const QString& text);

    bool m_isCancelling = false;
    bool m_isPlanOld = true;
    QElapsedTimer m_sinceStart;
    QString m_computing;

    QLabel* m_intro = nullptr;
    QLabel* m_outlook = nullptr;
    Preflight* m_preflight = nullptr;
    QPushButton* m_start = nullptr;
    widgets::ProgressRow* m_progress = nullptr;
    QLabel* m_running = nullptr;
    QPushButton* m_use = nullptr;
    QPushButton* m_again = nullptr;
};

} // namespace halbench::app
