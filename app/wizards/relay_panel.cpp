#include "app/wizards/relay_panel.h"

#include "app/batch/relay_document.h"
#include "app/procedures/coil_forecast.h"
#include "app/procedures/frequency_board.h"
#include "app/procedures/relay_plan.h"
#include "app/report/frequency_figures.h"
#include "app/wizards/frequency_words.h"
#include "app/wizards/identify_words.h"
#include "app/wizards/relay_form.h"
#include "app/wizards/relay_words.h"
#include "app/wizards/words_and_pictures.h"
#include "app/workspaces/preflight.h"
#include "widgets/estimate_table.h"
#include "widgets/figure_view.h"
#include "widgets/icons.h"
#include "widgets/message_bar.h"
#include "widgets/phrasebook.h"
#include "widgets/progress_row.h"
#include "widgets/step_list.h"
#include "widgets/theme_style.h"
#include "widgets/verdict_view.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {
namespace {

constexpr double AssumedStart_degC = 25.0;

/// Warmest coil when the plan is run from that temperature.
double warmest_degC(const devices::Catalogue& catalogue, const RelayPlan& plan, double start_degC) {
    return forecastCoil_degC(coilModel(catalogue), {start_degC, start_degC}, plan.meanSquare_A2,
                             plan.duration_s());
}

} // namespace

RelayPanel::RelayPanel(Workbench& workbench, QWidget* parent)
    : WizardPanel(workbench, parent), m_plan(failure(ErrorCode::InvalidInput, "", "")) {
    addPage(buildPrepare(), true, buildStartRow());
    addPage(buildRun(), false, m_progress);
    addPage(buildResult(), false, buildResultButtons());
    connect(&bench(), &Workbench::deviceChanged, this, &RelayPanel::onDevice);
    connect(&bench(), &Workbench::valuesChanged, this, &RelayPanel::refreshPlan);
    connect(&bench(), &Workbench::identificationChanged, this, &RelayPanel::refreshPlan);
    connect(&bench().session(), &DeviceSession::procedureStage, this, &RelayPanel::onStage);
    connect(&bench().session(), &DeviceSession::procedureProgress, this, &RelayPanel::onProgress);
    RelayPanel::refreshWords();
    onDevice();
}

void RelayPanel::onFileChooser() {
    m_save->setVisible(bool(chooser().save));
}

QWidget* RelayPanel::buildPrepare() {
    m_intro = new QLabel;
    m_outlook = new QLabel;
    m_form = new RelayForm;
    m_preflight = new Preflight(bench());
    connect(m_form, &RelayForm::changed, this, &RelayPanel::refreshPlan);
    connect(m_preflight, &Preflight::changed, this, &RelayPanel::refreshPlan);
    return makePreparation(*m_intro, *m_form, *m_outlook, *m_preflight);
}

QWidget* RelayPanel::buildStartRow() {
    m_start = new QPushButton(this);
    connect(m_start, &QPushButton::clicked, this, &RelayPanel::start);
    return makeStartRow(*m_start);
}

QWidget* RelayPanel::buildRun() {
    auto* page = new QWidget;
    auto* column = columnOf(page, widgets::PanelMargin_px);
    m_progress = new widgets::ProgressRow(page);
    m_running = new QLabel(page);
    m_running->setWordWrap(true);
    column->addWidget(m_running);
    column->addStretch(1);
    connect(m_progress, &widgets::ProgressRow::cancelRequested, this, [this] {
        m_isCancelling = true;
        bench().session().abortProcedure();
    });
    return page;
}

QWidget* RelayPanel::buildResult() {
    QWidget* words = buildResultWords();
    m_record = new widgets::FigureView;
    m_both = new WordsAndPictures(words, m_table, m_record);
    return m_both;
}

QWidget* RelayPanel::buildResultWords() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, widgets::PanelMargin_px, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    m_verdict = new widgets::VerdictView(page);
    m_table = new widgets::EstimateTable(page);
    m_swing = new QLabel(page);
    m_provenance = new QLabel(page);
    for (QLabel* label : {m_swing, m_provenance}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    widgets::setRole(*m_provenance, widgets::Role::Muted);
    for (QWidget* part : std::initializer_list<QWidget*>{m_verdict, m_table, m_swing, m_provenance}) {
        column->addWidget(part);
    }
    column->addStretch(1);
    return page;
}

QWidget* RelayPanel::buildResultButtons() {
    m_use = new QPushButton(this);
    m_save = new QPushButton(this);
    m_again = new QPushButton(this);
    widgets::setRole(*m_use, widgets::Role::Primary);
    m_save->setIcon(widgets::themedIcon(QStringLiteral("save")));
    m_save->hide();
    connect(m_use, &QPushButton::clicked, this, [this] {
        if (m_found && m_found->ultimate) {
            Q_EMIT useRequested(*ultimateGainOf(*m_found).value, *ultimatePeriodOf(*m_found).value);
        }
    });
    connect(m_save, &QPushButton::clicked, this, [this] {
        if (m_found) {
            save({tr("Save result"), QStringLiteral("relay.json"), tr("Relay experiment (*.json)")},
                 [header = m_header, result = *m_found] { return relayDocument(header, result); });
        }
    });
    connect(m_again, &QPushButton::clicked, this, [this] { beginAgain(PreparePage, *m_start); });
    return makeButtonRow({m_use, m_save, m_again});
}

void RelayPanel::refreshWords() {
    setSteps({tr("Prepare"), tr("Swing"), tr("Fit"), tr("Result")});
    m_intro->setText(
        tr("Lets the loop swing by itself around a steady motion, with proportional control that "
           "saturates, and finds the gain at which it would swing for ever, with its 95 % interval. "
           "Calibrate the sensors first."));
    m_running->setText(
        tr("The rotor turns steadily and swings around that. STOP (Esc) and Cancel end it; gains, "
           "limits, mode, windows and generator are restored."));
    sayButton(*m_start, tr("Start experiment"), tr("The rotor turns and swings (Ctrl+Return); Esc stops it"));
    sayButton(*m_use, tr("Use in Tune"),
              tr("Propose gains by Ziegler and Nichols from it, with their proof; nothing is applied"));
    sayButton(*m_save, tr("Save result\u2026"), tr("Write the file that tune --relay reads"));
    sayButton(*m_again, tr("Measure again"),
              tr("Back to the settings; this result stays until the next one"));
    m_record->setAccessibleName(tr("The swing as recorded"));
    m_both->setWordsName(tr("Ultimate gain and period"));
    m_table->setAccessibleName(tr("Ultimate gain and period"));
    showResult();
    refreshPlan();
}

void RelayPanel::onDevice() {
    if (!isDepartureTold() && bench().session().state() == SessionState::Connected) {
        messages().clear();
    }
    refreshPlan();
}

/// The plan of what is set now, made anew only when something of it has changed.
void RelayPanel::replan() {
    const DeviceSession& session = bench().session();
    const bool isConnected = session.state() == SessionState::Connected;
    const devices::Catalogue catalogue = isConnected ? session.catalogue() : devices::Catalogue{};
    Result<RelayConfig> config = m_form->config();
    if (!config) {
        m_config.reset();
        m_asked.clear();
        m_plan = failure(config.error());
        return;
    }
    FrequencyConfig anyExcitation;
    anyExcitation.excitation = Excitation::SteppedSine;
    const auto able = isConnected ? checkFrequencyBoard(catalogue, anyExcitation) : Result<void>();
    if (bench().identification()) {
        config->motor = motorEstimate(*bench().identification());
    }
    const FrequencyMargins loop = frequencyOutlookMargins(catalogue, bench().deviceValues());
    std::vector<double> asked = {config->base_rad_s.value_or(0.0),
                                 config->limit_A.value_or(0.0),
                                 static_cast<double>(config->cycles),
                                 loop.period_s,
                                 loop.law.limit_A,
                                 static_cast<double>(loop.law.delaySamples)};
    for (const auto& [name, value] :
         config->motor ? config->motor->values : std::map<std::string, double>{}) {
        asked.push_back(value);
    }
    m_config = *config;
    if (able && asked == m_asked) {
        return;
    }
    m_asked = able ? std::move(asked) : std::vector<double>();
    m_plan = able ? planRelay(*config, {loop.period_s, loop.law.delaySamples, loop.law.limit_A})
                  : Result<RelayPlan>(failure(able.error()));
}

void RelayPanel::refreshPlan() {
    replan();
    if (!m_plan || !m_config) {
        m_outlook->setText(widgets::inWords(m_plan.error().message) + QStringLiteral(" \u2192 ") +
                           widgets::inWords(m_plan.error().hint));
        widgets::setRole(*m_outlook, widgets::Role::Bad);
        m_start->setEnabled(false);
        return;
    }
    const DeviceSession& session = bench().session();
    const devices::Catalogue catalogue =
        session.state() == SessionState::Connected ? session.catalogue() : devices::Catalogue{};
    widgets::setRole(*m_outlook, widgets::Role::None);
    const double start_degC = m_preflight->temperature_degC().value_or(AssumedStart_degC);
    m_outlook->setText(relayOutlook(*m_config, *m_plan, warmest_degC(catalogue, *m_plan, start_degC)));
    m_preflight->setForecast(
        [catalogue, plan = *m_plan](double now_degC) { return warmest_degC(catalogue, plan, now_degC); });
    m_start->setEnabled(m_preflight->isPassed());
}

void RelayPanel::start() {
    if (!m_config || !m_plan || !m_start->isEnabled() || !m_preflight->isPassed()) {
        return;
    }
    const bool hasStarted = runProcedure(
        tr("Relay experiment"),
        [config = *m_config](devices::Device& device, const ProcedureObserver& observer) {
            return runRelay(device, config, observer);
        },
        [this, header = headerOf("halbench.relay/1", seedOf(bench().session().info()))](
            const Result<RelayResult>& result) { finish(header, result); });
    if (!hasStarted) {
        return;
    }
    m_isCancelling = false;
    m_progress->setText(tr("Measuring"));
    m_progress->setProgress(0.0);
    runStep(PrepareStep);
    showPage(RunPage);
    m_progress->setFocus(Qt::OtherFocusReason);
    m_sinceStart.start();
}

void RelayPanel::onStage(ProcedureState stage) {
    if (!isMine()) {
        return;
    }
    if (stage == ProcedureState::Excite || stage == ProcedureState::Record) {
        runStep(SwingStep);
    } else if (stage == ProcedureState::Fit || stage == ProcedureState::Judge) {
        runStep(FitStep);
        m_progress->setText(tr("Computing the result"));
    }
}

void RelayPanel::onProgress(double fraction, const QString& text) {
    if (!isMine() || m_isCancelling) {
        return;
    }
    const double done = std::clamp(fraction, 0.0, 0.99);
    const double wall_s = 1e-3 * static_cast<double>(m_sinceStart.elapsed());
    m_progress->setText(widgets::inWords(text));
    m_progress->setProgress(done, done > 0.02 ? std::optional(wall_s * (1.0 - done) / done) : std::nullopt);
}

void RelayPanel::finish(const ResultHeader& header, const Result<RelayResult>& result) {
    if (!result) {
        fail(result.error(), tr("The experiment was cancelled; everything is as it was before."));
        refreshPlan();
        m_start->setFocus(Qt::OtherFocusReason);
        return;
    }
    bench().session().message(MessageLevel::Info, tr("Relay experiment"), verdictTitle(result->quality));
    m_found = *result;
    m_header = header;
    showResult();
    m_both->shareAnew();
    const bool isUsable = result->ultimate.has_value();
    m_use->setEnabled(isUsable);
    runStep(ResultStep);
    endStep(ResultStep, isUsable ? widgets::StepState::Done : widgets::StepState::Failed);
    showPage(ResultPage);
    (isUsable ? m_use : m_again)->setFocus(Qt::OtherFocusReason);
}

void RelayPanel::showResult() {
    if (!m_found) {
        return;
    }
    m_verdict->setVerdict(verdictLevel(m_found->quality.verdict), verdictTitle(m_found->quality),
                          remarksOf(m_found->quality.findings));
    m_table->setRows(relayRows(*m_found));
    m_swing->setText(relayUse(*m_found));
    m_provenance->setText(provenanceText(m_header, m_found->duration_s, m_found->highestTemperature_degC));
    m_record->setFigure(excitationFigure(m_found->recording).value_or(widgets::Figure{}));
}

} // namespace halbench::app
