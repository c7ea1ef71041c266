#include "app/wizards/calibrate_panel.h"

#include "app/actuators/actuator.h"
#include "app/documents/result_documents.h"
#include "app/figures/calibration_figures.h"
#include "app/tuning/loop_conditions.h"
#include "app/wizards/calibrate_text.h"
#include "app/wizards/identify_text.h"
#include "app/wizards/live_motion.h"
#include "app/wizards/motion_guide.h"
#include "app/wizards/note_label.h"
#include "app/wizards/words_and_pictures.h"
#include "app/workbench/document_files.h"
#include "app/workspaces/parts/preflight.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/step_list.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr int Frame_ms = 100;
constexpr double ExpectedField_T = 0.2; ///< first extent of the live picture
constexpr double Room_ratio = 1.2;

constexpr std::array Choices = {Calibration::Hall, Calibration::Stray, Calibration::StaticFriction};

} // namespace

CalibratePanel::CalibratePanel(Workbench& workbench, QWidget* parent) : WizardPanel(workbench, parent) {
    addPage(buildPrepare(), true, buildStartRow());
    QWidget* run = buildRun(); // makes its footer: not in one expression with it
    addPage(run, false, m_progress);
    addPage(buildResult(), false, buildResultButtons());
    connect(&bench(), &Workbench::deviceChanged, this, &CalibratePanel::onDevice);
    connect(&bench(), &Workbench::valuesChanged, this, &CalibratePanel::onValues);
    connect(&bench().session(), &DeviceSession::reportChanged, this, &CalibratePanel::refreshPlan);
    connect(&bench().session(), &DeviceSession::procedureChanged, this, &CalibratePanel::refreshPlan);
    connect(&bench().session(), &DeviceSession::procedureStage, this, &CalibratePanel::onStage);
    connect(&bench().session(), &DeviceSession::procedureProgress, this,
            [this](double fraction, const QString& text) {
                if (isMine()) {
                    m_progress->setText(widgets::inWords(text));
                    if (hasSeveralAxes()) {
                        m_progress->setProgress(fraction);
                    }
                }
            });
    connect(&bench(), &Workbench::displayUnitsChanged, this, [this] {
        refreshPlan();
        if (m_result) {
            showResult();
        }
    });
    connect(&messages(), &widgets::MessageBar::actionTriggered, this, &CalibratePanel::identifyRequested);
    m_frame.setInterval(Frame_ms);
    connect(&m_frame, &QTimer::timeout, this, &CalibratePanel::showLive);
    CalibratePanel::refreshWords();
}

QWidget* CalibratePanel::buildPrepare() {
    auto* page = new QWidget;
    auto* column = columnOf(page, widgets::GroupSpacing_px);
    m_intro = new QLabel(page);
    m_outlook = new QLabel(page);
    m_preflight = new Preflight(bench(), page);
    m_intro->setWordWrap(true);
    m_outlook->setWordWrap(true);
    column->addWidget(m_intro);
    for (QCheckBox*& choice : m_choices) {
        choice = new QCheckBox(page);
        choice->setChecked(true);
        column->addWidget(choice);
        connect(choice, &QCheckBox::toggled, this, &CalibratePanel::refreshPlan);
    }
    column->addWidget(m_outlook);
    column->addWidget(m_preflight);
    column->addStretch(1);
    connect(m_preflight, &Preflight::changed, this, &CalibratePanel::refreshPlan);
    return page;
}

QWidget* CalibratePanel::buildStartRow() {
    m_start = new QPushButton(this);
    connect(m_start, &QPushButton::clicked, this, &CalibratePanel::start);
    return makeStartRow(*m_start);
}

QWidget* CalibratePanel::buildRun() {
    auto* page = new QWidget;
    auto* column = columnOf(page, widgets::GroupSpacing_px);
    m_progress = new widgets::ProgressRow(page);
    m_liveView = new widgets::FigureView(page);
    m_guide = new MotionGuide(bench(), page);
    column->addWidget(m_liveView, 1);
    column->addWidget(m_guide, 1);
    connect(m_progress, &widgets::ProgressRow::cancelRequested, this, [this] {
        m_isCancelling = true;
        bench().session().abortProcedure();
    });
    return page;
}

QWidget* CalibratePanel::buildResult() {
    QWidget* words = buildWords();
    m_figures = new QTabWidget;
    for (widgets::FigureView*& view : m_views) {
        view = new widgets::FigureView(m_figures);
        m_figures->addTab(view, {});
        connect(view, &widgets::FigureView::exportRequested, this, [this, view = view] {
            savePicture(this, chooser(), QStringLiteral("calibration.svg"), files(), *view,
                        [this](const Error& error) { showError(error); });
        });
    }
    m_both = new WordsAndPictures(words, m_table, m_figures);
    return m_both;
}

QWidget* CalibratePanel::buildWords() {
    auto* page = new QWidget;
    auto* column = columnOf(page, widgets::GroupSpacing_px);
    m_verdict = new widgets::VerdictView(page);
    m_table = new widgets::EstimateTable(page);
    m_gain = new QLabel(page);
    m_friction = noteLabel(page);
    m_provenance = new QLabel(page);
    for (QLabel* label : {m_gain, m_provenance}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    widgets::setRole(*m_provenance, widgets::Role::Muted);
    connect(m_friction, &QLabel::linkActivated, this, &CalibratePanel::helpRequested);
    for (QWidget* part :
         std::initializer_list<QWidget*>{m_verdict, m_table, m_gain, m_friction, m_provenance}) {
        column->addWidget(part);
    }
    column->addStretch(1);
    return page;
}

QWidget* CalibratePanel::buildResultButtons() {
    m_apply = new QPushButton(this);
    m_restore = new QPushButton(this);
    m_save = new QPushButton(this);
    m_again = new QPushButton(this);
    widgets::setRole(*m_apply, widgets::Role::Primary);
    m_restore->setIcon(widgets::themedIcon(QStringLiteral("revert")));
    m_save->setIcon(widgets::themedIcon(QStringLiteral("save")));
    m_save->hide();
    connect(m_apply, &QPushButton::clicked, this, &CalibratePanel::apply);
    connect(m_restore, &QPushButton::clicked, this, [this] { write(m_result->before, false); });
    connect(m_save, &QPushButton::clicked, this, [this] {
        save({tr("Save calibration"), QStringLiteral("calibration.json"), tr("Calibration (*.json)")},
             [header = m_header, result = *m_result] { return calibrationDocument(header, result); });
    });
    connect(m_again, &QPushButton::clicked, this, [this] { beginAgain(PreparePage, *m_start); });
    return makeButtonRow({m_apply, m_restore, m_save, m_again});
}

void CalibratePanel::onFileChooser() {
    m_save->setVisible(bool(chooser().save));
}

void CalibratePanel::refreshWords() {
    setSteps({tr("Prepare"), tr("Measure"), tr("Propose"), tr("Apply")});
    const bool isByHand = isMovedByHand();
    m_intro->setText(isByHand ? tr("Finds gains, offsets, frames and places of the field sensors, and the "
                                   "field of the rotor, from a motion that you make.")
                     : hasSeveralAxes()
                         ? tr("Measures the errors of the field sensors and the field of the coils in them.")
                         : tr("Measures the errors of the angle sensors, the stray field of the coils "
                              "and the breakaway current."));
    const std::pair<QString, QString> choices[] = {
        {tr("Ha&ll sensors"),
         isByHand ? tr("Gains, offsets, skews, frames and places of three sensors from a minute of motion")
         : hasSeveralAxes() ? tr("Amplitude, gains, cross-axis shares, offsets and places of every chip")
                            : tr("Offsets, gain ratio, orthogonality error and amplitude from the ellipse")},
        {tr("&Stray field of the coils"),
         isByHand           ? tr("Field per ampere in every channel; the current of the coil has to change")
         : hasSeveralAxes() ? tr("Field per ampere of every coil in every chip")
                            : tr("Without it the recommended gains are unstable")},
        {tr("Static fr&iction"), tr("For information: changes no parameter")}};
    m_choices.back()->setVisible(!isByHand); // nothing drives the rotor
    for (std::size_t i = 0; i < m_choices.size(); ++i) {
        m_choices[i]->setText(choices[i].first);
        m_choices[i]->setToolTip(choices[i].second);
        m_choices[i]->setAccessibleDescription(choices[i].second);
    }
    sayButton(*m_start, tr("Start calibration"),
              isByHand           ? tr("Records a minute (Ctrl+Return) while you move the rotor; Esc stops it")
              : hasSeveralAxes() ? tr("The actuator moves (Ctrl+Return); Esc stops it")
                                 : tr("The rotor moves (Ctrl+Return); Esc stops it"));
    sayButton(*m_apply, tr("Apply"), tr("Write all proposed values together, then read them back"));
    sayButton(*m_restore, tr("Restore"), tr("Write the values from before the calibration"));
    sayButton(*m_save, tr("Save calibration\u2026"), tr("Write the result as a file"));
    sayButton(*m_again, tr("Calibrate again"), tr("Back to the settings"));
    m_liveView->setToolTip(tr("Hall sensor readings; centre, axes and tilt of the ellipse are measured"));
    refreshPlan();
    if (m_result) {
        showResult();
    }
}

const Actuator& CalibratePanel::actuator() const {
    return actuatorOf(bench().session().info().model);
}

bool CalibratePanel::hasSeveralAxes() const {
    return bench().session().catalogue().axes.size() > 1;
}

bool CalibratePanel::isPossible(Calibration which) const {
    CalibrateConfig alone;
    alone.which = {which};
    return static_cast<bool>(actuator().calibrate.check(bench().session().catalogue(), alone));
}

CalibrateConfig CalibratePanel::config() const {
    CalibrateConfig config;
    config.which.clear();
    for (std::size_t i = 0; i < m_choices.size(); ++i) {
        if (m_choices[i]->isChecked() && isPossible(Choices[i])) {
            config.which.push_back(Choices[i]);
        }
    }
    config.seed = seedOf(bench().session().info());
    return config;
}

void CalibratePanel::refreshPlan() {
    for (std::size_t i = 0; i < m_choices.size(); ++i) {
        m_choices[i]->setVisible(isPossible(Choices[i]));
    }
    constexpr double Usual_degC = 25.0;
    m_outlook->setText(isMovedByHand() ? handMotionOutlook(config())
                       : hasSeveralAxes() && !config().which.empty()
                           ? axesCalibrationOutlook(actuator().calibrate.predict(config(), Usual_degC))
                           : calibrationOutlook(config(), bench().displayUnits()));
    m_start->setEnabled(!config().which.empty() && m_preflight->isPassed());
    const DeviceSession& session = bench().session();
    // Armed by hand, the angle that holds the rotor would jump with its calibration.
    const bool isFree = session.state() == SessionState::Connected && session.procedure().isEmpty() &&
                        !session.report().board.isArmed;
    const bool isUsable =
        m_result && !m_result->proposed.empty() && m_result->quality.verdict != Verdict::Refused;
    m_apply->setEnabled(isFree && isUsable && !m_result->isApplied && isOfThisDevice());
    m_restore->setEnabled(isFree && isUsable && m_result->isApplied);
    // Applied or not: the loop is judged by how far the coefficient in use is from the interval's far end.
    const bool isKnown = isUsable && session.state() == SessionState::Connected && isOfThisDevice();
    bench().setStrayInterval95_T_per_A(isKnown ? strayInterval(*m_result) : std::nullopt,
                                       isKnown ? calibrationDoubts(*m_result) : std::vector<Finding>());
}

void CalibratePanel::onDevice() {
    const bool isConnected = bench().session().state() == SessionState::Connected;
    m_connection += isConnected ? 1 : 0;
    if (isConnected) {
        refreshWords();
    }
    if (m_result && isConnected) {
        m_result->isApplied = false; // the board starts with the values that it keeps
        endStep(ApplyStep, widgets::StepState::Waiting);
        if (m_origin == Origin::ThisConnection) {
            m_origin = Origin::EarlierConnection;
        }
    }
    if (m_result && m_origin != Origin::ThisConnection && !isDepartureTold()) {
        sayOrigin();
    }
    showRows();
    refreshPlan();
}

bool CalibratePanel::isMovedByHand() const {
    return m_guide->isFor(bench().session().info().model);
}

void CalibratePanel::start() {
    m_live = std::make_shared<LiveHall>();
    m_guide->begin();
    const bool hasStarted = runProcedure(
        tr("Calibrate"),
        [config = config(), live = m_live, motion = m_guide->motion(),
         run = actuator().calibrate.run](devices::Device& device, const ProcedureObserver& session) {
            const ProcedureObserver observer = listeningIn(session, [live, motion](const SampleBlock& block) {
                live->take(block);
                if (motion) {
                    motion->take(block);
                }
            });
            return run(device, config, observer);
        },
        [this, connection = m_connection, header = headerOf("halbench.calibration/1", config().seed)](
            const Result<CalibrateResult>& result) { finish(result, header, connection); });
    if (!hasStarted) {
        return;
    }
    m_progress->setText(tr("Calibrating"));
    m_progress->setProgress(0.0);
    constexpr double Usual_degC = 25.0;
    // A device with several axes tells its own progress.
    m_predicted_s = hasSeveralAxes() ? 0.0 : actuator().calibrate.predict(config(), Usual_degC).duration_s;
    m_liveView->setVisible(!isMovedByHand() && !hasSeveralAxes());
    m_guide->setVisible(isMovedByHand());
    m_largest_T = ExpectedField_T;
    m_isCancelling = false;
    m_liveView->setFigure(liveHallFigure({}, m_largest_T));
    runStep(PrepareStep);
    showPage(RunPage);
    m_progress->setFocus(Qt::OtherFocusReason);
    m_sinceStart.start();
    m_frame.start();
}

void CalibratePanel::showLive() {
    const auto points = m_live->points();
    for (const LiveHall::Point& point : points) {
        const double field_T = std::max(std::abs(point.hall_a_T), std::abs(point.hall_b_T));
        m_largest_T = field_T > m_largest_T ? Room_ratio * field_T : m_largest_T;
    }
    m_liveView->setFigure(liveHallFigure(points, m_largest_T));
    m_guide->refresh();
    if (!m_isCancelling && m_predicted_s > 0.0) {
        // The plan is that of the published motor; another one may take longer.
        const double done = std::min(0.99, m_live->elapsed_s() / m_predicted_s);
        const double wall_s = 1e-3 * static_cast<double>(m_sinceStart.elapsed());
        m_progress->setProgress(done,
                                done > 0.005 ? std::optional(wall_s * (1.0 - done) / done) : std::nullopt);
    }
}

void CalibratePanel::onStage(ProcedureState stage) {
    const bool isMoving =
        stage == ProcedureState::Excite || (isMovedByHand() && stage == ProcedureState::Record);
    if (isMine() && isMoving) {
        runStep(ExciteStep);
    } else if (isMine() && stage == ProcedureState::Propose) {
        runStep(ProposeStep);
    }
}

void CalibratePanel::finish(const Result<CalibrateResult>& result, const ResultHeader& header,
                            std::uint64_t connection) {
    m_frame.stop();
    if (!result) {
        fail(result.error(), tr("Calibration cancelled. Nothing was changed."));
        refreshPlan();
        m_start->setFocus(Qt::OtherFocusReason);
        return;
    }
    m_result = *result;
    m_origin = connection == m_connection ? Origin::ThisConnection : Origin::EarlierConnection;
    bench().session().message(MessageLevel::Info, tr("Calibrate"), verdictTitle(result->quality));
    m_header = header;
    showResult();
    runStep(ApplyStep);
    endStep(ApplyStep, widgets::StepState::Waiting);
    showPage(ResultPage);
    (m_apply->isEnabled() ? m_apply : m_again)->setFocus(Qt::OtherFocusReason);
    if (m_origin == Origin::EarlierConnection) {
        sayOrigin(); // its device went while the result was on its way
    }
    calibrated();
}

} // namespace halbench::app
