#pragma once

#include "app/procedures/apply/apply_axes.h"
#include "app/workbench/file_chooser.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/tune/axes/axis_loops.h"

#include <QWidget>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace halbench::widgets {
class FigureView;
class MessageBar;
class ProgressRow;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

class AxisGainEditor;
class AxisGainFiles;
class AxisResponseButton;
class AxisTargets;
class LoopSliders;
class LoopView;
class PageChooser;
class Preflight;

/// Gains for the axes of a device with several: one axis is chosen, its gains come by a method, from the
/// device or by hand, with loop, step and verdict in its units; the chosen or all axes are applied in one
/// transaction, each verified by a step (resources/help/tuning.md, "Loops of several axes"). Thread: GUI.
class AxisTunePanel : public QWidget {
    Q_OBJECT
public:
    explicit AxisTunePanel(Workbench& bench, QWidget* parent = nullptr);

    /// Designs every axis by the recommended method.
    void setModel(const AxisModelFile& model);
    /// The axes that were identified are those of a device of this model.
    bool isFor(const std::string& model) const;
    /// Measured plants by axis, for the open loops; kept until axes are identified, if none are. None takes
    /// those that are shown away.
    void useMeasured(std::map<std::string, MeasuredPlant> plants);
    /// Without one no gains are opened and saved, and no measured response is opened.
    void setFileChooser(FileChooser chooser);
    const AxisLoops& loops() const { return m_loops; }
    const std::string& axis() const { return m_axis; }

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildSettings();
    QWidget* buildFigures();
    void connectParts();
    void refreshWords();
    void onValues();
    void chooseAxis(const std::string& axis);
    void chooseMethod();
    void takeTargets();
    void takeEdited(const LoopLaw& law);
    void shape(const control::CrossoverAim& aim, control::CrossoverPriority priority);
    void ask(const std::string& axis);
    void askNext();
    void showAxis();
    void showVerdict();
    void showVerification();
    std::vector<std::string> axesToApply() const;
    void refreshButtons();
    void apply();
    void finishApply(const Result<ApplyAxesResult>& result);
    void restore();
    void takeFromFile(const QString& path, const AxisGainsFile& gains);
    void refreshMeasured();
    void showError(const Error& error);

    Workbench& m_bench;
    AxisLoops m_loops;
    std::string m_axis;                 ///< that is shown
    std::vector<std::string> m_waiting; ///< axes to be asked, one after the other
    LatestTask m_task;
    bool m_isApplying = false;
    std::vector<ParameterValue> m_before; ///< what the last apply replaced
    std::optional<ApplyAxesResult> m_verified;

    widgets::MessageBar* m_message = nullptr;
    QFormLayout* m_form = nullptr;
    QComboBox* m_axes = nullptr;
    QComboBox* m_method = nullptr;
    AxisTargets* m_targets = nullptr;
    AxisGainEditor* m_gains = nullptr;
    LoopSliders* m_sliders = nullptr;
    QComboBox* m_scope = nullptr; ///< what Apply and verify means
    Preflight* m_preflight = nullptr;
    QPushButton* m_apply = nullptr;
    QPushButton* m_restore = nullptr;
    AxisGainFiles* m_gainFiles = nullptr;
    AxisResponseButton* m_response = nullptr;
    QPushButton* m_forget = nullptr; ///< takes the measured response of the axis away
    widgets::ProgressRow* m_progress = nullptr;
    widgets::VerdictView* m_verdict = nullptr;
    PageChooser* m_figures = nullptr;
    LoopView* m_loop = nullptr;
    widgets::FigureView* m_step = nullptr;
    widgets::FigureView* m_verification = nullptr;
};

} // namespace halbench::app
