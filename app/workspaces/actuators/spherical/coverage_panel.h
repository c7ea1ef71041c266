#pragma once

#include "app/analyses/spherical/coverage_slice.h"
#include "app/workbench/document_files.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/latest_task.h"
#include "app/workspaces/actuators/actuator_panel.h"

#include <QWidget>

#include <atomic>
#include <memory>
#include <optional>

class QBoxLayout;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace halbench::widgets {
class CoverageView;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

class PlacementEditor;

/// Coverage of the connected board's sensors, or of those of the recording that is played, as slices over two
/// angles with a slider for the third; beside it the sensors on the rotor, which can be moved on trial
/// (resources/help/monitor.md, "Coverage"). Computes on threads of its own. Thread: GUI.
class CoveragePanel : public QWidget {
    Q_OBJECT
public:
    explicit CoveragePanel(Workbench& bench, QWidget* parent = nullptr);
    ~CoveragePanel() override;

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }

private:
    void buildFields(QBoxLayout& column);
    void buildHeld(QBoxLayout& column);
    void buildPictures(QBoxLayout& column);
    void buildEnd(QBoxLayout& column);
    void onDevice();
    void onSensors();
    void onHeldAngle();
    void hold(double angle_deg);
    void askSlice();
    void askJudgement();
    void askWorkspace();
    void takeSlice(const CoverageSliceConfig& config, const Result<SliceOfCoverage>& slice);
    void takeJudgement(const Result<CoverageJudgement>& judgement);
    void takeWorkspace(const Result<CoverageOfWorkspace>& workspace);
    void showFigures();
    void showPose();
    void goToCounterexample();
    void markCounterexample();
    void showWords();
    void savePicture();
    models::CoverageModel model() const;
    CoverageSliceConfig config() const;
    HeldAngle held() const;
    bool hasDevice() const;

    Workbench& m_bench;
    QLabel* m_words = nullptr;
    QComboBox* m_quantity = nullptr;
    QComboBox* m_device = nullptr;
    QComboBox* m_heldAngle = nullptr;
    widgets::QuantityEdit* m_threshold = nullptr;
    widgets::QuantityEdit* m_noise = nullptr;
    QSlider* m_slider = nullptr;
    widgets::QuantityEdit* m_held = nullptr;
    PlacementEditor* m_sensors = nullptr;
    widgets::CoverageView* m_view = nullptr;
    QPushButton* m_go = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_recommended = nullptr;
    QLabel* m_figures = nullptr;
    QPushButton* m_save = nullptr;
    QLabel* m_cursor = nullptr;
    QLabel* m_verdict = nullptr;
    FileChooser m_chooser;
    FileQueue m_files;
    std::optional<CoverageJudgement> m_judgement;
    std::optional<models::PlacementResult> m_placement; ///< figures of the sensors shown
    QString m_problem;                                  ///< of the last computation or file
    std::size_t m_uncovered = 0;
    std::size_t m_poses = 0;
    std::shared_ptr<std::atomic<bool>> m_isStopped; ///< the proof that runs
    LatestTask m_slicing;                           ///< last: what they compute ends first
    LatestTask m_judging;
    LatestTask m_assessing;
};

ActuatorPanel coverageActuatorPanel();

} // namespace halbench::app
