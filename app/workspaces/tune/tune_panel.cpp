#include "app/workspaces/tune/tune_panel.h"

#include "app/workbench/document_files.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/parts/foreign_motor_notice.h"
#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/parts/preflight.h"
#include "app/workspaces/tune/apply_controls.h"
#include "app/workspaces/tune/design_comparison.h"
#include "app/workspaces/tune/design_verdict.h"
#include "app/workspaces/tune/gain_decision.h"
#include "app/workspaces/tune/gain_files.h"
#include "app/workspaces/tune/gain_settings.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/loop_shaping.h"
#include "app/workspaces/tune/measured_overlay.h"
#include "app/workspaces/tune/prediction_pages.h"
#include "app/workspaces/tune/settings_splitter.h"
#include "app/workspaces/tune/tune_numbers.h"
#include "app/workspaces/tune/tune_pages.h"
#include "app/workspaces/tune/tune_session.h"
#include "app/workspaces/tune/verification_page.h"
#include "app/workspaces/tune/what_if_page.h"
#include "app/workspaces/tune/what_if_recording.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/unbroken.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <utility>

namespace halbench::app {

TunePanel::TunePanel(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_pages(new TunePages(bench, this)),
      m_message(new widgets::MessageBar(this)), m_messages(*m_message),
      m_session(new TuneSession(bench, this)) {
    QVBoxLayout* column = makePanelColumn(this);
    column->addWidget(m_pages, 1);
    createParts();
    QWidget* settings = buildSettings();
    settings->setMinimumWidth(45 * fontMetrics().averageCharWidth());
    m_pages->setLoopPage(new SettingsSplitter(settings, m_predictions, m_pages));
    (new widgets::FloatingRows(*m_pages, Qt::BottomEdge, this))->addRow(*m_message); // tabs are at the top
    connectSession();
    connectGains();
    connectDecision();
    connectPages();
    connectBench();
    readConditions();
    onUnits();
}

/// Each part needs only those before it.
void TunePanel::createParts() {
    m_predictions = new PredictionPages(m_bench, *m_session);
    m_verification = new VerificationPage(m_bench, *m_session, m_predictions);
    m_whatIf = new WhatIfPage(m_bench, m_predictions);
    m_predictions->addPages({m_verification, m_whatIf});
    m_predictions->setPageEnabled(m_verification, false);
    m_designs = new DesignComparison(m_bench, *m_session, m_predictions->designs(), this);
    m_decision = new GainDecision(m_bench, *m_session, *m_designs, m_messages, this);
    m_recording = new WhatIfRecording(m_bench, *m_session, m_messages, *m_whatIf, this);
}

QWidget* TunePanel::buildSettings() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, widgets::PanelMargin_px, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    m_model = new QLabel(page);
    m_model->setWordWrap(true);
    m_gains = new GainSettings(m_bench, *m_session, m_messages, page);
    m_shaping = new LoopShaping(m_bench, *m_session, *m_gains, m_predictions->loop(), this);
    m_verdict = new widgets::VerdictView(page);
    m_verdict->setObjectName(QStringLiteral("design"));
    auto* preflight = new Preflight(m_bench, page);
    auto* foreign = new ForeignMotorNotice(m_bench, page);
    column->addWidget(m_model);
    column->addWidget(m_gains);
    m_verdict->moveRemarks(*column); // its title stays in sight
    column->addWidget(preflight);
    column->addWidget(foreign);
    column->addStretch(1);
    m_controls = new ApplyControls(m_bench, *m_session, *m_decision, *preflight, *foreign);
    m_gainFiles = new GainFiles(m_bench, *m_session, m_controls);
    m_controls->addTool(*m_gainFiles);
    auto* settings = new QWidget;
    auto* all = new QVBoxLayout(settings);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(widgets::PanelMargin_px);
    all->addWidget(makeScrollArea(page), 1);
    all->addWidget(m_verdict);
    all->addWidget(m_controls); // what is decided stays in sight, however far the rest is scrolled
    return settings;
}

void TunePanel::connectSession() {
    connect(m_session, &TuneSession::sketched, this, &TunePanel::showSketch);
    connect(m_session, &TuneSession::judged, this, &TunePanel::showAnswer);
    connect(m_session, &TuneSession::refused, this, &TunePanel::showProblem);
    connect(m_session, &TuneSession::refreshed, this, &TunePanel::drawPredictions);
}

void TunePanel::connectGains() {
    addActions(historyActions());
    connect(m_gains, &GainSettings::changed, this, &TunePanel::ask);
    connect(m_gains, &GainSettings::recorded, this, [this] {
        if (!m_decision->isUndecided()) { // else its message tells of the decision
            m_messages.clearOfDevice();
        }
    });
    connect(m_shaping, &LoopShaping::moved, this, &TunePanel::ask);
    connect(m_shaping, &LoopShaping::released, this, &TunePanel::onReleased);
    connect(m_designs, &DesignComparison::shown, this, &TunePanel::drawPredictions);
    connect(m_designs, &DesignComparison::takenUp, this,
            [this](const LoopLaw& law, const QString& name) { m_gains->take(law, tr("Use %1").arg(name)); });
    connect(m_gainFiles, &GainFiles::opened, this, [this](const LoopLaw& law, const QString& fileName) {
        m_gains->take(law, tr("Open %1").arg(fileName));
    });
    const auto showMessage = [this](const widgets::Message& message) { m_messages.show(message); };
    const auto showError = [this](const Error& error) { m_messages.showError(error); };
    connect(m_gainFiles, &GainFiles::told, this, showMessage);
    connect(m_gainFiles, &GainFiles::failed, this, showError);
    connect(m_designs, &DesignComparison::failed, this, showError);
    connect(&m_predictions->measured(), &MeasuredOverlay::used, this, showMessage);
    connect(&m_predictions->measured(), &MeasuredOverlay::failed, this, showError);
}

void TunePanel::connectDecision() {
    connect(m_decision, &GainDecision::started, this, [this](const LoopLaw& law) {
        m_messages.clear();
        m_messages.clearOfDevice();
        m_verification->expect(law);
    });
    connect(m_decision, &GainDecision::verified, m_verification, &VerificationPage::showMove);
    connect(m_decision, &GainDecision::restored, m_verification, &VerificationPage::setUndone);
    connect(m_decision, &GainDecision::changed, this, &TunePanel::refresh);
    connect(m_decision, &GainDecision::settled, this, &TunePanel::focusNext);
    connect(m_decision, &GainDecision::looked, this, [this] {
        if (m_predictions->isAncestorOf(focusWidget())) { // else it went elsewhere meanwhile
            focusNext();
        }
    });
    // The gains on the device are those to compare with from now on.
    connect(m_decision, &GainDecision::kept, this, &TunePanel::readConditions);
    connect(m_decision, &GainDecision::left, this, &TunePanel::gainsLeft);
}

void TunePanel::connectPages() {
    connect(m_pages, &TunePages::identifyRequested, this, &TunePanel::identifyRequested);
    connect(&m_predictions->loop(), &LoopView::loopsWanted, this, &TunePanel::drawPredictions);
    connect(&m_predictions->measured(), &MeasuredOverlay::changed, this, &TunePanel::drawPredictions);
    connect(m_verification, &VerificationPage::recordReady, this, &TunePanel::ask);
    connect(m_verification, &VerificationPage::shown, this, [this] {
        m_predictions->setPageEnabled(m_verification, true);
        m_predictions->setCurrent(m_verification);
    });
    connect(m_verification, &VerificationPage::forgotten, this, [this] {
        if (!m_verification->isHidden()) { // else another picture is chosen
            m_predictions->setCurrent(&m_predictions->loop());
        }
        m_predictions->setPageEnabled(m_verification, false);
    });
    connect(m_message, &widgets::MessageBar::actionTriggered, this, &TunePanel::onMessageAction);
    connect(m_recording, &WhatIfRecording::used, this, [this] {
        proposeToWhatIf();
        m_predictions->setCurrent(m_whatIf);
    });
    std::vector<widgets::FigureView*> pictures = m_predictions->pictures();
    pictures.insert(pictures.end(), {&m_verification->picture(), &m_whatIf->picture()});
    for (widgets::FigureView* view : pictures) {
        connect(view, &widgets::FigureView::exportRequested, this, [this, view] {
            savePicture(this, m_chooser, QStringLiteral("tuning.svg"), m_files, *view,
                        [this](const Error& error) { m_messages.showError(error); });
        });
    }
}

void TunePanel::connectBench() {
    connect(&m_bench, &Workbench::identificationChanged, this, [this] {
        forgetVerification(); // it was predicted for the motor as it was
        refreshModel();
        m_gains->restartHistory();
    });
    connect(&m_bench, &Workbench::valuesChanged, this, &TunePanel::readConditions);
    connect(&m_bench, &Workbench::strayIntervalChanged, this, &TunePanel::ask);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &TunePanel::onUnits);
    connect(&m_bench, &Workbench::deviceChanged, this, &TunePanel::onDevice);
    connect(&m_bench, &Workbench::valuesCompared, this, [this] {
        if (!m_bench.differences().empty()) {
            forgetVerification(); // it came back with other values: nothing is known of how it moves
        }
    });
}

void TunePanel::setFileChooser(FileChooser chooser) {
    m_chooser = std::move(chooser);
    m_gainFiles->setFileChooser(m_chooser);
    m_predictions->measured().setFileChooser(m_chooser);
    m_recording->setFileChooser(m_chooser);
    m_pages->setFileChooser(m_chooser);
}

bool TunePanel::isComputing() const {
    return m_session->isComputing();
}

void TunePanel::restoreDesign(std::optional<GainsFile> gains) {
    m_shaping->drop();
    forgetVerification(); // of the project before
    m_predictions->measured().forget();
    m_whatIf->forget();
    m_gains->restore(std::move(gains));
    ask();
}

void TunePanel::setSavedDesigns(std::vector<KeptDesign> designs) {
    m_designs->restore(std::move(designs));
}

void TunePanel::adoptDesign(const std::string& name, std::string document) {
    m_designs->adopt(name, std::move(document));
}

const std::vector<KeptDesign>& TunePanel::savedDesigns() const {
    return m_designs->all();
}

void TunePanel::takeUpDesign(const std::string& name) {
    m_designs->takeUp(name);
}

void TunePanel::useMeasured(const MeasuredPlant& plant) {
    m_predictions->measured().use(plant);
}

void TunePanel::useRecording(const QString& path) {
    m_recording->use(path);
}

void TunePanel::useUltimate(double gain_A_per_rad, double period_s) {
    control::DesignTargets targets;
    targets.ultimateGain_A_per_rad = gain_A_per_rad;
    targets.ultimatePeriod_s = period_s;
    m_gains->choose("ziegler-nichols", targets);
}

void TunePanel::useAxisModel(const AxisModelFile& model) {
    m_pages->useAxisModel(model);
}

void TunePanel::useMeasuredAxes(const AxesFrequencyResult& response) {
    m_pages->useMeasuredAxes(response);
}

void TunePanel::onSavedInDevice() {
    m_decision->onSavedInDevice();
}

QList<QAction*> TunePanel::historyActions() const {
    return {&m_gains->history().undo(), &m_gains->history().redo()};
}

/// What was applied, measured and said is of one device: of the one that is connected, looked for, or held
/// while a recording is open.
void TunePanel::onDevice() {
    if (m_decision->leaveDevice()) {
        m_pages->forgetMeasuredAxes();
        forgetVerification();
    }
    m_pages->refreshTexts();
    m_pages->showPage();
    m_gains->refreshDevice();
    m_controls->refreshOutlook(); // of its limits
    readConditions();
    ask(); // its presets may be others
}

/// Asks anew only when the surroundings or the gains on the device changed: many values are read often.
void TunePanel::readConditions() {
    if (m_decision->isApplying()) {
        return; // what is written now is decided when it is verified
    }
    m_gains->refreshModel();
    if (m_session->readConditions(m_decision->valuesBefore()) || m_gains->isOfDevice()) {
        ask();
    }
}

void TunePanel::refreshModel() {
    m_pages->showPage();
    if (m_bench.provenance().origin != ResultOrigin::Project) {
        m_gains->forgetRestored(); // they were for another motor
    }
    m_session->forgetProposed(); // it was for the motor before
    m_shaping->drop();
    m_designs->judgeAnew();
    if (!m_bench.identification()) {
        m_session->forget();
        m_shaping->showLoop();
        refresh();
        return;
    }
    m_model->setText(motorText());
    readConditions(); // without a device they are those of the model
    ask();
}

QString TunePanel::motorText() const {
    const auto words = [&](const char* ratio, const QString& symbol) {
        const auto& ratios = m_bench.identification()->ratios;
        const auto found = ratios.find(ratio);
        if (found == ratios.end() || !found->second.value) {
            return QString();
        }
        const auto& interval = found->second.interval95;
        const auto half = interval ? std::optional(0.5 * (interval->second - interval->first)) : std::nullopt;
        const widgets::EstimateText text = widgets::estimateText(*found->second.value, half);
        return widgets::unbroken(QStringLiteral("%1 = %2 \u00b1 %3").arg(symbol, text.value, text.half));
    };
    QStringList parts = {words("c_over_J", "c/J"), words("phi_over_J", "\u03c6/J"),
                         words("Kf_over_phi", "K_f/\u03c6")};
    parts.removeAll({});
    return tr("Motor (SI, 95 %): %1").arg(parts.join(QStringLiteral(", ")));
}

void TunePanel::ask() {
    if (m_bench.identification()) {
        m_verification->cancelReplay();
        m_session->ask(m_gains->source(), m_verification->record());
        refresh();
    }
}

void TunePanel::showSketch() {
    m_gains->showLaw(m_session->sketch()->loopLaw());
    drawPredictions();
    m_verification->drawIfVisible(); // what if its move had been made with these gains
    proposeToWhatIf();
    m_shaping->showLoop();
    m_shaping->takeWaiting();
}

void TunePanel::showAnswer() {
    const TuneResult& proposed = *m_session->proposed();
    m_predictions->showNumbers();
    m_predictions->drawDisturbance();
    const DeviceSession& session = m_bench.session();
    showDesignVerdict(*m_verdict, proposed,
                      session.state() == SessionState::Connected
                          ? foreignMotor(m_bench.provenance().header.device, session.info())
                          : std::nullopt);
    if (m_gains->restored()) {
        m_bench.setDesignOfProject(proposed, m_gains->restored()->started);
    } else {
        m_bench.setDesign(proposed);
    }
    m_designs->show();
    refresh();
    m_verification->replay();
}

void TunePanel::showProblem() {
    m_verification->drawIfVisible();
    proposeToWhatIf();
    showDesignProblem(*m_verdict, *m_session->problem());
    m_designs->show(); // what was proposed before is not proposed any more
    refresh();
}

void TunePanel::onReleased() {
    if (!m_session->isSketching()) {
        drawPredictions(); // the axes may find their extent again
        m_shaping->showLoop();
    }
    m_session->completeMove();
    proposeToWhatIf();           // with its band
    if (m_session->proposed()) { // else it follows the answer
        m_verification->replay();
    }
}

void TunePanel::drawPredictions() {
    m_predictions->draw(m_designs->drawnLoops());
}

void TunePanel::proposeToWhatIf() {
    m_whatIf->propose(m_session->drawnLaw(), m_session->isMoving());
}

/// Neither verdict and picture nor what was said of a move holds any longer.
void TunePanel::forgetVerification() {
    m_verification->forget();
    m_messages.clearOfDevice();
}

/// The one of the message that is shown: of gains that were kept, else of a recording.
void TunePanel::onMessageAction() {
    if (!m_messages.isOfDevice()) {
        m_recording->chooseGains();
    } else if (m_bench.session().info().isSimulated) {
        Q_EMIT drivingRequested();
    } else {
        Q_EMIT savingRequested();
    }
}

/// To decide is next; after that to choose other gains. Apply goes off while its prediction is asked anew.
void TunePanel::focusNext() {
    if (m_decision->isLooking()) {
        m_predictions->focusCurrent();
    } else if (m_decision->isUndecided()) {
        m_controls->focusKeep();
    } else {
        m_gains->focusSource();
    }
}

void TunePanel::refresh() {
    m_controls->refresh();
    m_gainFiles->setCanSave(m_session->proposed().has_value());
    m_predictions->numbers().setUndecided(m_decision->isUndecided());
}

void TunePanel::refreshTexts() {
    m_pages->refreshTexts();
    m_controls->refreshTexts();
    m_predictions->refreshTexts();
    m_predictions->setTitle(m_verification, tr("Verification"),
                            tr("Measured move and prediction, after Apply and verify"));
    m_predictions->setTitle(m_whatIf, tr("What-if"), tr("Replay of a recorded move with the proposed gains"));
    m_verification->draw();
    refreshModel();
}

void TunePanel::onUnits() {
    m_gains->refreshUnits();
    m_predictions->loop().setFrequencyUnit(m_bench.displayUnits().frequency);
    refreshTexts(); // and every picture with them
}

void TunePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshTexts();
    }
}

} // namespace halbench::app
