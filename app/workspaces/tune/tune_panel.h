#pragma once

#include "app/documents/axis_model_file.h"
#include "app/documents/frequency_file.h"
#include "app/documents/model_file.h"
#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/frequency/axes_frequency.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/tune/gain_history.h"
#include "app/workspaces/tune/saved_designs.h"
#include "app/workspaces/tune/tune_question.h"
#include "control/design/crossover_design.h"

#include <QTimer>
#include <QWidget>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QAction;
class QCheckBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QToolButton;

namespace halbench::widgets {
struct Figure;
struct Remark;
class EmptyState;
class FigureView;
class MessageBar;
struct Message;
class ProgressRow;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

class AxisTunePanel;
class DesignTable;
class FilterEditor;
class ForeignMotorNotice;
class GainEditor;
class LoopSliders;
class LoopView;
class PageChooser;
class Preflight;
struct NamedLoop;
class TuneForm;
class TuneNumbers;
class WhatIfPage;

/// Gains for the identified motor: by a method, a preset or by hand, with everything that is predicted of
/// them; applied as one transaction with a verification move, kept or taken back
/// (resources/help/tuning.md). Predictions come from a worker. Thread: GUI.
class TunePanel : public QWidget {
    Q_OBJECT
public:
    explicit TunePanel(Workbench& bench, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser);
    /// Whether an answer about the proposed gains is still to come.
    bool isComputing() const { return m_sketching.isBusy() || m_judging.isBusy(); }
    /// Shows the project's gains as they are, until others are chosen: their method is named, not run again.
    /// None: the first method.
    void restoreDesign(std::optional<GainsFile> gains);
    /// The project's other designs, by name, and what they are now.
    void setSavedDesigns(std::vector<KeptDesign> designs);
    /// One more that the project held otherwise; nothing done to the others is forgotten.
    void adoptDesign(const std::string& name, std::string document);
    const std::vector<KeptDesign>& savedDesigns() const { return m_designs.all(); }
    /// A kept design becomes the proposed one; nothing without one of this name.
    void takeUpDesign(const std::string& name);
    /// Draws a plant that was measured into the open loop; what is no plant of this loop is refused in place.
    void useMeasured(const MeasuredPlant& plant);
    /// Shows what the proposed gains would have made of a recorded move; what is none is refused in place.
    void useRecording(const QString& path);
    /// Gains by Ziegler and Nichols, from where the loop was measured to swing.
    void useUltimate(double gain_A_per_rad, double period_s);
    /// Gains for the axes of a device with several, identified just now.
    void useAxisModel(const AxisModelFile& model);
    /// A measured response of several axes in their open loops, now or once they are identified.
    void useMeasuredAxes(const AxesFrequencyResult& response);
    /// What runs on the device lasts longer than its power from now on.
    void onSavedInDevice();
    /// What was done to the proposed gains, taken back and done again; named after it.
    const QList<QAction*>& historyActions() const { return m_historyActions; }

Q_SIGNALS:
    void identifyRequested(); ///< there is no motor to tune yet
    void savingRequested();   ///< in the device, what is kept
    void drivingRequested();  ///< with what is kept on a simulated device, which saves nothing
    /// A device was left on which gains of this panel were kept, or still to be decided on: where they are
    /// now. The project has them as this design.
    void gainsLeft(const QString& text, const QString& remedy, const QString& design);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// A proposal and its loop's bandwidth.
    using Answer = std::pair<Result<TuneResult>, std::optional<double>>;
    /// Gains of this panel that a device has in its working memory.
    struct AppliedGains {
        std::string document; ///< what Save gains would have written
        LoopLaw law;
        QString device;
        bool isSimulated = false;
    };

    /// Gains in the hand of who moves a crossover, a margin or a pole.
    struct Shaping {
        LoopLaw law;                              ///< when it was taken
        std::optional<control::CrossoverAim> aim; ///< what is wanted now; nothing: the loop does not cross
        double factor = 1.0;                      ///< wanted on all gains of `law`
        QString what;                             ///< is moved
        enum class Kind { Crossover, Margin, Gain } kind = Kind::Crossover;
        bool isWaiting = false; ///< until the picture of the last move is there
        bool isHeld = false;    ///< until it is released; else a step of the keyboard
    };

    void shareWidth();
    QWidget* buildSettings();
    QWidget* buildFigures();
    QWidget* buildVerification();
    QWidget* buildButtons();
    void connectParts();
    void connectDesigns();
    void connectShaping();
    bool startShaping(bool isHeld);
    void shape(Shaping::Kind kind, double value);
    void takeShape();
    void endShaping();
    Result<LoopLaw> filteredLaw();
    Result<LoopLaw> editedLaw() const;
    Result<LoopLaw> chosenLaw() const;
    void useEdited(const LoopLaw& law);
    void showShape();
    void createHistory();
    GainChoice choiceNow() const;
    void record(const QString& what, const QString& key = {});
    void recordChoice();
    void recordEdit();
    void connectFilters();
    /// Why these gains cannot be applied to the connected device in the chosen way; nothing: they can.
    std::optional<Error> obstacle() const;
    void restartHistory();
    void goTo(const GainChoice& choice);
    void refreshHistory();
    void keepDesign();
    void takeUp(int kept);
    void openGains();
    void takeFromFile(const QString& path, const Result<GainsFile>& gains);
    void compareDesigns();
    void forgetJudgements();
    void showDesigns();
    QString reasonOf(const KeptDesign& design) const;
    std::vector<NamedLoop> drawnLoops() const;
    const std::optional<AnalysisResult>& present() const;
    void chooseMeasured();
    void forgetMeasured();
    void connectWhatIf();
    void chooseRecording();
    void onMessageAction();
    void chooseRanGains();
    void showRecording(const QString& path);
    void refuseRecording(const Error& error);
    void forgetRecording();
    void proposeToWhatIf();
    std::optional<MeasuredLoop> drawnMeasurement() const;
    void refreshMeasuredWords();
    void drawPredictions();
    void drawLoaded();
    void refreshWords();
    void refreshEmpty();
    void refreshOutlook();
    void growVerification();
    void refreshModel();
    AxisTunePanel& axisPanel();
    void showPage();
    void forgetRestored();
    void onDevice();
    void forgetVerification();
    void readConditions();
    std::map<std::string, double> valuesBefore() const;
    void ask();
    std::optional<TuneQuestion> question();
    void showSketch(Result<TuneSketch> sketch);
    void judge();
    bool isMoving() const;
    void spreadLargeStep(const TuneResult& proposed);
    void showAnswer(const Result<TuneResult>& answer, std::optional<double> bandwidth_rad_s);
    void showProblem(const Error& error);
    void refreshButtons();
    void focusNext();
    void keep();
    QString keptDesignOf(const AppliedGains& gains, const QString& stem);
    void leaveGains();
    void apply();
    void startApplying(const LoopLaw& law, std::vector<ParameterValue> values);
    void finishApply(const Result<ApplyResult>& result);
    void showVerification(const ApplyResult& result);
    void drawVerification();
    void drawShownVerification();
    void showAgreement(const std::vector<widgets::Remark>& remarks);
    void useRecord(const ApplyResult& result);
    void forgetRecord();
    void replayRecord();
    bool isWhatIfDrawn() const;
    void addWhatIf(widgets::Figure& figure, std::vector<widgets::Remark>& remarks) const;
    void tellOfDevice(const widgets::Message& message);
    void forgetToldOfDevice();
    void onUnits();
    void restore();
    void saveGains();
    void showError(const Error& error);

    Workbench& m_bench;
    FileChooser m_chooser;
    LatestTask m_sketching; ///< what can be drawn at once
    LatestTask m_judging;   ///< the rest
    LatestTask m_comparing; ///< the kept designs
    LatestTask m_opening;   ///< a file of gains
    LatestTask m_spreading; ///< the band of the large step, which takes longest
    LatestTask m_recalling; ///< whether a verification move is explained
    LatestTask m_replaying; ///< the band of the same move with the proposed gains
    FileQueue m_files;
    LoopConditions m_conditions;
    std::optional<LoopLaw> m_presentLaw; ///< on the device, or before an apply
    std::optional<GainsFile> m_restored; ///< of the project; until others are chosen
    SteadyPrediction m_steady;           ///< of the last sketch
    SavedDesigns m_designs;
    std::optional<Shaping> m_shaping;
    GainHistory m_history;
    QList<QAction*> m_historyActions;            ///< undo, redo
    std::map<std::string, JudgedLoop> m_judged;  ///< kept designs by their document
    std::map<std::string, Error> m_unjudged;     ///< likewise: why not
    std::optional<Error> m_problem;              ///< why nothing is proposed
    std::optional<MeasuredPlant> m_measured;     ///< drawn into the open loop
    std::optional<double> m_bandwidth_rad_s;     ///< of what is shown
    std::optional<TuneQuestion> m_asked;         ///< to be judged once its sketch is seen
    std::optional<TuneSketch> m_sketch;          ///< what is drawn
    std::optional<TuneResult> m_shown;           ///< what the numbers say, and what would be applied
    std::optional<AppliedGains> m_applying;      ///< on their way
    std::optional<AppliedGains> m_undecided;     ///< applied, neither kept nor restored
    std::optional<AppliedGains> m_onDevice;      ///< kept
    std::uint64_t m_deviceNumber = 0;            ///< that both are of; 0: none
    std::vector<ParameterValue> m_before;        ///< what an apply replaced; empty when that is decided
    std::optional<ApplyResult> m_verified;       ///< the last apply that moved
    std::shared_ptr<const WhatIfBasis> m_record; ///< of its move; nothing: none, or not judged yet
    std::optional<WhatIf> m_whatIfSpread;        ///< its band with the proposed gains, when the hand rests
    bool m_isObstacleSaid = false;               ///< that what is drawn cannot be applied
    bool m_isUndone = false;                     ///< the gains that were verified were taken back
    QTimer m_decision;                           ///< runs until Keep can be meant
    QTimer m_rest;                               ///< until a hand that holds the gains rests
    bool m_isApplying = false;
    bool m_isOfThisMotor = false; ///< what is applied now; not once another project was opened meanwhile
    QString m_refusedRecording;   ///< until the gains that ran are chosen
    QString m_toldOfDevice;       ///< the message while it is of an apply, thus of one device and motor
    bool m_isWidthChosen = false; ///< by who moved the line between settings and pictures

    QSplitter* m_splitter = nullptr;
    QStackedWidget* m_pages = nullptr;
    widgets::EmptyState* m_empty = nullptr;
    AxisTunePanel* m_axes = nullptr; ///< once axes were identified or measured
    widgets::MessageBar* m_message = nullptr;
    QLabel* m_model = nullptr;
    TuneForm* m_form = nullptr;
    GainEditor* m_gains = nullptr;
    FilterEditor* m_filters = nullptr; ///< of the same gains
    LoopSliders* m_sliders = nullptr;
    Preflight* m_preflight = nullptr;
    ForeignMotorNotice* m_foreign = nullptr;
    QCheckBox* m_inSteps = nullptr; ///< how Apply and verify goes
    QLabel* m_outlook = nullptr;    ///< what Apply and verify will do to the rotor
    QPushButton* m_apply = nullptr;
    QPushButton* m_keep = nullptr;
    QPushButton* m_restore = nullptr;
    QToolButton* m_save = nullptr;
    QToolButton* m_open = nullptr;
    QPushButton* m_measure = nullptr;
    WhatIfPage* m_whatIfPage = nullptr;
    widgets::ProgressRow* m_progress = nullptr;
    LoopView* m_loop = nullptr;
    PageChooser* m_figures = nullptr;
    widgets::FigureView* m_large = nullptr;
    widgets::FigureView* m_linear = nullptr;
    widgets::FigureView* m_loaded = nullptr;
    QWidget* m_verificationPage = nullptr;
    widgets::FigureView* m_verification = nullptr;
    QScrollArea* m_verificationRoom = nullptr;
    widgets::VerdictView* m_agreement = nullptr; ///< of measured and predicted
    TuneNumbers* m_numbers = nullptr;
    DesignTable* m_table = nullptr;
    widgets::VerdictView* m_verdict = nullptr;
};

} // namespace halbench::app
