#include "app/wizards/axes_identify_panel.h"

#include "app/actuators/actuator.h"
#include "app/documents/result_documents.h"
#include "app/documents/result_header.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/doubtful_source.h"
#include "app/wizards/axes_identify_text.h"
#include "app/wizards/axis_box.h"
#include "app/wizards/identify_text.h"
#include "app/wizards/result_text.h"
#include "control/base/unit_text.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace halbench::app {

AxesIdentifyPanel::AxesIdentifyPanel(Workbench& workbench, QWidget* parent)
    : ExcitationPanel(workbench, parent), m_words(new ResultWords) {
    addPages(*buildForm(), *m_words, {buildSaving()});
    connect(&useButton(), &QPushButton::clicked, this, &AxesIdentifyPanel::tuneRequested);
    AxesIdentifyPanel::refreshWords();
}

QWidget* AxesIdentifyPanel::buildForm() {
    m_form = new QWidget;
    m_rows = new QFormLayout(m_form);
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setSpacing(widgets::GridStep_px);
    m_rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_axis = new QComboBox(m_form);
    m_rows->addRow(new QLabel(m_form), m_axis);
    connect(m_axis, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            &AxesIdentifyPanel::refreshPlan);
    return m_form;
}

QPushButton* AxesIdentifyPanel::buildSaving() {
    m_save = new QPushButton(this);
    m_save->setIcon(widgets::themedIcon(QStringLiteral("save")));
    m_save->hide();
    connect(m_save, &QPushButton::clicked, this, [this] {
        if (m_found) {
            save({tr("Save as model"), QStringLiteral("model.json"), tr("Model (*.json)")},
                 [header = m_header, result = *m_found] {
                     return identificationDocument(header, IdentifyOutcome(result));
                 });
        }
    });
    return m_save;
}

void AxesIdentifyPanel::onFileChooser() {
    m_save->setVisible(bool(chooser().save));
}

void AxesIdentifyPanel::refreshWords() {
    setSteps({tr("Prepare"), tr("Excite"), tr("Fit"), tr("Result")});
    intro().setText(
        tr("Finds damping, gain and friction of every axis and the constants of the actuator with "
           "their 95 % intervals, by moving it to and fro while all axes are excited."));
    running().setText(tr("The actuator moves. STOP (Esc) and Cancel end it; gains, limits, mode, windows and "
                         "generator are restored."));
    setComputingWords(tr("Computing the result"));
    sayButton(startButton(), tr("Start identification"),
              tr("The actuator moves (Ctrl+Return); Esc stops it"));
    sayButton(useButton(), tr("Tune with this model"), tr("Go on to the gains for these axes"));
    sayButton(*m_save, tr("Save as model…"), tr("Save a file for the commands tune and analyse"));
    sayButton(againButton(), tr("Identify again"),
              tr("Back to the settings; this result stays until the next run"));
    m_words->table().setAccessibleName(tr("Identified values"));
    m_model.clear(); // its form in the other language
    showResult();
    refreshPlan();
}

/// Axes of the device, and a field for each constant that its entry takes.
void AxesIdentifyPanel::refreshForm() {
    const DeviceSession& session = bench().session();
    if (session.state() != SessionState::Connected || session.info().model == m_model) {
        return;
    }
    m_model = session.info().model;
    fillAxisBox(*m_axis, session.catalogue(), tr("all"));
    m_axis->setAccessibleName(tr("Axes of the model"));
    m_axis->setToolTip(tr("Axes of the model; all axes move during the run"));
    qobject_cast<QLabel*>(m_rows->labelForField(m_axis))->setText(m_axis->accessibleName());
    while (m_rows->rowCount() > 1) {
        m_rows->removeRow(1);
    }
    m_constants.clear();
    for (const KnownConstant& constant : actuatorOf(m_model).knownConstants) {
        auto* edit = new widgets::OptionalNumberEdit(m_form);
        edit->setLimits({0.0, 1e6, false});
        edit->setPlaceholderText(tr("not known"));
        const QString title = widgets::inWords(std::string(constant.title));
        const QString unit = QString::fromStdString(unitText(constant.unit));
        edit->setAccessibleName(title);
        edit->setExplanation(tr("%1 in %2, if known. Without a known constant only ratios are identified, "
                                "which is enough for tuning")
                                 .arg(title, unit));
        m_rows->addRow(QStringLiteral("%1 %2 [%3]")
                           .arg(title, QString::fromStdString(std::string(constant.symbol)), unit),
                       edit);
        connect(edit, &widgets::OptionalNumberEdit::valueChanged, this, &AxesIdentifyPanel::refreshPlan);
        m_constants.push_back({std::string(constant.symbol), edit});
    }
}

Result<IdentifyConfig> AxesIdentifyPanel::config() const {
    const IdentifyEntry& entry = actuatorOf(m_model).identify;
    IdentifyConfig config;
    config.axis = m_axis->currentData().toString().toStdString();
    config.seed = seedOf(bench().session().info());
    for (const Constant& constant : m_constants) {
        if (!constant.edit->isValid()) {
            return failure(
                ErrorCode::InvalidInput,
                tr("%1: %2").arg(constant.edit->accessibleName(), constant.edit->problem()).toStdString(),
                tr("Correct it or leave it empty").toStdString());
        }
        if (const auto value = constant.edit->value()) {
            if (const auto set = entry.setGiven(config, constant.symbol, *value); !set) {
                return failure(set.error());
            }
        }
    }
    const auto possible = entry.check(bench().session().catalogue(), config);
    return possible ? Result<IdentifyConfig>(config) : failure(possible.error());
}

void AxesIdentifyPanel::makePlan() {
    refreshForm();
    if (bench().session().state() != SessionState::Connected) {
        announce(tr("Connect a device with several axes."), {});
        return;
    }
    const auto wanted = config();
    if (!wanted) {
        refuse(wanted.error());
        return;
    }
    const IdentifyEntry& entry = actuatorOf(m_model).identify;
    const auto warmest_degC = [config = *wanted, &entry](double start_degC) {
        return entry.predict(config, start_degC).highestTemperature_degC;
    };
    constexpr double Usual_degC = 25.0;
    announce(axesOutlook(entry.predict(*wanted, Usual_degC), axesOf(bench().session().catalogue())),
             warmest_degC);
}

void AxesIdentifyPanel::start() {
    const auto wanted = isReady() ? config() : failure(ErrorCode::Refused, "", "");
    if (!wanted) {
        return;
    }
    const auto run = actuatorOf(m_model).identify.run;
    const bool hasStarted = runProcedure(
        tr("Identify"),
        [config = *wanted, run](devices::Device& device, const ProcedureObserver& observer) {
            return run(device, config, observer);
        },
        [this, header = headerOf(AxisModelSchema, wanted->seed)](const Result<IdentifyOutcome>& outcome) {
            finish(header, outcome);
        });
    if (hasStarted) {
        showRunning(tr("Identifying"));
    }
}

void AxesIdentifyPanel::finish(const ResultHeader& header, const Result<IdentifyOutcome>& outcome) {
    const auto* found = outcome ? std::get_if<AxesIdentifyResult>(&*outcome) : nullptr;
    if (found == nullptr) {
        showFailure(outcome ? Error{ErrorCode::Usage,
                                    "this device has several axes, but its identification is of one",
                                    "update the program"}
                            : outcome.error(),
                    tr("Identification cancelled. Nothing was changed."));
        return;
    }
    bench().session().message(MessageLevel::Info, tr("Identify"), verdictTitle(found->quality));
    m_found = *found;
    m_header = header;
    showResult();
    const bool isUsable = found->quality.verdict != Verdict::Refused;
    showFound(isUsable);
    if (isUsable) {
        AxisModelFile model{header, found->model};
        model.header.quality = found->quality;
        model.model.doubts = doubtsOfModel(found->quality);
        Q_EMIT identified(model);
    }
}

void AxesIdentifyPanel::showResult() {
    if (!m_found) {
        return;
    }
    m_words->setQuality(m_found->quality);
    m_words->table().setRows(axesRows(*m_found, axesOf(bench().session().catalogue())));
    m_words->setUse(tr("Tuning uses damping rate, acceleration per effort and friction of each axis."));
    m_words->setProvenance(provenanceText(m_header, m_found->duration_s, m_found->highestTemperature_degC));
}

} // namespace halbench::app
