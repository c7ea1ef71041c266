#pragma once

#include "app/analyses/spherical/estimator_comparison.h"
#include "app/workbench/latest_task.h"
#include "app/workspaces/actuators/actuator_panel.h"

#include <QTimer>
#include <QWidget>

#include <atomic>
#include <memory>

class QBoxLayout;
class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace halbench::widgets {
class MessageBar;
class ProgressRow;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// Compares all orientation estimators on the same poses, random, of a published trajectory, the rows that
/// came last or those of a recording, for the sensors of the connected device or of the recording that is
/// played (resources/help/monitor.md, "Estimators"). Computes on a thread of its own. Thread: GUI.
class EstimatorPanel : public QWidget {
    Q_OBJECT
public:
    EstimatorPanel(Workbench& bench, StopWatch now_s, QWidget* parent = nullptr);
    ~EstimatorPanel() override;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    /// Of the thread that computes.
    struct Running {
        std::atomic<bool> isCancelled = false;
        std::atomic<double> progress = 0.0;
    };

    void buildFields(QBoxLayout& column);
    void buildTable();
    void onDevice();
    void askRecording();
    void takeRecording(std::shared_ptr<const devices::RecordedFile> file);
    ComparedPoses poses() const;
    bool isOfRecording() const;
    bool isOfLiveRows() const;
    bool isOfRows() const { return isOfRecording() || isOfLiveRows(); }
    std::shared_ptr<const devices::RecordedFile> rows() const;
    void want();
    EstimatorComparisonConfig config() const;
    std::function<Result<EstimatorComparison>()> comparison() const;
    void start();
    void cancel();
    void take(const Result<EstimatorComparison>& comparison);
    void showComparison(const EstimatorComparison& comparison);
    void showNote(const EstimatorComparison* comparison);
    void showRow(int row, const ComparedEstimator& estimator);
    void refresh();
    bool hasDevice() const;

    Workbench& m_bench;
    StopWatch m_now_s;
    QLabel* m_words = nullptr;
    QComboBox* m_poses = nullptr;
    QComboBox* m_device = nullptr;
    widgets::QuantityEdit* m_spin = nullptr;
    widgets::QuantityEdit* m_count = nullptr;
    widgets::QuantityEdit* m_noise = nullptr;
    widgets::QuantityEdit* m_failure = nullptr;
    widgets::QuantityEdit* m_passes = nullptr;
    widgets::QuantityEdit* m_seed = nullptr;
    QPushButton* m_compare = nullptr;
    widgets::ProgressRow* m_running = nullptr;
    widgets::MessageBar* m_message = nullptr;
    QTableWidget* m_table = nullptr;
    QLabel* m_note = nullptr;
    std::string m_recordingUri;                               ///< the device that was asked for its recording
    std::shared_ptr<const devices::RecordedFile> m_recording; ///< that is played
    QTimer m_tick;
    bool m_isNoiseOfBoard = false;       ///< until the user writes another
    std::shared_ptr<Running> m_progress; ///< while it computes
    LatestTask m_task;                   ///< last: what it computes ends first
};

ActuatorPanel estimatorActuatorPanel();

} // namespace halbench::app
