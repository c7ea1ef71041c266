#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace halbench::widgets {
class ProgressRow;
}

namespace halbench::app {

class ForeignMotorNotice;
class GainDecision;
class Preflight;
class TuneSession;

/// Controls that apply the proposed gains and decide on them: the outlook of the move, its progress, and the
/// buttons Apply and verify, Keep, Restore. Thread: GUI.
class ApplyControls : public QWidget {
    Q_OBJECT
public:
    /// All of them outlive it; the checks stand elsewhere.
    ApplyControls(Workbench& bench, const TuneSession& session, GainDecision& decision, Preflight& preflight,
                  ForeignMotorNotice& foreign, QWidget* parent = nullptr);

    /// A control beside Apply and verify.
    void addTool(QWidget& tool);
    void refresh();
    /// Says what Apply and verify will do, from what the procedure is given.
    void refreshOutlook();
    void refreshTexts();
    void focusKeep();

private:
    void buildButtons();
    void connectParts();
    void apply();
    void showRunning();

    Workbench& m_bench;
    const TuneSession& m_session;
    GainDecision& m_decision;
    Preflight& m_preflight;
    ForeignMotorNotice& m_foreign;
    widgets::ProgressRow* m_progress;
    QCheckBox* m_gradually;
    QLabel* m_outlook;
    QGridLayout* m_buttons = nullptr;
    QPushButton* m_apply = nullptr;
    QPushButton* m_keep = nullptr;
    QPushButton* m_restore = nullptr;
    bool m_isObstacleShown = false; ///< in the outlook
};

} // namespace halbench::app
