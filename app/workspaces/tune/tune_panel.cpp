#include "app/workspaces/tune/tune_panel.h"

#include "app/procedures/tune/position_law_parameters.h"
#include "app/tuning/loop_conditions.h"
#include "app/workspaces/parts/foreign_motor_notice.h"
#include "app/workspaces/parts/page_chooser.h"
#include "app/workspaces/parts/preflight.h"
#include "app/workspaces/tune/axis_tune_panel.h"
#include "app/workspaces/tune/design_names.h"
#include "app/workspaces/tune/filter_editor.h"
#include "app/workspaces/tune/gain_editor.h"
#include "app/workspaces/tune/tune_form.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/phrasebook.h"
#include "widgets/language/unbroken.h"
#include "widgets/theme/theme_style.h"

#include <QCheckBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace halbench::app {
namespace {

enum Page { EmptyPage, WorkPage };

/// Whose presets and surroundings count while no device is connected.
constexpr const char* DefaultModel = "htm";

bool isOfHistory(const QKeyEvent& key) {
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

std::string modelOf(const DeviceSession& session) {
    return session.state() == SessionState::Connected ? session.info().model : DefaultModel;
}

} // namespace

TunePanel::TunePanel(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_pages(new QStackedWidget(this)),
      m_empty(new widgets::EmptyState(m_pages)), m_message(new widgets::MessageBar(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(widgets::PanelMargin_px, widgets::PanelMargin_px, widgets::PanelMargin_px,
                               widgets::PanelMargin_px);
    column->setSpacing(widgets::PanelMargin_px);
    column->addWidget(m_pages, 1);
    m_splitter = new QSplitter(Qt::Horizontal, m_pages);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->installEventFilter(this);
    connect(m_splitter, &QSplitter::splitterMoved, this, [this] { m_isWidthChosen = true; });
    QWidget* settings = buildSettings();
    settings->setMinimumWidth(45 * fontMetrics().averageCharWidth());
    m_splitter->addWidget(settings);
    m_splitter->addWidget(buildFigures());
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_splitter);
    (new widgets::FloatingRows(*m_pages, Qt::TopEdge, this))->addRow(*m_message);
    connectParts();
    readConditions();
    onUnits();
}

void TunePanel::connectParts() {
    connect(m_empty, &widgets::EmptyState::actionTriggered, this, &TunePanel::identifyRequested);
    connectDesigns();
    createHistory();
    connectShaping();
    connect(m_form, &TuneForm::chosen, this, [this] {
        m_shaping.reset(); // a step of before that still waits does not come after it
        forgetRestored();
        recordChoice();
        ask();
    });
    connect(m_gains, &GainEditor::edited, this, [this] {
        m_shaping.reset();
        forgetRestored();
        m_form->setEdited();
        recordEdit();
        ask();
    });
    connect(m_preflight, &Preflight::changed, this, &TunePanel::refreshButtons);
    connect(m_foreign, &ForeignMotorNotice::changed, this, &TunePanel::refreshButtons);
    connect(m_apply, &QPushButton::clicked, this, &TunePanel::apply);
    connect(m_inSteps, &QCheckBox::toggled, this, [this] {
        refreshOutlook();
        refreshButtons();
    });
    connect(m_keep, &QPushButton::clicked, this, &TunePanel::keep);
    connect(m_restore, &QPushButton::clicked, this, &TunePanel::restore);
    connect(m_save, &QToolButton::clicked, this, &TunePanel::saveGains);
    connect(m_open, &QToolButton::clicked, this, &TunePanel::openGains);
    connect(m_measure, &QPushButton::clicked, this, &TunePanel::chooseMeasured);
    connectWhatIf();
    m_decision.setSingleShot(true);
    connect(&m_decision, &QTimer::timeout, this, [this] {
        refreshButtons();
        if (m_figures->isAncestorOf(focusWidget())) { // else it went elsewhere meanwhile
            focusNext();
        }
    });
    connect(m_progress, &widgets::ProgressRow::cancelRequested, &m_bench.session(),
            &DeviceSession::abortProcedure);
    connect(&m_bench, &Workbench::identificationChanged, this, [this] {
        forgetVerification(); // it was predicted for the motor as it was
        refreshModel();
        restartHistory();
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
    connect(&m_bench.session(), &DeviceSession::procedureChanged, this, &TunePanel::refreshButtons);
    connect(&m_bench.session(), &DeviceSession::reportChanged, this, &TunePanel::refreshButtons); // armed?
    connect(&m_bench.session(), &DeviceSession::procedureProgress, this,
            [this](double fraction, const QString& text) {
                if (m_isApplying) {
                    m_progress->setText(tr("Verification: %1").arg(widgets::inWords(text)));
                    m_progress->setProgress(fraction);
                }
            });
}

/// What was applied, measured and said is of one device: of the one that is connected, looked for, or held
/// while a recording is open.
void TunePanel::onDevice() {
    const DeviceSession& session = m_bench.session();
    const std::uint64_t device = session.state() == SessionState::Lost ? 0 : session.deviceNumber();
    if (std::exchange(m_deviceNumber, device) != device) {
        m_before.clear(); // nothing of another one was replaced
        if (m_axes != nullptr) {
            m_axes->useMeasured({});
        }
        leaveGains();
        forgetVerification();
    }
    refreshEmpty();
    showPage();
    m_filters->setOffered(session.state() == SessionState::Connected
                              ? std::optional(boardLawSpec(session.catalogue()))
                              : std::nullopt);
    refreshOutlook(); // of its limits
    readConditions();
    ask(); // its presets may be others
}

/// One loop or several, by the device; without an identification there is nothing to tune.
void TunePanel::showPage() {
    const bool areSeveral =
        m_bench.session().state() == SessionState::Connected && m_bench.session().catalogue().axes.size() > 1;
    if (areSeveral && m_axes != nullptr && m_axes->isFor(m_bench.session().info().model)) {
        m_pages->setCurrentWidget(m_axes);
    } else {
        m_pages->setCurrentIndex(m_bench.identification() && !areSeveral ? WorkPage : EmptyPage);
    }
}

void TunePanel::useAxisModel(const AxisModelFile& model) {
    axisPanel().setModel(model);
    showPage();
}

AxisTunePanel& TunePanel::axisPanel() {
    if (m_axes == nullptr) {
        m_axes = new AxisTunePanel(m_bench, m_pages);
        m_axes->setFileChooser(m_chooser);
        m_pages->addWidget(m_axes);
    }
    return *m_axes;
}

void TunePanel::useMeasuredAxes(const AxesFrequencyResult& response) {
    axisPanel().useMeasured(measuredPlants(response));
}

void TunePanel::refreshModel() {
    const auto& identification = m_bench.identification();
    showPage();
    if (m_bench.provenance().origin != ResultOrigin::Project) {
        forgetRestored(); // they were for another motor
    }
    m_shown.reset(); // it was proposed for the motor before
    m_shaping.reset();
    forgetJudgements();
    if (!identification) {
        m_sketch.reset();
        m_asked.reset();
        m_rest.stop();
        m_sketching.cancel();
        m_judging.cancel();
        m_spreading.cancel();
        showShape();
        refreshButtons();
        return;
    }
    const auto words = [&](const char* ratio, const QString& symbol) {
        const auto found = identification->ratios.find(ratio);
        if (found == identification->ratios.end() || !found->second.value) {
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
    m_model->setText(tr("Motor (SI, 95 %): %1").arg(parts.join(QStringLiteral(", "))));
    readConditions(); // without a device they are those of the model
    ask();
}

/// Asks anew only when the surroundings or the gains on the device changed: many values are read often.
void TunePanel::readConditions() {
    if (m_isApplying) {
        return; // what is written now is decided when it is verified
    }
    DeviceSession& session = m_bench.session();
    m_form->setModel(modelOf(session));
    LoopConditions conditions = m_conditions;
    if (session.state() == SessionState::Connected) {
        conditions = loopConditionsOf(session.catalogue(), m_bench.deviceValues());
    } else if (const auto known = loopConditionsOf(DefaultModel)) {
        conditions = *known;
        const auto& identification = m_bench.identification();
        conditions.timing =
            timingOr(identification ? identification->timing : MeasuredTiming{}, conditions.timing);
    }
    const auto present = loopLawFromParameters(valuesBefore(), conditions.timing.period_s);
    const auto law = present ? std::optional(*present) : std::nullopt;
    if (conditions != m_conditions || law != m_presentLaw || m_form->origin() == TuneForm::Origin::Device) {
        const bool isElsewhere = conditions != m_conditions;
        m_conditions = conditions;
        m_presentLaw = law;
        if (isElsewhere) {
            forgetJudgements();
        }
        ask();
    }
}

/// What runs on the device, or ran there before an apply that is not decided yet.
std::map<std::string, double> TunePanel::valuesBefore() const {
    std::map<std::string, double> values = m_bench.deviceValues();
    for (const ParameterValue& old : m_before) {
        values[old.name] = old.value;
    }
    return values;
}

/// Where no method designs it.
Result<LoopLaw> TunePanel::chosenLaw() const {
    if (m_form->origin() == TuneForm::Origin::Edited) {
        return editedLaw();
    }
    if (m_form->origin() == TuneForm::Origin::Device) {
        return loopLawFromParameters(m_bench.deviceValues(), m_conditions.timing.period_s);
    }
    const auto law = presetLaw(modelOf(m_bench.session()), m_form->method());
    return law ? Result<LoopLaw>(*law) : failure(law.error());
}

std::optional<TuneQuestion> TunePanel::question() {
    TuneQuestion question;
    question.motor = motorEstimate(*m_bench.identification());
    question.config.method = m_form->method();
    question.config.conditions = m_conditions;
    if (m_bench.session().state() == SessionState::Connected && !m_bench.deviceValues().empty()) {
        if (const auto fits = checkTimingOfModel(question.motor.timing, m_conditions.timing); !fits) {
            showProblem(fits.error());
            return std::nullopt;
        }
    }
    takeStrayInterval(question.config.conditions, m_bench.strayInterval95_T_per_A());
    question.config.conditions.doubts = m_bench.calibrationDoubts();
    question.present = m_presentLaw;
    question.record = m_record;
    question.known = m_steady;
    if (m_restored) {
        question.config.method = m_restored->method;
        question.config.targets = m_restored->targets;
        question.law = m_restored->loopLaw();
        return question;
    }
    const auto targets = m_form->targets();
    if (!targets) {
        showProblem(targets.error());
        return std::nullopt;
    }
    question.config.targets = *targets;
    if (m_form->origin() == TuneForm::Origin::Method) {
        return question;
    }
    const auto law = chosenLaw();
    if (!law) {
        showProblem(law.error());
        return std::nullopt;
    }
    question.law = *law;
    return question;
}

void TunePanel::ask() {
    if (!m_bench.identification()) {
        return;
    }
    m_problem.reset();
    m_shown.reset(); // nothing is applied that its prediction has not caught up with
    m_rest.stop();
    m_sketching.cancel();
    m_judging.cancel(); // answers to older numbers must not come after a number that is none
    m_spreading.cancel();
    m_replaying.cancel();
    m_whatIfSpread.reset();
    m_asked = question();
    if (m_asked) {
        m_sketching.run([asked = *m_asked] { return sketchTuning(asked); },
                        [this](Result<TuneSketch> sketch) { showSketch(std::move(sketch)); });
    }
    refreshButtons();
}

/// After the sketch: what can be applied must not come before the gains and curves it belongs to are seen.
void TunePanel::judge() {
    m_rest.stop();
    if (!m_asked) {
        return;
    }
    m_judging.run(
        [asked = *m_asked] {
            auto answer = answerTuning(asked);
            const auto loop = answer ? judgeLoop(asked.motor, answer->law, asked.config.conditions)
                                     : failure(answer.error());
            return Answer(std::move(answer), loop ? loop->bandwidth_rad_s : std::nullopt);
        },
        [this](const Answer& answer) { showAnswer(answer.first, answer.second); });
}

void TunePanel::restoreDesign(std::optional<GainsFile> gains) {
    m_shaping.reset();
    forgetRestored();
    forgetVerification(); // of the project before
    forgetMeasured();
    forgetRecording();
    m_restored = std::move(gains);
    const GainsFile shown = m_restored.value_or(GainsFile{});
    m_form->showChoice(m_restored ? shown.method : TuneConfig().method, shown.targets);
    if (m_restored) {
        m_gains->setLaw(shown.law);
        m_filters->setShaping(shown.filtered);
        m_message->showMessage({widgets::Severity::Information,
                                tr("Gains from the project: %1.").arg(designTitle(shown.method)),
                                tr("Choose a method to design new gains for the present motor model."),
                                {}});
    }
    restartHistory();
    ask();
}

void TunePanel::forgetRestored() {
    if (m_restored) {
        m_restored.reset();
        m_message->clear();
    }
}

/// The settings keep their smallest width, the pictures get the rest: enough for two where there is room.
void TunePanel::shareWidth() {
    if (!m_isWidthChosen) {
        m_splitter->setSizes({m_splitter->widget(0)->minimumWidth(), m_splitter->width()});
    }
}

/// Shared once the splitter has given its parts their places: whoever arranges docks has set its stretch.
bool TunePanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_splitter && event->type() == QEvent::Resize) {
        QMetaObject::invokeMethod(this, &TunePanel::shareWidth, Qt::QueuedConnection);
    } else if (m_verificationRoom != nullptr && watched == m_verificationRoom->viewport()) {
        if (event->type() == QEvent::Resize) {
            growVerification();
        } else if (event->type() == QEvent::Show) {
            drawVerification(); // the gains may be others by now
        }
    } else if (event->type() == QEvent::ShortcutOverride && isOfHistory(static_cast<QKeyEvent&>(*event))) {
        event->ignore(); // else a number field takes the key for its own text
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void TunePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
