#pragma once

#include "app/workbench/workbench.h"
#include "app/workspaces/tune/loop/gain_history_actions.h"
#include "app/workspaces/tune/tune_session.h"

#include <QWidget>

#include <optional>
#include <string>

namespace halbench::app {

class FilterEditor;
class GainEditor;
class LoopSliders;
class TuneForm;
class TuneMessages;

/// Settings of the proposed gains: loop sliders, source, gains and filters, and the undo and redo of their
/// changes. Gains restored from a project stay as they are until others are chosen. Thread: GUI.
class GainSettings : public QWidget {
    Q_OBJECT
public:
    /// All of them outlive it.
    GainSettings(Workbench& bench, const TuneSession& session, TuneMessages& messages,
                 QWidget* parent = nullptr);

    /// Errors: InvalidInput naming the field; of loopLawFromParameters and presetLaw.
    Result<GainSource> source() const;
    bool isEdited() const;
    bool isOfDevice() const;
    /// Law in the fields of gains and filters. Errors: InvalidInput naming the field.
    Result<LoopLaw> editedLaw() const;
    /// The project's gains that are shown as they are.
    const std::optional<GainsFile>& restored() const { return m_restored; }

    /// Offers the presets of the present actuator.
    void refreshModel();
    /// Offers the weights and filters that the law of the connected device has.
    void refreshDevice();
    void refreshUnits();
    /// Shows a law that the source gave; edited gains stay.
    void showLaw(const LoopLaw& law);
    /// Makes a law the edited gains, without changed().
    void edit(const LoopLaw& law);
    /// The same as one change by the user.
    void take(const LoopLaw& law, const QString& what);
    /// A method with its targets, as if the user had chosen it.
    void choose(const std::string& method, const control::DesignTargets& targets);
    /// The project's gains; none: the first method.
    void restore(std::optional<GainsFile> gains);
    void forgetRestored();
    /// Adds what was done to the history; as of GainHistory.
    void record(const QString& what, const QString& key = {});
    void restartHistory();

    LoopSliders& sliders() { return *m_sliders; }
    GainHistoryActions& history() { return m_history; }
    void focusSource();

Q_SIGNALS:
    void changed();  ///< by the user, also undone or redone: other gains are proposed
    void recorded(); ///< a step of the history; before changed()

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectParts();
    Result<LoopLaw> givenLaw() const;
    void fill(const LoopLaw& law);
    void takeSource();
    void takeGains();
    void takeFilters(const QString& what, bool isTyped);
    void goTo(const GainChoice& choice);
    GainChoice choiceNow() const;

    Workbench& m_bench;
    const TuneSession& m_session;
    TuneMessages& m_messages;
    TuneForm* m_form;
    GainEditor* m_gains;
    FilterEditor* m_filters; ///< around the same gains
    LoopSliders* m_sliders;
    GainHistoryActions m_history;
    std::optional<GainsFile> m_restored;
};

} // namespace halbench::app
