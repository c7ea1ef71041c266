#include "app/workspaces/tune/axes/axis_tune_panel.h"

#include "app/documents/result_header.h"
#include "app/figures/axis_figures.h"
#include "app/workbench/departure_text.h"
#include "app/workspaces/parts/page_chooser.h"
#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/parts/preflight.h"
#include "app/workspaces/tune/axes/axis_gain_editor.h"
#include "app/workspaces/tune/axes/axis_gain_files.h"
#include "app/workspaces/tune/axes/axis_response_button.h"
#include "app/workspaces/tune/axes/axis_targets.h"
#include "app/workspaces/tune/axes/axis_verdict.h"
#include "app/workspaces/tune/loop/design_names.h"
#include "app/workspaces/tune/loop/loop_sliders.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "control/design/axis_designs.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

AxisTunePanel::AxisTunePanel(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_message(new widgets::MessageBar(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::PanelMargin_px);
    auto* splitter = new QSplitter(Qt::Horizontal, this);
    splitter->setChildrenCollapsible(false);
    QWidget* settings = buildSettings();
    settings->setMinimumWidth(45 * fontMetrics().averageCharWidth());
    splitter->addWidget(settings);
    splitter->addWidget(buildFigures());
    splitter->setStretchFactor(1, 1);
    column->addWidget(splitter, 1);
    (new widgets::FloatingRows(*splitter, Qt::BottomEdge, this))->addRow(*m_message); // tabs are at the top
    connectParts();
    refreshWords();
}

QWidget* AxisTunePanel::buildSettings() {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, widgets::PanelMargin_px, 0);
    column->setSpacing(widgets::PanelMargin_px);
    m_form = new QFormLayout;
    m_form->setSpacing(widgets::GridStep_px);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_axes = new QComboBox(content);
    m_method = new QComboBox(content);
    for (QComboBox* box : {m_axes, m_method}) {
        auto* label = new QLabel(content);
        label->setBuddy(box);
        m_form->addRow(label, box);
    }
    m_targets = new AxisTargets(*m_form, content);
    column->addLayout(m_form);
    m_gains = new AxisGainEditor(content);
    m_sliders = new LoopSliders(content);
    m_verdict = new widgets::VerdictView(this);
    m_preflight = new Preflight(m_bench, content);
    m_scope = new QComboBox(this);
    m_apply = new QPushButton(this);
    m_restore = new QPushButton(this);
    m_gainFiles = new AxisGainFiles(
        [this]() -> Result<JsonValue> {
            const auto result = m_loops.result(m_loops.axes());
            ResultHeader header = m_bench.beginResult("halbench.gains/1");
            header.device = m_loops.model().header.device;
            return result ? Result<JsonValue>(axisGainsDocument(header, *result)) : failure(result.error());
        },
        this);
    m_progress = new widgets::ProgressRow(this);
    m_progress->hide();
    widgets::setRole(*m_apply, widgets::Role::Primary);
    for (QWidget* part : std::initializer_list<QWidget*>{m_gains, m_sliders}) {
        column->addWidget(part);
    }
    m_verdict->moveRemarks(*column); // its title stays in sight
    column->addWidget(m_preflight);
    column->addStretch(1);
    QScrollArea* scroll = makeScrollArea(content);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* settings = new QWidget(this);
    auto* all = new QVBoxLayout(settings);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(widgets::PanelMargin_px);
    all->addWidget(scroll, 1);
    all->addWidget(m_verdict); // the decision stays in sight, however far the rest is scrolled
    all->addWidget(m_progress);
    auto* buttons = new QGridLayout; // three in a row do not fit the width of the settings in every language
    buttons->setSpacing(widgets::PanelMargin_px);
    buttons->addWidget(m_apply, 0, 0);
    buttons->addWidget(m_scope, 0, 1);
    buttons->addWidget(m_restore, 1, 0);
    buttons->addWidget(m_gainFiles, 0, 2);
    buttons->setColumnStretch(3, 1);
    all->addLayout(buttons);
    return settings;
}

QWidget* AxisTunePanel::buildFigures() {
    m_figures = new PageChooser(this);
    m_loop = new LoopView(m_figures);
    m_response = new AxisResponseButton(m_loops, m_loop);
    m_loop->addTool(*m_response);
    m_forget = new QPushButton(m_loop);
    m_forget->hide();
    m_loop->addTool(*m_forget);
    m_step = new widgets::FigureView(m_figures);
    m_verification = new widgets::FigureView(m_figures);
    for (QWidget* page : std::initializer_list<QWidget*>{m_loop, m_step, m_verification}) {
        m_figures->addPage(page);
    }
    constexpr int CharactersOfAPicture = 52;
    m_figures->pairWhenWide(m_loop, m_step, 2 * CharactersOfAPicture * fontMetrics().averageCharWidth());
    m_figures->setPageEnabled(m_verification, false);
    return m_figures;
}

void AxisTunePanel::connectParts() {
    const auto chosen = QOverload<int>::of(&QComboBox::currentIndexChanged);
    connect(m_axes, chosen, this, [this] { chooseAxis(m_axes->currentData().toString().toStdString()); });
    connect(m_method, chosen, this, &AxisTunePanel::chooseMethod);
    connect(m_scope, chosen, this, &AxisTunePanel::refreshButtons);
    connect(m_targets, &AxisTargets::edited, this, &AxisTunePanel::takeTargets);
    connect(m_gains, &AxisGainEditor::edited, this, [this] {
        if (const auto law = m_gains->law()) {
            takeEdited(*law);
        } else {
            m_loops.setAnswer(m_axis, failure(law.error()));
            showAxis();
        }
    });
    const auto connectHand = [this](const auto* hand) {
        using Hand = std::remove_cv_t<std::remove_pointer_t<decltype(hand)>>;
        connect(hand, &Hand::crossoverMoved, this, [this](double crossover_rad_s) {
            if (auto aim = m_loops.aim(m_axis)) {
                aim->crossover_rad_s = crossover_rad_s;
                shape(*aim, control::CrossoverPriority::Margin);
            }
        });
        connect(hand, &Hand::phaseMarginMoved, this, [this](double margin_deg) {
            if (auto aim = m_loops.aim(m_axis)) {
                aim->phaseMargin_deg = margin_deg;
                shape(*aim, control::CrossoverPriority::Crossover);
            }
        });
    };
    connectHand(m_sliders);
    connectHand(m_loop);
    connect(m_loop, &LoopView::loopsWanted, this, &AxisTunePanel::showAxis);
    connect(m_preflight, &Preflight::changed, this, &AxisTunePanel::refreshButtons);
    connect(m_apply, &QPushButton::clicked, this, &AxisTunePanel::apply);
    connect(m_restore, &QPushButton::clicked, this, &AxisTunePanel::restore);
    connect(m_gainFiles, &AxisGainFiles::opened, this, &AxisTunePanel::takeFromFile);
    connect(m_gainFiles, &AxisGainFiles::failed, this, &AxisTunePanel::showError);
    connect(m_gainFiles, &AxisGainFiles::saved, this, [this](const QString& path) {
        m_message->showMessage({widgets::Severity::Success, tr("Saved as %1").arg(path), {}, {}});
    });
    connect(m_response, &AxisResponseButton::opened, this, &AxisTunePanel::useMeasured);
    connect(m_response, &AxisResponseButton::failed, this, &AxisTunePanel::showError);
    connect(m_forget, &QPushButton::clicked, this, [this] {
        m_loops.forgetMeasured(m_axis);
        refreshMeasured();
        showAxis();
    });
    connect(m_progress, &widgets::ProgressRow::cancelRequested, &m_bench.session(),
            &DeviceSession::abortProcedure);
    connect(&m_bench, &Workbench::valuesChanged, this, &AxisTunePanel::onValues);
    connect(&m_bench, &Workbench::displayUnitsChanged, this,
            [this] { m_loop->setFrequencyUnit(m_bench.displayUnits().frequency); });
    connect(&m_bench.session(), &DeviceSession::procedureChanged, this, &AxisTunePanel::refreshButtons);
    connect(&m_bench.session(), &DeviceSession::procedureProgress, this,
            [this](double fraction, const QString& text) {
                if (m_isApplying) {
                    m_progress->setText(tr("Verification: %1").arg(widgets::inWords(text)));
                    m_progress->setProgress(fraction);
                }
            });
}

void AxisTunePanel::refreshWords() {
    const auto nameRow = [this](QComboBox& box, const QString& name, const QString& help) {
        box.setAccessibleName(name);
        box.setToolTip(help);
    };
    nameRow(*m_axes, tr("Axis"), tr("Axis of the loop shown"));
    nameRow(*m_method, tr("Gains"), tr("Design method for the gains of this axis"));
    nameRow(*m_scope, tr("Axes to apply"), tr("Gains that Apply and verify writes, in one transaction"));
    for (QComboBox* box : {m_axes, m_method}) {
        static_cast<QLabel*>(m_form->labelForField(box))->setText(box->accessibleName());
    }
    m_targets->refreshWords();
    const int scope = std::max(m_scope->currentIndex(), 0);
    const QSignalBlocker quiet(m_scope);
    m_scope->clear();
    m_scope->addItem(tr("all axes"));
    m_scope->addItem(tr("this axis"));
    m_scope->setCurrentIndex(scope);
    m_apply->setText(tr("Apply and verify"));
    m_apply->setToolTip(
        tr("Write the gains in one transaction, then verify each axis with a step; Esc stops it"));
    m_restore->setText(tr("Restore"));
    m_restore->setToolTip(tr("Write the gains from before the last apply"));
    m_forget->setText(tr("Remove the response"));
    m_forget->setToolTip(tr("Show only predictions in the open loop of this axis"));
    m_figures->setTitle(m_loop, tr("Open loop"), tr("Bode, Nyquist and Nichols plot, and sensitivity"));
    m_figures->setTitle(m_step, tr("Step"), tr("The test step with friction and effort limit"));
    m_figures->setTitle(m_verification, tr("Verification"),
                        tr("Measured step over its prediction, after Apply and verify"));
    m_figures->setAccessibleName(tr("Predictions"));
    if (m_loops.hasModel()) {
        showAxis();
    }
}

void AxisTunePanel::setModel(const AxisModelFile& model) {
    m_loops.setModel(model);
    m_verified.reset();
    const QSignalBlocker quiet(m_axes);
    m_axes->clear();
    for (const std::string& id : m_loops.axes()) {
        const devices::AxisSpec* spec = m_bench.session().catalogue().findAxis(id);
        m_axes->addItem(QString::fromStdString(spec != nullptr ? spec->title : id),
                        QString::fromStdString(id));
    }
    m_axis.clear();
    onValues(); // conditions of the device
    for (const std::string& id : m_loops.axes()) {
        ask(id);
    }
    chooseAxis(m_loops.axes().front());
    showVerification();
}

void AxisTunePanel::onValues() {
    const DeviceSession& session = m_bench.session();
    if (m_isApplying || session.state() != SessionState::Connected || !isFor(session.info().model)) {
        refreshButtons();
        return;
    }
    const auto changed = m_loops.readDevice(m_bench.session().catalogue(), m_bench.deviceValues());
    if (!changed) {
        showError(changed.error());
    } else if (!m_axis.empty()) { // else setModel() asks for all of them
        for (const std::string& id : *changed) {
            AxisChoice& choice = m_loops.choice(id);
            if (choice.method == "device") {
                choice.law = m_loops.present(id);
            }
            ask(id);
        }
    }
    refreshButtons();
}

bool AxisTunePanel::isFor(const std::string& model) const {
    return m_loops.hasModel() && m_loops.model().header.device &&
           m_loops.model().header.device->model == model;
}

void AxisTunePanel::chooseAxis(const std::string& axis) {
    if (axis.empty()) {
        return;
    }
    m_axis = axis;
    const QSignalBlocker quiet(m_method);
    m_method->clear();
    for (const control::DesignMethod& method : control::axisDesignMethods()) {
        const std::string name(method.name);
        m_method->addItem(designTitle(name), QString::fromStdString(name));
    }
    for (const char* name : {"device", "edited"}) {
        m_method->addItem(designTitle(name), QString::fromLatin1(name));
    }
    const AxisChoice& choice = m_loops.choice(axis);
    m_method->setCurrentIndex(m_method->findData(QString::fromStdString(choice.method)));
    m_targets->setTargets(choice.targets);
    m_targets->showFor(m_method->currentData().toString().toStdString());
    refreshMeasured();
    showAxis();
    showVerification();
}

void AxisTunePanel::chooseMethod() {
    if (m_axis.empty()) {
        return;
    }
    AxisChoice& choice = m_loops.choice(m_axis);
    choice.method = m_method->currentData().toString().toStdString();
    choice.law.reset();
    if (choice.method == "device") {
        choice.law = m_loops.present(m_axis);
        if (!choice.law) {
            m_loops.setAnswer(m_axis, failure(ErrorCode::Refused, "the gains of the device are not known",
                                              "connect it and wait until its values are read"));
            showAxis();
            return;
        }
    } else if (choice.method == "edited") {
        choice.law = m_gains->law().value_or(LoopLaw{});
    }
    m_targets->showFor(m_method->currentData().toString().toStdString());
    takeTargets();
}

/// Only those that the method reads.
void AxisTunePanel::takeTargets() {
    m_loops.choice(m_axis).targets = m_targets->targets();
    ask(m_axis);
}

void AxisTunePanel::takeEdited(const LoopLaw& law) {
    AxisChoice& choice = m_loops.choice(m_axis);
    choice.method = "edited";
    choice.targets = {};
    choice.law = law;
    const QSignalBlocker quiet(m_method);
    m_method->setCurrentIndex(m_method->findData(QStringLiteral("edited")));
    m_targets->showFor(m_method->currentData().toString().toStdString());
    ask(m_axis);
}

void AxisTunePanel::shape(const control::CrossoverAim& aim, control::CrossoverPriority priority) {
    const auto design = m_loops.filtered(m_axis, aim, priority);
    if (!design) {
        m_sliders->sayProblem(widgets::inWords(design.error().message));
        return;
    }
    m_sliders->sayLimit(aim, *design);
    const TuneResult& proposed = (*m_loops.answer(m_axis))->proposed;
    LoopLaw law(proposed.law, proposed.filtered);
    law.law.gains = design->gains;
    if (law.filtered) {
        const std::optional<double> filter_s = law.filtered->gains.filter_s;
        law.filtered->gains = design->gains;
        law.filtered->gains.filter_s = filter_s;
    }
    takeEdited(law);
}

/// Nothing is applied that its prediction has not caught up with.
void AxisTunePanel::ask(const std::string& axis) {
    if (axis != m_axis) { // what is shown stays until its own answer
        m_loops.forgetAnswer(axis);
    }
    m_waiting.erase(std::remove(m_waiting.begin(), m_waiting.end(), axis), m_waiting.end());
    m_waiting.push_back(axis);
    askNext();
    refreshButtons();
}

void AxisTunePanel::askNext() {
    if (m_task.isBusy() || m_waiting.empty()) {
        return;
    }
    const std::string axis = m_waiting.front();
    m_waiting.erase(m_waiting.begin());
    const std::optional<AxisQuestion> question = m_loops.question(axis);
    if (!question) {
        return;
    }
    m_task.run([question = *question] { return answerAxis(question); },
               [this, axis](Result<AxisAnswer> answer) {
                   const bool isOld = std::find(m_waiting.begin(), m_waiting.end(), axis) != m_waiting.end();
                   m_loops.setAnswer(axis, std::move(answer));
                   if (axis == m_axis) {
                       showAxis();
                   }
                   if (!isOld) {
                       showVerdict();
                   }
                   askNext();
                   refreshButtons();
               });
}

void AxisTunePanel::showAxis() {
    const Result<AxisAnswer>* answer = m_loops.answer(m_axis);
    if (answer == nullptr) {
        return;
    }
    if (!*answer) {
        showVerdict();
        m_step->clear();
        refreshButtons();
        return;
    }
    const TuneResult& proposed = (*answer)->proposed;
    const LoopAxis& axis = *proposed.conditions.axis;
    if (m_loops.choice(m_axis).method != "edited" || !m_gains->isAncestorOf(focusWidget())) {
        m_gains->setLaw(LoopLaw(proposed.law, proposed.filtered), axis);
    }
    m_sliders->setLoop(m_loops.aim(m_axis), proposed.conditions.timing);
    m_loop->setLoops(proposed.predicted, (*answer)->present, {}, m_loops.measured(m_axis));
    m_step->setFigure(
        axisStepFigure(axis, proposed.predicted, (*answer)->present).value_or(widgets::Figure{}));
    showVerdict();
}

/// The worst axis sets it.
void AxisTunePanel::showVerdict() {
    showAxesVerdict(*m_verdict, m_loops.result(m_loops.axes()), m_task.isBusy() || !m_waiting.empty());
}

std::vector<std::string> AxisTunePanel::axesToApply() const {
    return m_scope->currentIndex() == 0 ? m_loops.axes() : std::vector<std::string>{m_axis};
}

void AxisTunePanel::refreshButtons() {
    const DeviceSession& session = m_bench.session();
    const bool isIdle = session.state() == SessionState::Connected && session.procedure().isEmpty();
    const auto result =
        m_loops.hasModel() ? m_loops.result(axesToApply()) : failure(ErrorCode::Refused, "", "");
    const bool isUsable = result && result->quality.verdict != Verdict::Refused;
    const bool isCurrent = m_waiting.empty() && !m_task.isBusy();
    m_apply->setEnabled(isIdle && isUsable && isCurrent && m_preflight->isPassed() && !m_isApplying);
    m_restore->setEnabled(isIdle && !m_before.empty() && !session.report().board.isArmed);
    m_gainFiles->setUsable(m_loops.hasModel(),
                           m_loops.hasModel() && isCurrent && m_loops.result(m_loops.axes()));
}

void AxisTunePanel::setFileChooser(FileChooser chooser) {
    m_response->setFileChooser(chooser);
    m_gainFiles->setFileChooser(std::move(chooser));
}

/// As `tune --gains` takes them; the judgement of everything that is proposed decides whether it is applied.
void AxisTunePanel::takeFromFile(const QString& path, const AxisGainsFile& gains) {
    const auto missing = m_loops.takeGains(gains);
    if (!missing) {
        showError(missing.error());
        return;
    }
    for (const std::string& axis : m_loops.axes()) {
        if (std::find(missing->begin(), missing->end(), axis) == missing->end()) {
            ask(axis);
        }
    }
    chooseAxis(m_axis); // its method is another now
    m_message->showMessage(AxisGainFiles::openedMessage(path, *missing));
}

void AxisTunePanel::useMeasured(std::map<std::string, MeasuredPlant> plants) {
    const std::string first = plants.empty() ? std::string() : plants.begin()->first;
    m_loops.setMeasured(std::move(plants));
    if (!m_loops.hasModel() || first.empty()) {
        refreshMeasured();
        showAxis();
        return;
    }
    if (!m_loops.isMeasured(m_axis) && m_axes->findData(QString::fromStdString(first)) >= 0) {
        m_axes->setCurrentIndex(m_axes->findData(QString::fromStdString(first)));
    }
    refreshMeasured();
    showAxis();
    const auto loop = m_loops.measured(m_axis);
    const auto used = loop ? std::count(loop->isUsed.begin(), loop->isUsed.end(), true) : 0;
    m_message->showMessage({widgets::Severity::Information,
                            tr("Measured response shown in the open loop of each axis, the others closed."),
                            loop ? tr("%1 of %2 frequencies are coherent; the others are hollow.")
                                       .arg(used)
                                       .arg(loop->isUsed.size())
                                 : QString(),
                            {}});
}

void AxisTunePanel::refreshMeasured() {
    m_forget->setVisible(m_loops.isMeasured(m_axis));
}

void AxisTunePanel::apply() {
    const auto result = m_loops.result(axesToApply());
    const auto config = result
                            ? applyAxesConfig(m_bench.session().catalogue(), m_loops.model().model, *result)
                            : failure(result.error());
    if (!config) {
        showError(config.error());
        return;
    }
    m_message->clear();
    const QPointer<AxisTunePanel> self(this);
    m_isApplying = m_bench.session().runProcedure(
        tr("Apply"),
        [config = *config](devices::Device& device, const ProcedureObserver& observer) {
            return runApplyAxes(device, config, observer);
        },
        [self](const Result<ApplyAxesResult>& applied) {
            if (self) {
                self->finishApply(applied);
            }
        });
    m_progress->setText(tr("Writing the gains"));
    m_progress->setProgress(0.0);
    m_progress->setVisible(m_isApplying);
    refreshButtons();
}

void AxisTunePanel::finishApply(const Result<ApplyAxesResult>& result) {
    m_isApplying = false;
    m_progress->hide();
    if (!result) {
        if (const auto departure = departureMessage(m_bench.session(), result.error())) {
            m_message->showMessage(*departure);
        } else if (result.error().code == ErrorCode::Interrupted) {
            m_message->showMessage(
                {widgets::Severity::Information, tr("Cancelled. Previous gains restored."), {}, {}});
        } else {
            showError(result.error());
        }
        refreshButtons();
        return;
    }
    m_verified = *result;
    if (result->isKept) {
        m_before = result->before;
        const QString done = tr("Applied, and every verification step went as predicted.");
        m_bench.session().message(MessageLevel::Info, tr("Tune"), done);
        m_message->showMessage({widgets::Severity::Success, done, {}, {}});
    } else {
        const auto& findings = result->quality.findings;
        m_message->showMessage(
            {widgets::Severity::Warning,
             tr("The gains from before run again: a verification step did not go as predicted."),
             findings.empty() ? QString() : widgets::inWords(findings.front().message),
             {}});
    }
    m_bench.refreshValues();
    showVerification();
    m_figures->setCurrent(m_verification);
    refreshButtons();
}

void AxisTunePanel::showVerification() {
    std::optional<widgets::Figure> figure;
    const bool isAny = m_verified && !m_verified->axes.empty();
    if (isAny) {
        const auto& axes = m_verified->axes;
        const auto own = std::find_if(axes.begin(), axes.end(), [this](const AxisVerification& each) {
            return each.axis.id == m_axis;
        });
        figure = axisVerificationFigure(own == axes.end() ? axes.front() : *own);
    }
    m_figures->setPageEnabled(m_verification, isAny);
    m_verification->setFigure(figure.value_or(widgets::Figure{}));
}

void AxisTunePanel::restore() {
    const QPointer<AxisTunePanel> self(this);
    m_bench.writeValues(m_before, [self](const Result<void>& written) {
        if (!self) {
            return;
        }
        if (!written) {
            self->showError(written.error());
            return;
        }
        self->m_before.clear();
        self->m_message->showMessage(
            {widgets::Severity::Information, tr("Previous gains restored."), {}, {}});
        self->refreshButtons();
    });
}

void AxisTunePanel::showError(const Error& error) {
    m_message->showMessage(
        {widgets::Severity::Error, widgets::inWords(error.message), widgets::inWords(error.hint), {}});
}

void AxisTunePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
