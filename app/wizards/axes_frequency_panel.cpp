#include "app/wizards/axes_frequency_panel.h"

#include "app/documents/axes_frequency_documents.h"
#include "app/documents/result_header.h"
#include "app/figures/axes_frequency_figures.h"
#include "app/procedures/base/axis_choice.h"
#include "app/wizards/axes_frequency_text.h"
#include "app/wizards/axis_box.h"
#include "app/wizards/identify_text.h"
#include "app/wizards/result_text.h"
#include "app/wizards/words_and_pictures.h"
#include "app/workbench/document_files.h"
#include "app/workspaces/parts/figure_units.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/figure/figure_view.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>

#include <cmath>

namespace halbench::app {

AxesFrequencyPanel::AxesFrequencyPanel(Workbench& workbench, QWidget* parent)
    : ExcitationPanel(workbench, parent) {
    QWidget* form = buildForm();
    QWidget* result = buildResult();
    addPages(*form, *result, buildSaving());
    connect(&useButton(), &QPushButton::clicked, this, [this] {
        if (m_found) {
            Q_EMIT useRequested(*m_found);
        }
    });
    connect(&bench(), &Workbench::displayUnitsChanged, this, &AxesFrequencyPanel::showResult);
    AxesFrequencyPanel::refreshWords();
}

QWidget* AxesFrequencyPanel::buildForm() {
    m_form = new QWidget;
    auto* rows = new QFormLayout(m_form);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(widgets::GridStep_px);
    rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_axis = new QComboBox(m_form);
    rows->addRow(new QLabel(m_form), m_axis);
    connect(m_axis, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            &AxesFrequencyPanel::refreshPlan);
    const AxesFrequencyConfig defaults;
    const std::array<double, Fields> start = {defaults.from_Hz, defaults.to_Hz, 100.0 * defaults.effort_ratio,
                                              static_cast<double>(defaults.periods)};
    const std::array<widgets::NumberLimits, Fields> limits = {
        widgets::NumberLimits{0.01, 1e4, true}, widgets::NumberLimits{0.01, 1e4, true},
        widgets::NumberLimits{0.1, 50.0, true}, widgets::NumberLimits{4.0, 256.0, true}};
    for (std::size_t i = 0; i < Fields; ++i) {
        auto* edit = new widgets::OptionalNumberEdit(m_form);
        edit->setLimits(limits[i]);
        edit->setValue(start[i]);
        rows->addRow(new QLabel(m_form), edit);
        connect(edit, &widgets::OptionalNumberEdit::valueChanged, this, &AxesFrequencyPanel::refreshPlan);
        m_numbers[i] = edit;
    }
    return m_form;
}

QWidget* AxesFrequencyPanel::buildResult() {
    m_words = new ResultWords;
    m_figures = new QTabWidget;
    for (widgets::FigureView*& view : m_views) {
        view = new widgets::FigureView(m_figures);
        m_figures->addTab(view, {});
        connect(view, &widgets::FigureView::exportRequested, this, [this, view = view] {
            savePicture(this, chooser(), QStringLiteral("response.svg"), files(), *view,
                        [this](const Error& error) { showError(error); });
        });
    }
    m_both = new WordsAndPictures(m_words, &m_words->table(), m_figures);
    return m_both;
}

std::vector<QPushButton*> AxesFrequencyPanel::buildSaving() {
    m_save = new QPushButton(this);
    m_table = new QPushButton(this);
    for (QPushButton* button : {m_save, m_table}) {
        button->setIcon(widgets::themedIcon(QStringLiteral("save")));
        button->hide();
    }
    connect(m_save, &QPushButton::clicked, this, [this] {
        if (m_found) {
            save({tr("Save response"), QStringLiteral("response.json"), tr("Response (*.json)")},
                 [header = m_header, result = *m_found] { return axesFrequencyDocument(header, result); });
        }
    });
    connect(m_table, &QPushButton::clicked, this, &AxesFrequencyPanel::saveTable);
    return {m_save, m_table};
}

void AxesFrequencyPanel::onFileChooser() {
    m_save->setVisible(bool(chooser().save));
    m_table->setVisible(bool(chooser().save));
}

void AxesFrequencyPanel::refreshWords() {
    setSteps({tr("Prepare"), tr("Excite"), tr("Fit"), tr("Result")});
    intro().setText(
        tr("Measures the loops of all axes together, with the gains of the device: margins of each "
           "axis with 95 % intervals, and the coupling between them."));
    running().setText(
        tr("The actuator is excited around its position. STOP (Esc) and Cancel end the run; mode, "
           "windows and generator are restored, the gains are not changed."));
    setComputingWords(tr("Computing the response"));
    sayButton(startButton(), tr("Start measurement"), tr("The actuator moves (Ctrl+Return); Esc stops it"));
    sayButton(useButton(), tr("Use in Tune"), tr("Show the points in the open loop of each axis in Tune"));
    sayButton(*m_save, tr("Save response\u2026"), tr("Save the matrix of responses as a file"));
    sayButton(*m_table, tr("Save table\u2026"), tr("Save the points with error and coherence as CSV"));
    sayButton(againButton(), tr("Measure again"),
              tr("Back to the settings; this result stays until the next run"));
    const QString names[] = {tr("Lowest frequency [Hz]"), tr("Highest frequency [Hz]"), tr("Effort [%]"),
                             tr("Periods")};
    const QString helps[] = {tr("One period of the excitation lasts at least two of this frequency"),
                             tr("At most 45 % of the sampling rate of the loops"),
                             tr("Amplitude of a sine of the same rms, of the largest effort of each axis; "
                                "reduced where an axis would swing too far"),
                             tr("Periods of each experiment that are averaged; the intervals shrink with the "
                                "square root")};
    auto* rows = static_cast<QFormLayout*>(m_form->layout());
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        m_numbers[i]->setAccessibleName(names[i]);
        m_numbers[i]->setExplanation(helps[i]);
        static_cast<QLabel*>(rows->labelForField(m_numbers[i]))->setText(names[i]);
    }
    m_axis->setAccessibleName(tr("Excited axes"));
    m_axis->setToolTip(tr("All at once shows the coupling; the loops of the others stay closed"));
    static_cast<QLabel*>(rows->labelForField(m_axis))->setText(m_axis->accessibleName());
    m_words->table().setAccessibleName(tr("Measured margins"));
    m_both->setWordsName(m_words->table().accessibleName());
    const std::pair<QString, QString> tabs[] = {
        {tr("Loops"), tr("Open loop of each axis while the others are closed, and coherence")},
        {tr("Coupling"), tr("Response of each axis to the effort of another, relative to its own")},
        {tr("All together"), tr("Largest singular values of S and T over frequency")}};
    for (int i = 0; i < m_figures->count(); ++i) {
        m_figures->setTabText(i, tabs[i].first);
        m_figures->setTabToolTip(i, tabs[i].second);
    }
    m_figures->setAccessibleName(tr("Pictures of the frequency response"));
    m_model.clear(); // the list of axes in the other language
    showResult();
    refreshPlan();
}

void AxesFrequencyPanel::refreshAxes() {
    const DeviceSession& session = bench().session();
    if (session.state() != SessionState::Connected || session.info().model == m_model) {
        return;
    }
    m_model = session.info().model;
    fillAxisBox(*m_axis, session.catalogue(), tr("all at once"));
}

Result<AxesFrequencyConfig> AxesFrequencyPanel::config() const {
    for (const widgets::OptionalNumberEdit* edit : m_numbers) {
        if (!edit->value()) {
            return failure(
                ErrorCode::InvalidInput,
                tr("%1: %2")
                    .arg(edit->accessibleName(), edit->isValid() ? tr("is missing") : edit->problem())
                    .toStdString(),
                tr("Enter a number").toStdString());
        }
    }
    AxesFrequencyConfig config;
    config.axis = m_axis->currentData().toString().toStdString();
    config.from_Hz = *m_numbers[From]->value();
    config.to_Hz = *m_numbers[To]->value();
    config.effort_ratio = 0.01 * *m_numbers[Effort]->value();
    config.periods = static_cast<int>(std::lround(*m_numbers[Periods]->value()));
    return config;
}

void AxesFrequencyPanel::makePlan() {
    refreshAxes();
    const DeviceSession& session = bench().session();
    if (session.state() != SessionState::Connected) {
        announce(tr("Connect a device with several axes."), {});
        return;
    }
    const auto wanted = config();
    const auto duration_s =
        wanted ? axesFrequencyDuration_s(session.catalogue(), *wanted) : failure(wanted.error());
    if (!duration_s) {
        refuse(duration_s.error());
        return;
    }
    const auto axes = chosenAxes(session.catalogue(), wanted->axis);
    announce(axesFrequencyOutlook(*wanted, *duration_s, axes.value_or(axesOf(session.catalogue()))), {});
}

void AxesFrequencyPanel::start() {
    const auto wanted = isReady() ? config() : failure(ErrorCode::Refused, "", "");
    if (!wanted) {
        return;
    }
    const bool hasStarted = runProcedure(
        tr("Frequency response"),
        [config = *wanted](devices::Device& device, const ProcedureObserver& observer) {
            return runAxesFrequency(device, config, observer);
        },
        [this, header = headerOf(AxisFrequencySchema, seedOf(bench().session().info()))](
            const Result<AxesFrequencyResult>& result) { finish(header, result); });
    if (hasStarted) {
        showRunning(tr("Measuring"));
    }
}

void AxesFrequencyPanel::finish(const ResultHeader& header, const Result<AxesFrequencyResult>& result) {
    if (!result) {
        showFailure(result.error(), tr("Measurement cancelled. Nothing was changed."));
        return;
    }
    bench().session().message(MessageLevel::Info, tr("Frequency response"), verdictTitle(result->quality));
    m_found = *result;
    m_header = header;
    showResult();
    m_both->shareAnew();
    showFound(result->quality.verdict != Verdict::Refused);
}

void AxesFrequencyPanel::showResult() {
    if (!m_found) {
        return;
    }
    m_words->setQuality(m_found->quality);
    m_words->table().setRows(axesFrequencyRows(*m_found));
    m_words->setUse(axesFrequencyUse(*m_found));
    m_words->setProvenance(provenanceText(m_header, m_found->duration_s, m_found->highestTemperature_degC));
    const bool hasPoints = !m_found->points.empty();
    const widgets::Figure figures[] = {hasPoints ? axesLoopsFigure(*m_found) : widgets::Figure{},
                                       hasPoints ? axesCouplingFigure(*m_found) : widgets::Figure{},
                                       hasPoints ? axesSensitivityFigure(*m_found) : widgets::Figure{}};
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        showInFrequencyUnit(*m_views[i], figures[i], bench().displayUnits().frequency);
    }
    m_figures->setTabEnabled(1, m_found->axes.size() > 1);
}

void AxesFrequencyPanel::saveTable() {
    if (!m_found) {
        return;
    }
    saveText(
        this, chooser(), {tr("Save table"), QStringLiteral("response.csv"), tr("Table (*.csv)")}, files(),
        [result = *m_found](const std::string&) { return Result<std::string>(axesFrequencyTable(result)); },
        [this](const QString& path, const Result<void>& written) {
            if (written) {
                messages().showMessage({widgets::Severity::Success, tr("Saved as %1").arg(path), {}, {}});
            } else {
                showError(written.error());
            }
        });
}

} // namespace halbench::app
