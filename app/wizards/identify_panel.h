#pragma once

#include "app/wizards/live_plateaus.h"
#include "app/wizards/wizard_panel.h"
#include "app/workbench/shared_results.h"

#include <QElapsedTimer>
#include <QTimer>

#include <map>
#include <memory>
#include <string>

class QLabel;
class QPushButton;

namespace halbench::widgets {
class FigureView;
class ProgressRow;
} // namespace halbench::widgets

namespace halbench::app {

class AxesIdentifyPanel;
class IdentifyForm;
struct AxisModelFile;
class IdentifyResultView;
class Preflight;

/// The identification step by step: what will move, the sweep live, the result with its verdict. It drives
/// the same runIdentify() as the batch program and saves the same file (resources/help/identification.md).
/// A device with several axes has AxesIdentifyPanel in its place.
/// Thread: GUI.
class IdentifyPanel : public WizardPanel {
    Q_OBJECT
public:
    explicit IdentifyPanel(Workbench& bench, QWidget* parent = nullptr);

    /// The constants that the form holds, by symbol (J, c, Kf, phi; SI): they are kept in the project.
    std::map<std::string, double> given() const;
    void setGiven(const std::map<std::string, double>& given);

Q_SIGNALS:
    void tuneRequested(); ///< the user wants to go on with the identified motor or axes
    void axesIdentified(const halbench::app::AxisModelFile& model); ///< of a device with several
    void helpRequested(const QString& page);

protected:
    void refreshWords() override;
    void onFileChooser() override;

private:
    enum Page { PreparePage, RunPage, ResultPage };

    QWidget* buildPrepare();
    QWidget* buildStartRow();
    QWidget* buildRun();
    QWidget* buildResult();
    QWidget* buildResultButtons();
    void onDevice();
    void showAxes(bool areSeveral);
    void refreshPlan();
    void start();
    void showLive();
    void drawLive(const std::vector<LivePlateaus::Point>& points);
    void onUnits();
    void onStage(ProcedureState stage);
    void finish(const ResultHeader& header, const Result<IdentifyResult>& result);
    void load();
    void take(const IdentifyResult& result, const Provenance& provenance);
    void onIdentification();
    void sayProject();
    void showResult(const IdentifyResult& result, const Provenance& provenance);

    std::shared_ptr<LivePlateaus> m_live;
    IdentifyConfig m_running; ///< of the run that is under way
    double m_predicted_s = 0.0;
    std::size_t m_drawnPoints = 0;
    double m_largest_rad_s = 0.0; ///< end of the live picture's speeds: grows only
    bool m_isCancelling = false;
    QElapsedTimer m_sinceStart;
    QTimer m_frame;
    IdentifyResult m_found;       ///< what is shown, refused or not
    ResultHeader m_header;        ///< of the same
    bool m_isFromProject = false; ///< the same

    QLabel* m_intro = nullptr;
    IdentifyForm* m_form = nullptr;
    QLabel* m_outlook = nullptr;
    Preflight* m_preflight = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_loadFirst = nullptr;
    widgets::ProgressRow* m_progress = nullptr;
    widgets::FigureView* m_liveView = nullptr;
    IdentifyResultView* m_result = nullptr;
    QPushButton* m_tune = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_load = nullptr;
    QPushButton* m_again = nullptr;
    AxesIdentifyPanel* m_axes = nullptr; ///< once a device with several axes was there
};

} // namespace halbench::app
