#include "app/wizards/identify_panel.h"

#include "app/documents/identification_file.h"
#include "app/documents/result_documents.h"
#include "app/wizards/axes_identify_panel.h"
#include "app/wizards/identify_form.h"
#include "app/wizards/identify_result_view.h"
#include "app/wizards/identify_text.h"
#include "app/workspaces/parts/figure_units.h"
#include "app/workspaces/parts/preflight.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/step_list.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {
namespace {

constexpr int Frame_ms = 100;
constexpr double AssumedStart_degC = 25.0;
enum Step { PrepareStep, ExciteStep, FitStep, JudgeStep, ResultStep };

} // namespace

IdentifyPanel::IdentifyPanel(Workbench& workbench, QWidget* parent) : WizardPanel(workbench, parent) {
    addPage(buildPrepare(), true, buildStartRow());
    QWidget* run = buildRun(); // makes its footer: not in one expression with it
    addPage(run, false, m_progress);
    addPage(buildResult(), false, buildResultButtons());
    m_result->setFileChooser(&chooser());
    m_frame.setInterval(Frame_ms);
    connect(&m_frame, &QTimer::timeout, this, &IdentifyPanel::showLive);
    connect(&bench(), &Workbench::deviceChanged, this, &IdentifyPanel::onDevice);
    connect(&bench(), &Workbench::valuesChanged, this, &IdentifyPanel::refreshPlan);
    connect(&bench(), &Workbench::identificationChanged, this, &IdentifyPanel::onIdentification);
    connect(&bench().session(), &DeviceSession::procedureStage, this, &IdentifyPanel::onStage);
    connect(&bench(), &Workbench::displayUnitsChanged, this, &IdentifyPanel::onUnits);
    IdentifyPanel::refreshWords();
    onDevice();
    onUnits();
}

void IdentifyPanel::onFileChooser() {
    m_save->setVisible(bool(chooser().save));
    m_load->setVisible(bool(chooser().open));
    m_loadFirst->setVisible(bool(chooser().open));
    if (m_axes != nullptr) {
        m_axes->setFileChooser(chooser());
    }
}

void IdentifyPanel::showAxes(bool areSeveral) {
    if (areSeveral && m_axes == nullptr) {
        m_axes = new AxesIdentifyPanel(bench(), this);
        m_axes->setFileChooser(chooser());
        connect(m_axes, &AxesIdentifyPanel::tuneRequested, this, &IdentifyPanel::tuneRequested);
        connect(m_axes, &AxesIdentifyPanel::identified, this, &IdentifyPanel::axesIdentified);
        setAlternative(*m_axes);
    }
    showAlternative(areSeveral);
}

std::map<std::string, double> IdentifyPanel::given() const {
    return m_form->given();
}

void IdentifyPanel::setGiven(const std::map<std::string, double>& given) {
    m_form->setGiven(given);
    refreshPlan();
}

QWidget* IdentifyPanel::buildPrepare() {
    m_intro = new QLabel;
    m_outlook = new QLabel;
    m_form = new IdentifyForm;
    m_preflight = new Preflight(bench());
    connect(m_form, &IdentifyForm::changed, this, &IdentifyPanel::refreshPlan);
    connect(m_preflight, &Preflight::changed, this, &IdentifyPanel::refreshPlan);
    return makePreparation(*m_intro, *m_form, *m_outlook, *m_preflight);
}

QWidget* IdentifyPanel::buildStartRow() {
    m_start = new QPushButton(this);
    m_loadFirst = new QPushButton(this);
    m_loadFirst->setIcon(widgets::themedIcon(QStringLiteral("open")));
    m_loadFirst->hide();
    connect(m_start, &QPushButton::clicked, this, &IdentifyPanel::start);
    connect(m_loadFirst, &QPushButton::clicked, this, &IdentifyPanel::load);
    return makeStartRow(*m_start, m_loadFirst);
}

QWidget* IdentifyPanel::buildRun() {
    auto* page = new QWidget;
    auto* column = columnOf(page, widgets::PanelMargin_px);
    m_progress = new widgets::ProgressRow(page);
    m_liveView = new widgets::FigureView(page);
    column->addWidget(m_liveView, 1);
    connect(m_progress, &widgets::ProgressRow::cancelRequested, this, [this] {
        m_isCancelling = true;
        bench().session().abortProcedure();
    });
    return page;
}

QWidget* IdentifyPanel::buildResult() {
    auto* page = new QWidget;
    auto* column = columnOf(page, widgets::PanelMargin_px);
    m_result = new IdentifyResultView(page);
    column->addWidget(m_result, 1);
    connect(m_result, &IdentifyResultView::helpRequested, this, &IdentifyPanel::helpRequested);
    connect(m_result, &IdentifyResultView::notSaved, this,
            [this](const QString& text, const QString& remedy) {
                messages().showMessage({widgets::Severity::Error, text, remedy, {}});
            });
    return page;
}

QWidget* IdentifyPanel::buildResultButtons() {
    m_tune = new QPushButton(this);
    m_save = new QPushButton(this);
    m_load = new QPushButton(this);
    m_again = new QPushButton(this);
    widgets::setRole(*m_tune, widgets::Role::Primary);
    m_save->setIcon(widgets::themedIcon(QStringLiteral("save")));
    m_load->setIcon(widgets::themedIcon(QStringLiteral("open")));
    m_save->hide();
    m_load->hide();
    connect(m_tune, &QPushButton::clicked, this, &IdentifyPanel::tuneRequested);
    connect(m_save, &QPushButton::clicked, this, [this] {
        save({tr("Save as model"), QStringLiteral("model.json"), tr("Model (*.json)")},
             [header = m_header, result = m_found] { return identificationDocument(header, result); });
    });
    connect(m_load, &QPushButton::clicked, this, &IdentifyPanel::load);
    connect(m_again, &QPushButton::clicked, this, [this] { beginAgain(PreparePage, *m_start); });
    return makeButtonRow({m_tune, m_save, m_load, m_again});
}

void IdentifyPanel::refreshWords() {
    setSteps({tr("Prepare"), tr("Excite"), tr("Fit"), tr("Assess"), tr("Result")});
    m_intro->setText(tr("Measures damping, friction, torque constant and inertia with 95 % intervals, from "
                        "steady currents and coast-downs."));
    sayButton(*m_start, tr("Start identification"), tr("The rotor turns (Ctrl+Return); Esc stops it"));
    sayButton(*m_loadFirst, tr("Load model…"), tr("Show a saved model"));
    sayButton(*m_tune, tr("Tune with this model"), tr("Design gains for this motor"));
    sayButton(*m_save, tr("Save as model…"), tr("Save a file for the commands tune and analyse"));
    sayButton(*m_load, tr("Load model…"), tr("Show a saved model"));
    sayButton(*m_again, tr("Identify again"),
              tr("Back to the settings; this result stays until the next run"));
    m_liveView->setToolTip(tr("Plateaus completed so far; the fit follows at the end"));
    refreshPlan();
}

void IdentifyPanel::onDevice() {
    const DeviceSession& session = bench().session();
    if (session.state() == SessionState::Connected) {
        m_form->setSeed(seedOf(session.info()));
        showAxes(session.catalogue().axes.size() > 1);
    }
    if (isDepartureTold()) { // until it is read or the next one starts
        refreshPlan();
        return;
    }
    if (session.state() == SessionState::Connected) {
        messages().clear();
    }
    if (m_isFromProject) {
        sayProject();
    }
    refreshPlan();
}

void IdentifyPanel::refreshPlan() {
    if (const auto limit_A = bench().deviceValue("limit.current")) {
        m_form->setCurrentLimit_A(*limit_A);
    }
    const auto config = m_form->config();
    if (!config) {
        m_outlook->setText(problemText(config.error()));
        widgets::setRole(*m_outlook, widgets::Role::Bad);
        m_start->setEnabled(false);
        return;
    }
    const QString& notice = m_form->notice();
    widgets::setRole(*m_outlook, notice.isEmpty() ? widgets::Role::None : widgets::Role::Warn);
    const double start_degC = m_preflight->temperature_degC().value_or(AssumedStart_degC);
    m_outlook->setText((notice.isEmpty() ? notice : notice + QLatin1Char('\n')) +
                       outlookText(*config, sweepOutlook(*config, start_degC), bench().displayUnits()));
    m_preflight->setForecast([config = *config](double now_degC) {
        return predictIdentify(config, now_degC).highestTemperature_degC;
    });
    m_start->setEnabled(m_preflight->isPassed());
}

void IdentifyPanel::start() {
    const auto config = m_form->config();
    if (!config || !m_preflight->isPassed()) {
        return;
    }
    m_running = *config;
    m_live = std::make_shared<LivePlateaus>();
    const bool hasStarted = runProcedure(
        tr("Identify"),
        [config = *config, live = m_live](devices::Device& device, const ProcedureObserver& session) {
            const ProcedureObserver observer =
                listeningIn(session, [live](const SampleBlock& block) { live->take(block); });
            return runIdentify(device, config, observer);
        },
        [this, header = headerOf("halbench.identification/1", config->seed)](
            const Result<IdentifyResult>& result) { finish(header, result); });
    if (!hasStarted) {
        return;
    }
    const SweepOutlook outlook =
        sweepOutlook(*config, m_preflight->temperature_degC().value_or(AssumedStart_degC));
    m_predicted_s = outlook.prediction.duration_s;
    m_drawnPoints = 0;
    m_isCancelling = false;
    m_largest_rad_s = 1.2 * outlook.largestSpeed_rad_s;
    drawLive({});
    m_progress->setText(tr("Identifying"));
    m_progress->setProgress(0.0);
    runStep(PrepareStep);
    showPage(RunPage);
    m_progress->setFocus(Qt::OtherFocusReason);
    m_sinceStart.start();
    m_frame.start();
}

void IdentifyPanel::showLive() {
    const auto points = m_live->points();
    if (points.size() != m_drawnPoints) {
        m_drawnPoints = points.size();
        for (const LivePlateaus::Point& point : points) {
            m_largest_rad_s = std::max(m_largest_rad_s, 1.2 * std::abs(point.speed_rad_s));
        }
        drawLive(points);
    }
    if (!m_isCancelling && m_predicted_s > 0.0) {
        // The plan is that of the published motor; another one may take longer.
        const double done = std::min(0.99, m_live->elapsed_s() / m_predicted_s);
        const double wall_s = 1e-3 * static_cast<double>(m_sinceStart.elapsed());
        m_progress->setProgress(done,
                                done > 0.02 ? std::optional(wall_s * (1.0 - done) / done) : std::nullopt);
    }
}

void IdentifyPanel::drawLive(const std::vector<LivePlateaus::Point>& points) {
    m_liveView->setFigure(
        inUnits(livePlateauFigure(points, m_running.sweep.to_A, m_largest_rad_s), bench().displayUnits()));
}

void IdentifyPanel::onUnits() {
    m_result->setUnits(bench().displayUnits());
    if (isMine()) {
        drawLive(m_live->points());
    }
}

void IdentifyPanel::onStage(ProcedureState stage) {
    if (!isMine()) {
        return;
    }
    switch (stage) {
    case ProcedureState::Excite:
    case ProcedureState::Record:
        runStep(ExciteStep);
        m_progress->setText(tr("Rotor turning: plateaus and coast-downs"));
        break;
    case ProcedureState::Fit:
        runStep(FitStep);
        m_progress->setText(tr("Fitting the recorded motion"));
        break;
    case ProcedureState::Judge:
        runStep(JudgeStep);
        break;
    default:
        break;
    }
}

void IdentifyPanel::finish(const ResultHeader& header, const Result<IdentifyResult>& result) {
    m_frame.stop();
    if (!result) {
        fail(result.error(), tr("Identification cancelled. Nothing was changed."));
        refreshPlan();
        m_start->setFocus(Qt::OtherFocusReason);
        return;
    }
    bench().session().message(MessageLevel::Info, tr("Identify"), verdictTitle(result->quality));
    take(*result, {header, ResultOrigin::Measured});
}

/// A refused result is shown, but does not take away the good one that others work with.
void IdentifyPanel::take(const IdentifyResult& result, const Provenance& provenance) {
    if (result.quality.verdict == Verdict::Refused) {
        messages().clear();
        showResult(result, provenance);
    } else {
        bench().setIdentification(result, provenance);
    }
}

/// Another one is there: measured, loaded, or come with the project. A sweep that runs keeps its page.
void IdentifyPanel::onIdentification() {
    if (isMine()) {
        return;
    }
    messages().clear();
    if (!bench().identification()) {
        m_isFromProject = false;
        showPage(PreparePage);
        resetSteps();
        return;
    }
    showResult(*bench().identification(), bench().provenance());
}

void IdentifyPanel::showResult(const IdentifyResult& result, const Provenance& provenance) {
    m_header = provenance.header;
    m_found = result;
    m_result->setResult(result, provenance.header);
    m_isFromProject = provenance.origin == ResultOrigin::Project;
    if (m_isFromProject) {
        sayProject();
    }
    const bool isUsable = result.quality.verdict != Verdict::Refused;
    m_tune->setEnabled(isUsable);
    runStep(ResultStep);
    endStep(ResultStep, isUsable ? widgets::StepState::Done : widgets::StepState::Failed);
    showPage(ResultPage);
    if (provenance.origin != ResultOrigin::Project) {
        (isUsable ? m_tune : m_again)->setFocus(Qt::OtherFocusReason);
    }
}

/// It stays what it is when a device comes; whether it is of that one changes.
void IdentifyPanel::sayProject() {
    const DeviceSession& session = bench().session();
    const bool isConnected = session.state() == SessionState::Connected;
    messages().showMessage({widgets::Severity::Information,
                            projectModelText(m_header) + QLatin1Char(' ') +
                                projectDeviceText(m_header, isConnected ? &session.info() : nullptr),
                            tr("Identify again if the motor has changed."),
                            {}});
}

void IdentifyPanel::load() {
    const QString path =
        chooser().open ? chooser().open(this, {tr("Load model"), {}, tr("Model (*.json)")}) : QString();
    if (path.isEmpty()) {
        return;
    }
    files().run([path = path.toStdString()] { return readIdentificationFile(path); },
                [this](const Result<IdentificationFile>& file) {
                    if (!file) {
                        showError(file.error());
                        return;
                    }
                    take(file->result, {file->header, ResultOrigin::File});
                });
}

} // namespace halbench::app
