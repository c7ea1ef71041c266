#include "app/wizards/relay_panel.h"

#include "app/documents/relay_document.h"
#include "app/figures/frequency_figures.h"
#include "app/procedures/frequency/frequency_board.h"
#include "app/procedures/relay/relay_plan.h"
#include "app/wizards/frequency_text.h"
#include "app/wizards/identify_text.h"
#include "app/wizards/relay_form.h"
#include "app/wizards/relay_text.h"
#include "app/wizards/result_text.h"
#include "app/wizards/words_and_pictures.h"
#include "app/workbench/shared_results.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/figure/figure_view.h"
#include "widgets/theme/icons.h"

#include <QLabel>
#include <QPushButton>

namespace halbench::app {

RelayPanel::RelayPanel(Workbench& workbench, QWidget* parent)
    : ExcitationPanel(workbench, parent), m_plan(failure(ErrorCode::InvalidInput, "", "")) {
    m_form = new RelayForm;
    QWidget* result = buildResult();
    addPages(*m_form, *result, {buildSaving()});
    connect(m_form, &RelayForm::changed, this, &RelayPanel::refreshPlan);
    connect(&bench(), &Workbench::identificationChanged, this, &RelayPanel::refreshPlan);
    connect(&useButton(), &QPushButton::clicked, this, [this] {
        if (m_found && m_found->ultimate) {
            Q_EMIT useRequested(*ultimateGainOf(*m_found).value, *ultimatePeriodOf(*m_found).value);
        }
    });
    RelayPanel::refreshWords();
}

void RelayPanel::onFileChooser() {
    m_save->setVisible(bool(chooser().save));
}

QWidget* RelayPanel::buildResult() {
    m_words = new ResultWords;
    m_record = new widgets::FigureView;
    m_both = new WordsAndPictures(m_words, &m_words->table(), m_record);
    return m_both;
}

QPushButton* RelayPanel::buildSaving() {
    m_save = new QPushButton(this);
    m_save->setIcon(widgets::themedIcon(QStringLiteral("save")));
    m_save->hide();
    connect(m_save, &QPushButton::clicked, this, [this] {
        if (m_found) {
            save({tr("Save result"), QStringLiteral("relay.json"), tr("Relay experiment (*.json)")},
                 [header = m_header, result = *m_found] { return relayDocument(header, result); });
        }
    });
    return m_save;
}

void RelayPanel::refreshWords() {
    setSteps({tr("Prepare"), tr("Oscillate"), tr("Fit"), tr("Result")});
    intro().setText(tr("Measures the ultimate gain with its 95 % interval: the loop oscillates around a "
                       "steady motion under saturating proportional control. Calibrate the sensors first."));
    running().setText(tr("The rotor turns steadily and oscillates. STOP (Esc) and Cancel end the run. Gains, "
                         "limits, mode, windows and generator are restored."));
    setComputingWords(tr("Computing the result"));
    sayButton(startButton(), tr("Start experiment"),
              tr("The rotor turns and oscillates (Ctrl+Return); Esc stops it"));
    sayButton(useButton(), tr("Use in Tune"),
              tr("Propose Ziegler-Nichols gains with their assessment; nothing is applied"));
    sayButton(*m_save, tr("Save result\u2026"), tr("Save a file for tune --relay"));
    sayButton(againButton(), tr("Measure again"),
              tr("Back to the settings; this result stays until the next run"));
    m_record->setAccessibleName(tr("Oscillation as recorded"));
    m_both->setWordsName(tr("Ultimate gain and period"));
    m_words->table().setAccessibleName(tr("Ultimate gain and period"));
    showResult();
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

void RelayPanel::makePlan() {
    replan();
    if (!m_plan || !m_config) {
        refuse(m_plan.error());
        return;
    }
    promise(m_plan->meanSquare_A2, m_plan->duration_s(),
            [this](double warmest_degC) { return relayOutlook(*m_config, *m_plan, warmest_degC); });
}

void RelayPanel::start() {
    if (!m_config || !m_plan || !isReady()) {
        return;
    }
    const bool hasStarted = runProcedure(
        tr("Relay experiment"),
        [config = *m_config](devices::Device& device, const ProcedureObserver& observer) {
            return runRelay(device, config, observer);
        },
        [this, header = headerOf("halbench.relay/1", seedOf(bench().session().info()))](
            const Result<RelayResult>& result) { finish(header, result); });
    if (hasStarted) {
        showRunning(tr("Measuring"));
    }
}

void RelayPanel::finish(const ResultHeader& header, const Result<RelayResult>& result) {
    if (!result) {
        showFailure(result.error(), tr("Experiment cancelled. Nothing was changed."));
        return;
    }
    bench().session().message(MessageLevel::Info, tr("Relay experiment"), verdictTitle(result->quality));
    m_found = *result;
    m_header = header;
    showResult();
    m_both->shareAnew();
    showFound(result->ultimate.has_value());
}

void RelayPanel::showResult() {
    if (!m_found) {
        return;
    }
    m_words->setQuality(m_found->quality);
    m_words->table().setRows(relayRows(*m_found));
    m_words->setUse(relayUse(*m_found));
    m_words->setProvenance(provenanceText(m_header, m_found->duration_s, m_found->highestTemperature_degC));
    m_record->setFigure(excitationFigure(m_found->recording).value_or(widgets::Figure{}));
}

} // namespace halbench::app
