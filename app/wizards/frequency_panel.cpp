#include "app/wizards/frequency_panel.h"

#include "app/documents/frequency_table.h"
#include "app/documents/result_documents.h"
#include "app/procedures/frequency/frequency_board.h"
#include "app/tuning/loop_conditions.h"
#include "app/wizards/axes_frequency_panel.h"
#include "app/wizards/frequency_form.h"
#include "app/wizards/frequency_result_view.h"
#include "app/wizards/frequency_text.h"
#include "app/wizards/identify_text.h"
#include "app/workbench/document_files.h"
#include "widgets/controls/message_bar.h"
#include "widgets/theme/icons.h"

#include <QLabel>
#include <QPushButton>

namespace halbench::app {

FrequencyPanel::FrequencyPanel(Workbench& workbench, QWidget* parent) : ExcitationPanel(workbench, parent) {
    m_form = new FrequencyForm;
    QWidget* result = buildResult();
    addPages(*m_form, *result, buildSaving());
    connect(m_form, &FrequencyForm::changed, this, &FrequencyPanel::refreshPlan);
    connect(&useButton(), &QPushButton::clicked, this, [this] { Q_EMIT useRequested(m_found); });
    const auto takeUnit = [this] { m_result->setFrequencyUnit(bench().displayUnits().frequency); };
    connect(&bench(), &Workbench::displayUnitsChanged, this, takeUnit);
    takeUnit();
    connect(&bench(), &Workbench::deviceChanged, this, &FrequencyPanel::showAxes);
    showAxes();
    FrequencyPanel::refreshWords();
}

void FrequencyPanel::onFileChooser() {
    m_save->setVisible(bool(chooser().save));
    m_table->setVisible(bool(chooser().save));
    if (m_axes != nullptr) {
        m_axes->setFileChooser(chooser());
    }
}

void FrequencyPanel::showAxes() {
    const DeviceSession& session = bench().session();
    if (session.state() != SessionState::Connected) {
        return;
    }
    const bool areSeveral = session.catalogue().axes.size() > 1;
    if (areSeveral && m_axes == nullptr) {
        m_axes = new AxesFrequencyPanel(bench(), this);
        connect(m_axes, &AxesFrequencyPanel::useRequested, this, &FrequencyPanel::axesUseRequested);
        m_axes->setFileChooser(chooser());
        setAlternative(*m_axes);
    }
    showAlternative(areSeveral);
}

QWidget* FrequencyPanel::buildResult() {
    m_result = new FrequencyResultView;
    m_result->setFileChooser(&chooser());
    connect(m_result, &FrequencyResultView::notSaved, this,
            [this](const QString& text, const QString& remedy) {
                messages().showMessage({widgets::Severity::Error, text, remedy, {}});
            });
    return m_result;
}

std::vector<QPushButton*> FrequencyPanel::buildSaving() {
    m_save = new QPushButton(this);
    m_table = new QPushButton(this);
    for (QPushButton* button : {m_save, m_table}) {
        button->setIcon(widgets::themedIcon(QStringLiteral("save")));
        button->hide();
    }
    connect(m_save, &QPushButton::clicked, this, [this] {
        save({tr("Save response"), QStringLiteral("response.json"), tr("Response (*.json)")},
             [header = m_header, result = m_found] { return frequencyDocument(header, result); });
    });
    connect(m_table, &QPushButton::clicked, this, &FrequencyPanel::saveTable);
    return {m_save, m_table};
}

void FrequencyPanel::refreshWords() {
    setSteps({tr("Prepare"), tr("Excite"), tr("Fit"), tr("Result")});
    intro().setText(tr("Measures the loop with the device's gains over frequency: open loop, plant and "
                       "margins with 95 % intervals, during a steady motion in one direction."));
    running().setText(tr("The rotor turns steadily and is excited. STOP (Esc) and Cancel end the run. Mode, "
                         "windows and generator are restored; the gains are not changed."));
    setComputingWords(tr("Computing the response"));
    sayButton(startButton(), tr("Start measurement"), tr("The rotor turns (Ctrl+Return); Esc stops it"));
    sayButton(useButton(), tr("Use in Tune"),
              tr("Show the measured points in the open loop of Tune, with the proposed gains"));
    sayButton(*m_save, tr("Save response\u2026"), tr("Save a file for Tune and the command line"));
    sayButton(*m_table, tr("Save table\u2026"), tr("Save the points with error and coherence as CSV"));
    sayButton(againButton(), tr("Measure again"),
              tr("Back to the settings; this result stays until the next run"));
    refreshPlan();
}

void FrequencyPanel::makePlan() {
    const DeviceSession& session = bench().session();
    const bool isConnected = session.state() == SessionState::Connected;
    const devices::Catalogue catalogue = isConnected ? session.catalogue() : devices::Catalogue{};
    const auto config = m_form->config();
    if (!config) {
        refuse(config.error());
        return;
    }
    const auto able = isConnected ? checkFrequencyBoard(catalogue, *config) : Result<void>();
    const auto plan = planFrequency(*config, frequencyOutlookMargins(catalogue, bench().deviceValues()));
    if (!able || !plan) {
        refuse(able ? plan.error() : able.error());
        return;
    }
    promise(plan->meanSquare_A2, plan->duration_s(),
            [&](double warmest_degC) { return frequencyOutlook(*config, *plan, warmest_degC); });
}

void FrequencyPanel::start() {
    const auto config = m_form->config();
    if (!config || !isReady()) {
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
    if (hasStarted) {
        showRunning(tr("Measuring"));
    }
}

void FrequencyPanel::finish(const ResultHeader& header, const Result<FrequencyResult>& result) {
    if (!result) {
        showFailure(result.error(), tr("Measurement cancelled. Nothing was changed."));
        return;
    }
    bench().session().message(MessageLevel::Info, tr("Frequency response"), verdictTitle(result->quality));
    m_found = *result;
    m_header = header;
    m_result->setResult(*result, header);
    showFound(result->quality.verdict != Verdict::Refused);
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
