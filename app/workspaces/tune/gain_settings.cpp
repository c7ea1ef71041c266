#include "app/workspaces/tune/gain_settings.h"

#include "app/procedures/tune/position_law_parameters.h"
#include "app/workspaces/tune/loop/design_names.h"
#include "app/workspaces/tune/loop/filter_editor.h"
#include "app/workspaces/tune/loop/gain_editor.h"
#include "app/workspaces/tune/loop/loop_sliders.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "app/workspaces/tune/tune_messages.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QVBoxLayout>

#include <initializer_list>
#include <utility>

namespace halbench::app {
namespace {

bool isOfHistory(const QKeyEvent& key) {
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

} // namespace

GainSettings::GainSettings(Workbench& bench, const TuneSession& session, TuneMessages& messages,
                           QWidget* parent)
    : QWidget(parent), m_bench(bench), m_session(session), m_messages(messages), m_form(new TuneForm(this)),
      m_gains(new GainEditor(this)), m_filters(new FilterEditor(this)), m_sliders(new LoopSliders(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::GroupSpacing_px);
    for (QWidget* part : std::initializer_list<QWidget*>{m_sliders, m_form, m_gains, m_filters}) {
        column->addWidget(part);
    }
    m_sliders->setHistory(m_history.undo(), m_history.redo());
    connectParts();
    restartHistory();
}

void GainSettings::connectParts() {
    connect(m_form, &TuneForm::chosen, this, &GainSettings::takeSource);
    connect(m_gains, &GainEditor::edited, this, &GainSettings::takeGains);
    connect(m_filters, &FilterEditor::edited, this, &GainSettings::takeFilters);
    connect(&m_history, &GainHistoryActions::chosen, this, &GainSettings::goTo);
    for (auto* field : findChildren<widgets::OptionalNumberEdit*>()) {
        field->installEventFilter(this);
    }
    connect(m_filters, &FilterEditor::fieldAdded, this,
            [this](QWidget* field) { field->installEventFilter(this); });
}

Result<GainSource> GainSettings::source() const {
    if (m_restored) {
        return GainSource{m_restored->method, m_restored->targets, m_restored->loopLaw()};
    }
    const auto targets = m_form->targets();
    if (!targets) {
        return failure(targets.error());
    }
    GainSource source{m_form->method(), *targets};
    if (m_form->origin() == TuneForm::Origin::Method) {
        return source;
    }
    const auto law = givenLaw();
    if (!law) {
        return failure(law.error());
    }
    source.law = *law;
    return source;
}

/// Where no method designs it.
Result<LoopLaw> GainSettings::givenLaw() const {
    if (isEdited()) {
        return editedLaw();
    }
    if (isOfDevice()) {
        return loopLawFromParameters(m_bench.deviceValues(), m_session.conditions().timing.period_s);
    }
    const auto law = presetLaw(m_session.model(), m_form->method());
    return law ? Result<LoopLaw>(*law) : failure(law.error());
}

bool GainSettings::isEdited() const {
    return m_form->origin() == TuneForm::Origin::Edited;
}

bool GainSettings::isOfDevice() const {
    return m_form->origin() == TuneForm::Origin::Device;
}

Result<LoopLaw> GainSettings::editedLaw() const {
    const auto law = m_gains->law();
    if (!law) {
        return failure(law.error());
    }
    auto filtered = m_filters->filtered(law->gains);
    return filtered ? Result<LoopLaw>(LoopLaw(*law, *std::move(filtered))) : failure(filtered.error());
}

void GainSettings::refreshModel() {
    m_form->setModel(m_session.model());
}

void GainSettings::refreshDevice() {
    const DeviceSession& session = m_bench.session();
    m_filters->setOffered(session.state() == SessionState::Connected
                              ? std::optional(boardLawSpec(session.catalogue()))
                              : std::nullopt);
}

void GainSettings::refreshUnits() {
    m_gains->setAngleUnit(m_bench.displayUnits().angle);
    m_filters->setFrequencyUnit(m_bench.displayUnits().frequency);
}

void GainSettings::showLaw(const LoopLaw& law) {
    if (!isEdited()) {
        fill(law);
    }
}

void GainSettings::fill(const LoopLaw& law) {
    m_gains->setLaw(law.law);
    m_filters->setShaping(law.filtered);
}

void GainSettings::edit(const LoopLaw& law) {
    forgetRestored();
    m_form->setEdited();
    fill(law);
}

void GainSettings::take(const LoopLaw& law, const QString& what) {
    edit(law);
    record(what);
    Q_EMIT changed();
}

void GainSettings::choose(const std::string& method, const control::DesignTargets& targets) {
    m_form->choose(method, targets);
}

void GainSettings::restore(std::optional<GainsFile> gains) {
    forgetRestored();
    m_restored = std::move(gains);
    const GainsFile shown = m_restored.value_or(GainsFile{});
    m_form->showChoice(m_restored ? shown.method : TuneConfig().method, shown.targets);
    if (m_restored) {
        fill(shown.loopLaw());
        m_messages.show({widgets::Severity::Information,
                         tr("Gains from the project: %1.").arg(designTitle(shown.method)),
                         tr("Choose a method to design new gains for the present motor model."),
                         {}});
    }
    restartHistory();
}

void GainSettings::forgetRestored() {
    if (m_restored) {
        m_restored.reset();
        m_messages.clear();
    }
}

void GainSettings::takeSource() {
    forgetRestored();
    m_sliders->sayProblem({});
    if (m_form->targets()) { // else it is being typed
        record(tr("Gain source: %1").arg(designTitle(m_form->method())),
               QString::fromStdString(m_form->method()));
    }
    Q_EMIT changed();
}

/// What is typed into one field is one step.
void GainSettings::takeGains() {
    forgetRestored();
    m_form->setEdited();
    const auto* field = qobject_cast<widgets::OptionalNumberEdit*>(QApplication::focusWidget());
    if (editedLaw()) {
        m_sliders->sayProblem({});
        const QString name = field == nullptr ? QString() : field->accessibleName();
        record(name.isEmpty() ? tr("Edit the gains") : tr("Edit %1").arg(name), name);
    }
    Q_EMIT changed();
}

void GainSettings::takeFilters(const QString& what, bool isTyped) {
    forgetRestored();
    m_form->setEdited();
    if (editedLaw()) {
        m_sliders->sayProblem({});
        record(what, isTyped ? what : QString());
    }
    Q_EMIT changed();
}

/// A method is run again where the same gains come from it; those of a device may not be the same any more.
GainChoice GainSettings::choiceNow() const {
    GainChoice choice{m_form->method(), {}, {}, m_restored};
    if (m_restored) {
        return choice;
    }
    choice.targets = m_form->targets().value_or(control::DesignTargets{});
    if (isOfDevice() || isEdited()) {
        choice.law = givenLaw().value_or(LoopLaw{});
    }
    return choice;
}

void GainSettings::record(const QString& what, const QString& key) {
    m_history.record(what, key, choiceNow());
    Q_EMIT recorded();
}

void GainSettings::restartHistory() {
    m_history.restart(choiceNow());
}

void GainSettings::goTo(const GainChoice& choice) {
    m_sliders->sayProblem({});
    forgetRestored();
    m_restored = choice.restored;
    m_form->showChoice(choice.origin, m_restored ? m_restored->targets : choice.targets);
    if (isOfDevice()) {
        m_form->setEdited();
    }
    if (m_restored || isEdited()) {
        fill(m_restored ? m_restored->loopLaw() : choice.law);
    }
    Q_EMIT changed();
}

void GainSettings::focusSource() {
    m_form->setFocus(Qt::OtherFocusReason);
}

bool GainSettings::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isOfHistory(static_cast<QKeyEvent&>(*event))) {
        event->ignore(); // else a number field takes the key for its own text
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void GainSettings::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        m_history.refreshTexts();
    }
}

} // namespace halbench::app
