#pragma once

#include "app/documents/calibration_file.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/wizards/live_hall.h"
#include "app/wizards/wizard_panel.h"

#include <QElapsedTimer>
#include <QTimer>

#include <array>
#include <memory>
#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;
class QTabWidget;

namespace halbench::widgets {
class EstimateTable;
class FigureView;
class ProgressRow;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

struct Actuator;
class Preflight;
class MotionGuide;
class WordsAndPictures;

/// Calibration of the sensors, the stray field and the static friction: what will happen, what was found
/// beside what the device has, and its application as an act of its own
/// (resources/help/identification.md section 6). Thread: GUI.
class CalibratePanel : public WizardPanel {
    Q_OBJECT
public:
    explicit CalibratePanel(Workbench& bench, QWidget* parent = nullptr);

    /// Nothing before the first calibration.
    std::optional<CalibrationRecord> record() const;
    /// Shows a calibration of the project, or none. It can be applied to the device it was made on; nothing
    /// is written by showing it.
    void restore(std::optional<CalibrationRecord> record);

Q_SIGNALS:
    void calibrated(); ///< measured, applied or taken back; not when restored from a project
    void helpRequested(const QString& page);
    void identifyRequested(); ///< what follows applied values

protected:
    void refreshWords() override;
    void onFileChooser() override;

private:
    enum Page { PreparePage, RunPage, ResultPage };
    enum Step { PrepareStep, ExciteStep, ProposeStep, ApplyStep };

    QWidget* buildPrepare();
    QWidget* buildStartRow();
    QWidget* buildRun();
    QWidget* buildResult();
    QWidget* buildWords();
    QWidget* buildResultButtons();
    const Actuator& actuator() const;
    bool isPossible(Calibration which) const; ///< for the device that is connected
    bool hasSeveralAxes() const;
    CalibrateConfig config() const;
    void refreshPlan();
    void onDevice();
    void onValues();
    void start();
    void showLive();
    /// The device's calibration records a motion that is made by hand.
    bool isMovedByHand() const;
    void onStage(ProcedureState stage);
    void finish(const Result<CalibrateResult>& result, const ResultHeader& header, std::uint64_t connection);
    void showResult();
    void showRows();
    void showFigures();
    void sayOrigin();
    bool isOfThisDevice() const;
    bool isOnDevice() const; ///< it has the proposed values, whoever wrote them
    void apply();
    void write(const std::vector<ParameterValue>& values, bool isApplying);

    std::uint64_t m_connection = 0; ///< counts the connections: a result belongs to one board, powered once
    std::optional<CalibrateResult> m_result;
    ResultHeader m_header;
    /// Where the result is from. One of before, measured or from a project, is for the device it was measured
    /// on, which starts with the values that it keeps: applying is another act.
    enum class Origin { ThisConnection, EarlierConnection, Project };
    Origin m_origin = Origin::ThisConnection;
    QString m_saidOfOrigin; ///< the message while it is of that

    QLabel* m_intro = nullptr;
    std::array<QCheckBox*, 3> m_choices{}; ///< in the order of Calibration
    QLabel* m_outlook = nullptr;
    Preflight* m_preflight = nullptr;
    QPushButton* m_start = nullptr;
    widgets::ProgressRow* m_progress = nullptr;
    widgets::FigureView* m_liveView = nullptr;
    std::shared_ptr<LiveHall> m_live; ///< of the run; the procedure's thread fills it
    MotionGuide* m_guide = nullptr;   ///< instead of the figure for a motion made by hand
    QTimer m_frame;
    QElapsedTimer m_sinceStart;
    double m_predicted_s = 0.0;
    double m_largest_T = 0.0;
    bool m_isCancelling = false;
    widgets::VerdictView* m_verdict = nullptr;
    widgets::EstimateTable* m_table = nullptr;
    QLabel* m_gain = nullptr;
    QLabel* m_friction = nullptr;
    QLabel* m_provenance = nullptr;
    WordsAndPictures* m_both = nullptr; ///< result: table and pictures
    QTabWidget* m_figures = nullptr;
    std::array<widgets::FigureView*, 3> m_views{}; ///< ellipse, what it leaves, static friction
    QPushButton* m_apply = nullptr;
    QPushButton* m_restore = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_again = nullptr;
};

} // namespace halbench::app
