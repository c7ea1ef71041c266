#pragma once

#include "app/analyses/spherical/angle_error.h"
#include "app/workbench/document_files.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/file_queue.h"
#include "app/workbench/latest_task.h"
#include "app/workspaces/actuators/actuator_panel.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QLabel;

namespace halbench::widgets {
class FigureView;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// Angle between the orientation that a simulated board estimates and the true one, over the last seconds
/// (resources/help/monitor.md, "Angle error"). Computes on a thread of its own, four times a second at most.
/// Thread: GUI.
class AngleErrorPanel : public QWidget {
    Q_OBJECT
public:
    explicit AngleErrorPanel(Workbench& bench, QWidget* parent = nullptr);

    void setFileChooser(FileChooser chooser) { m_chooser = std::move(chooser); }

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void onDevice();
    void want();
    void askAnew();
    void ask();
    void take(const AngleErrors& errors);
    bool hasDevice() const;
    std::vector<std::string> signalNames() const;

    Workbench& m_bench;
    widgets::QuantityEdit* m_span = nullptr;
    widgets::FigureView* m_view = nullptr;
    QLabel* m_words = nullptr;
    QTimer m_timer;
    std::optional<std::uint64_t> m_seen; ///< revision of the history
    FileChooser m_chooser;
    FileQueue m_files;
    LatestTask m_task; ///< last: what it computes ends first
};

ActuatorPanel angleErrorActuatorPanel();

} // namespace halbench::app
