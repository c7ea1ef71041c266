#pragma once

#include "app/documents/axis_model_file.h"
#include "app/documents/model_file.h"
#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/measured_loop.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/tune/saved_designs.h"
#include "app/workspaces/tune/tune_messages.h"

#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QAction;
class QLabel;

namespace halbench::widgets {
class FigureView;
class MessageBar;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

class ApplyControls;
class DesignComparison;
class GainDecision;
class GainFiles;
class GainSettings;
class LoopShaping;
class PredictionPages;
class TunePages;
class TuneSession;
class VerificationPage;
class WhatIfPage;
class WhatIfRecording;

/// Gains for the identified motor: by a method, a preset or by hand, with everything that is predicted of
/// them; applied as one transaction with a verification move, kept or taken back
/// (resources/help/tuning.md). Lays out and connects the parts that do so. Thread: GUI.
class TunePanel : public QWidget {
    Q_OBJECT
public:
    explicit TunePanel(Workbench& bench, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser);
    /// Whether an answer about the proposed gains is still to come.
    bool isComputing() const;
    /// Shows the project's gains as they are, until others are chosen: their method is named, not run again.
    /// None: the first method.
    void restoreDesign(std::optional<GainsFile> gains);
    /// The project's other designs, by name, and what they are now.
    void setSavedDesigns(std::vector<KeptDesign> designs);
    /// One more that the project held otherwise; nothing done to the others is forgotten.
    void adoptDesign(const std::string& name, std::string document);
    const std::vector<KeptDesign>& savedDesigns() const;
    /// A kept design becomes the proposed one; nothing without one of this name.
    void takeUpDesign(const std::string& name);
    /// Draws a measured plant into the open loop; one of another loop is refused in place.
    void useMeasured(const MeasuredPlant& plant);
    /// Replays a recorded move with the proposed gains; a recording without one is refused in place.
    void useRecording(const QString& path);
    /// Gains by Ziegler and Nichols, from where the loop was measured to swing.
    void useUltimate(double gain_A_per_rad, double period_s);
    /// Gains for the axes of a device with several, identified just now.
    void useAxisModel(const AxisModelFile& model);
    /// A measured response of several axes in their open loops, now or once they are identified.
    void useMeasuredAxes(const AxesFrequencyResult& response);
    /// The device keeps its gains without power from now on.
    void onSavedInDevice();
    /// Undo and redo of what was done to the proposed gains; named after it.
    QList<QAction*> historyActions() const;

Q_SIGNALS:
    void identifyRequested(); ///< there is no motor to tune yet
    void savingRequested();   ///< in the device, what is kept
    void drivingRequested();  ///< with what is kept on a simulated device, which saves nothing
    /// A device was left on which gains of this panel were kept, or still to be decided on: where they are
    /// now. The project has them as this design.
    void gainsLeft(const QString& text, const QString& remedy, const QString& design);

protected:
    void changeEvent(QEvent* event) override;

private:
    void createParts();
    QWidget* buildSettings();
    void connectSession();
    void connectGains();
    void connectDecision();
    void connectPages();
    void connectBench();
    void onDevice();
    void readConditions();
    void refreshModel();
    QString motorText() const;
    void ask();
    void showSketch();
    void showAnswer();
    void showProblem();
    void onReleased();
    void drawPredictions();
    void proposeToWhatIf();
    void forgetVerification();
    void onMessageAction();
    void focusNext();
    void refresh();
    void refreshTexts();
    void onUnits();

    Workbench& m_bench;
    FileChooser m_chooser;
    FileQueue m_files; ///< of pictures
    TunePages* m_pages;
    widgets::MessageBar* m_message;
    TuneMessages m_messages;
    TuneSession* m_session;
    GainSettings* m_gains = nullptr;
    PredictionPages* m_predictions = nullptr;
    LoopShaping* m_shaping = nullptr;
    DesignComparison* m_designs = nullptr;
    GainDecision* m_decision = nullptr;
    ApplyControls* m_controls = nullptr;
    GainFiles* m_gainFiles = nullptr;
    VerificationPage* m_verification = nullptr;
    WhatIfPage* m_whatIf = nullptr;
    WhatIfRecording* m_recording = nullptr;
    QLabel* m_model = nullptr;
    widgets::VerdictView* m_verdict = nullptr;
};

} // namespace halbench::app
