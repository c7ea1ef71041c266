// What was done to the proposed gains in the Tune panel, taken back and done again.
#include "app/procedures/tune/position_law_parameters.h"
#include "app/workspaces/tune/loop/design_names.h"
#include "app/workspaces/tune/loop/filter_editor.h"
#include "app/workspaces/tune/loop/gain_editor.h"
#include "app/workspaces/tune/loop/loop_sliders.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "app/workspaces/tune/tune_panel.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QApplication>

namespace halbench::app {

void TunePanel::createHistory() {
    const std::pair<const char*, const char*> kinds[] = {{"undo", "Ctrl+Z"}, {"redo", "Ctrl+Shift+Z"}};
    for (const auto& [icon, key] : kinds) {
        auto* action = new QAction(widgets::themedIcon(QLatin1String(icon)), QString(), this);
        action->setShortcut(QKeySequence(QLatin1String(key)));
        action->setShortcutContext(
            Qt::WidgetWithChildrenShortcut); // other panels have histories of their own
        addAction(action);
        m_historyActions << action;
    }
    connect(m_historyActions.front(), &QAction::triggered, this, [this] { goTo(m_history.undo()); });
    connect(m_historyActions.back(), &QAction::triggered, this, [this] { goTo(m_history.redo()); });
    m_sliders->setHistory(*m_historyActions.front(), *m_historyActions.back());
    for (auto* field : findChildren<widgets::OptionalNumberEdit*>()) {
        field->installEventFilter(this);
    }
    connectFilters();
    restartHistory();
}

void TunePanel::connectFilters() {
    connect(m_filters, &FilterEditor::fieldAdded, this,
            [this](QWidget* field) { field->installEventFilter(this); });
    connect(m_filters, &FilterEditor::edited, this, [this](const QString& what, bool isTyped) {
        m_shaping.reset();
        forgetRestored();
        m_form->setEdited();
        if (editedLaw()) {
            m_sliders->sayProblem({});
            record(what, isTyped ? what : QString());
        }
        ask();
    });
}

/// A method is run again where the same gains come from it; those of a device may not be the same any more.
GainChoice TunePanel::choiceNow() const {
    GainChoice choice{m_form->method(), {}, {}, m_restored};
    if (m_restored) {
        return choice;
    }
    choice.targets = m_form->targets().value_or(control::DesignTargets{});
    const bool isOfDevice = m_form->origin() == TuneForm::Origin::Device;
    if (isOfDevice || m_form->origin() == TuneForm::Origin::Edited) {
        choice.law = (isOfDevice ? loopLawFromParameters(m_bench.deviceValues(), m_conditions.timing.period_s)
                                 : editedLaw())
                         .value_or(LoopLaw{});
    }
    return choice;
}

void TunePanel::record(const QString& what, const QString& key) {
    m_history.record(what, key, choiceNow());
    if (m_before.empty()) { // else what was applied is still to be decided
        forgetToldOfDevice();
    }
    refreshHistory();
}

void TunePanel::recordChoice() {
    m_sliders->sayProblem({});
    if (m_form->targets()) { // else it is being typed
        record(tr("Gain source: %1").arg(designTitle(m_form->method())),
               QString::fromStdString(m_form->method()));
    }
}

/// What is typed into one field is one step.
void TunePanel::recordEdit() {
    const auto* field = qobject_cast<widgets::OptionalNumberEdit*>(QApplication::focusWidget());
    if (editedLaw()) {
        m_sliders->sayProblem({});
        const QString name = field == nullptr ? QString() : field->accessibleName();
        record(name.isEmpty() ? tr("Edit the gains") : tr("Edit %1").arg(name), name);
    }
}

void TunePanel::restartHistory() {
    m_history.restart(choiceNow());
    refreshHistory();
}

void TunePanel::goTo(const GainChoice& choice) {
    m_shaping.reset();
    m_sliders->sayProblem({});
    forgetRestored();
    m_restored = choice.restored;
    m_form->showChoice(choice.origin, m_restored ? m_restored->targets : choice.targets);
    if (m_form->origin() == TuneForm::Origin::Device) {
        m_form->setEdited();
    }
    const LoopLaw law = m_restored ? m_restored->loopLaw() : choice.law;
    if (m_restored || m_form->origin() == TuneForm::Origin::Edited) {
        m_gains->setLaw(law.law);
        m_filters->setShaping(law.filtered);
    }
    refreshHistory();
    ask();
}

void TunePanel::refreshHistory() {
    const std::pair<QString, QString> words[] = {{tr("&Undo"), m_history.undoName()},
                                                 {tr("&Redo"), m_history.redoName()}};
    for (int i = 0; i < m_historyActions.size(); ++i) {
        const auto& [verb, what] = words[i];
        QAction& action = *m_historyActions[i];
        action.setText(what.isEmpty() ? verb : QStringLiteral("%1: %2").arg(verb, what));
        action.setEnabled(!what.isEmpty());
        action.setToolTip(QStringLiteral("%1 (%2)").arg(
            action.text().remove('&'), action.shortcut().toString(QKeySequence::NativeText)));
    }
}

} // namespace halbench::app
