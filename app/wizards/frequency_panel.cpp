#include "app/wizards/frequency_panel.h"

#include "app/batch/frequency_table.h"
#include "app/batch/loop_conditions.h"
#include "app/batch/result_documents.h"
#include "app/procedures/coil_forecast.h"
#include "app/procedures/frequency_board.h"
#include "app/wizards/frequency_form.h"
#include "app/wizards/frequency_result_view.h"
#include "app/wizards/frequency_words.h"
#include "app/wizards/identify_words.h"
#include "app/workspaces/document_files.h"
#include "app/workspaces/preflight.h"
#include "widgets/icons.h"
#include "widgets/message_bar.h"
#include "widgets/phrasebook.h"
#include "widgets/progress_row.h"
#include "widgets/step_list.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {
namespace {

constexpr double AssumedStart_degC = 25.0;

/// Warmest coil when the plan is run from that temperature.
double warmest_degC(const devices::Catalogue& catalogue, const FrequencyPlan& plan, double start_degC) {
    return forecastCoil_degC(coilModel(catalogue), {start_degC, start_degC}, plan.meanSquare_A2,
                             plan.duration_s());
}

} // namespace

FrequencyPanel::FrequencyPanel(Workbench& workbench, QWidget* parent) : WizardPanel(workbench, parent) {
    addPage(buildPrepare(), true, buildStartRow());
    addPage(buildRun(), false, m_progress);
    addPage(buildResult(), false, buildResultButtons());
    m_result->setFileChooser(&chooser());
    connect(&bench(), &Workbench::deviceChanged, this, &FrequencyPanel::onDevice);
    connect(&bench(), &Workbench::valuesChanged, this, &FrequencyPanel::refreshPlan);
    connect(&bench().session(), &DeviceSession::procedureStage, this, &FrequencyPanel::onStage);
    connect(&bench().session(), &DeviceSession::procedureProgress, this, &FrequencyPanel::onProgress);
    FrequencyPanel::refreshWords();
    onDevice();
}

void FrequencyPanel::onFileChooser() {
    m_save->setVisible(bool(chooser().save));
    m_table->setVisible(bool(chooser().save));
}

QWidget* FrequencyPanel::buildPrepare() {
    m_intro = new QLabel;
    m_outlook = new QLabel;
    m_form = new FrequencyForm;
    m_preflight = new Preflight(bench());
    connect(m_form, &FrequencyForm::changed, this, &FrequencyPanel::refreshPlan);
    connect(m_preflight, &Preflight::changed, this, &FrequencyPanel::refreshPlan);
    return makePreparation(*m_intro, *m_form, *m_outlook, *m_preflight);
}

QWidget* FrequencyPanel::buildStartRow() {
    m_start = new QPushButton(this);
    connect(m_start, &QPushButton::clicked, this, &FrequencyPanel::start);
    return makeStartRow(*m_start);
}

QWidget* FrequencyPanel::buildRun() {
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

QWidget* FrequencyPanel::buildResult() {
    m_result = new FrequencyResultView;
    connect(m_result, &FrequencyResultView::notSaved, this,
            [this](const QString& text, const QString& remedy) {
                messages().showMessage({widgets::Severity::Error, text, remedy, {}});
            });
    return m_result;
}

QWidget* FrequencyPanel::buildResultButtons() {
    m_use = new QPushButton(this);
    m_save = new QPushButton(this);
    m_table = new QPushButton(this);
    m_again = new QPushButton(this);
    widgets::setRole(*m_use, widgets::Role::Primary);
    for (QPushButton* button : {m_save, m_table}) {
        button->setIcon(widgets::themedIcon(QStringLiteral("save")));
        button->hide();
    }
    connect(m_use, &QPushButton::clicked, this, [this] { Q_EMIT useRequested(m_found); });
    connect(m_save, &QPushButton::clicked, this, [this] {
        save({tr("Save response"), QStringLiteral("response.json"), tr("Response (*.json)")},
             [header = m_header, result = m_found] { return frequencyDocument(header, result); });
    });
    connect(m_table, &QPushButton::clicked, this, &FrequencyPanel::saveTable);
    connect(m_again, &QPushButton::clicked, this, [this] { beginAgain(PreparePage, *m_start); });
    return makeButtonRow({m_use, m_save, m_table, m_again});
}

void FrequencyPanel::refreshWords() {
    setSteps({tr("Prepare"), tr("Excite"), tr("Fit"), tr("Result")});
    m_intro->setText(
        tr("Measures the loop with the gains on the board, frequency by frequency: open loop, plant and "
           "margins with their 95 % intervals, on top of a steady motion that never turns back."));
    m_running->setText(
        tr("The rotor turns steadily and is excited. STOP (Esc) and Cancel end it; mode, windows and "
           "generator are restored, the gains stay as they are."));
    sayButton(*m_start, tr("Start measurement"), tr("The rotor turns (Ctrl+Return); Esc stops it"));
    sayButton(*m_use, tr("Use in Tune"),
              tr("Draw the measured points into the open loop of Tune, with the gains proposed there"));
    sayButton(*m_save, tr("Save response\u2026"), tr("Write the file that Tune and the program read"));
    sayButton(*m_table, tr("Save table\u2026"), tr("Write the points with error and coherence as CSV"));
    sayButton(*m_again, tr("Measure again"),
              tr("Back to the settings; this result stays until the next one"));
    refreshPlan();
}

void FrequencyPanel::onDevice() {
    if (!isDepartureTold() && bench().session().state() == SessionState::Connected) {
        messages().clear();
    }
    refreshPlan();
}

void FrequencyPanel::refreshPlan() {
    const DeviceSession& session = bench().session();
    const devices::Catalogue catalogue =
        session.state() == SessionState::Connected ? session.catalogue() : devices::Catalogue{};
    const auto refuse = [this](const Error& error) {
        m_outlook->setText(widgets::inWords(error.message) + QStringLiteral(" \u2192 ") +
                           widgets::inWords(error.hint));
        widgets::setRole(*m_outlook, widgets::Role::Bad);
        m_start->setEnabled(false);
    };
    const auto config = m_form->config();
    if (!config) {
        refuse(config.error());
        return;
    }
    const auto able =
        session.state() == SessionState::Connected ? checkFrequencyBoard(catalogue, *config) : Result<void>();
    const auto plan = planFrequency(*config, frequencyOutlookMargins(catalogue, bench().deviceValues()));
    if (!able || !plan) {
        refuse(able ? plan.error() : able.error());
        return;
    }
    widgets::setRole(*m_outlook, widgets::Role::None);
    const double start_degC = m_preflight->temperature_degC().value_or(AssumedStart_degC);
    m_outlook->setText(frequencyOutlook(*config, *plan, warmest_degC(catalogue, *plan, start_degC)));
    m_preflight->setForecast(
        [catalogue, plan = *plan](double now_degC) { return warmest_degC(catalogue, plan, now_degC); });
    m_start->setEnabled(m_preflight->isPassed());
}

void FrequencyPanel::start() {
    const auto config = m_form->config();
    if (!config || !m_start->isEnabled() || !m_preflight->isPassed()) {
        return;
    }
    const bool hasStarted = runProcedure(
        tr("Frequency response"),
        [config = *config, stray = bench().strayInterval95_T_per_A()](
            devices::Device& device, const ProcedureObserver& observer) -> Result<FrequencyResult> {
            auto conditions = loopConditionsOf(device);
            if (!conditions) {
                return failure(conditions.error());
            }
            takeStrayInterval(*conditions, stray);
            return runFrequency(device, config, conditions->stray, observer);
        },
        [this, header = headerOf("halbench.frequency/1", seedOf(bench().session().info()))](
            const Result<FrequencyResult>& result) { finish(header, result); });
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

void FrequencyPanel::onStage(ProcedureState stage) {
    if (!isMine()) {
        return;
    }
    if (stage == ProcedureState::Excite || stage == ProcedureState::Record) {
        runStep(ExciteStep);
    } else if (stage == ProcedureState::Fit || stage == ProcedureState::Judge) {
        runStep(FitStep);
        m_progress->setText(tr("Computing the response"));
    }
}

void FrequencyPanel::onProgress(double fraction, const QString& text) {
    if (!isMine() || m_isCancelling) {
        return;
    }
    const double done = std::clamp(fraction, 0.0, 0.99);
    const double wall_s = 1e-3 * static_cast<double>(m_sinceStart.elapsed());
    m_progress->setText(widgets::inWords(text));
    m_progress->setProgress(done, done > 0.02 ? std::optional(wall_s * (1.0 - done) / done) : std::nullopt);
}

void FrequencyPanel::finish(const ResultHeader& header, const Result<FrequencyResult>& result) {
    if (!result) {
        fail(result.error(), tr("The measurement was cancelled; everything is as it was before."));
        refreshPlan();
        m_start->setFocus(Qt::OtherFocusReason);
        return;
    }
    bench().session().message(MessageLevel::Info, tr("Frequency response"), verdictTitle(result->quality));
    m_found = *result;
    m_header = header;
    m_result->setResult(*result, header);
    const bool isUsable = result->quality.verdict != Verdict::Refused;
    m_use->setEnabled(isUsable);
    runStep(ResultStep);
    endStep(ResultStep, isUsable ? widgets::StepState::Done : widgets::StepState::Failed);
    showPage(ResultPage);
    (isUsable ? m_use : m_again)->setFocus(Qt::OtherFocusReason);
}

void FrequencyPanel::saveTable() {
    saveText(
        this, chooser(), {tr("Save table"), QStringLiteral("response.csv"), tr("Table (*.csv)")}, files(),
        [result = m_found](const std::string&) { return Result<std::string>(frequencyTable(result)); },
        [this](const QString& path, const Result<void>& written) {
            if (written) {
                messages().showMessage({widgets::Severity::Success, tr("Saved as %1").arg(path), {}, {}});
            } else {
                showError(written.error());
            }
        });
}

} // namespace halbench::app
