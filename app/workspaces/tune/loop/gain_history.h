#pragma once

#include "app/documents/model_file.h"
#include "control/design/design_methods.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// Origin of the gains of the Tune panel, from which they can be made again.
struct GainChoice {
    std::string origin; ///< id of TuneForm: a method, a preset, "edited"
    control::DesignTargets targets = {};
    LoopLaw law = {};                       ///< of gains that were edited
    std::optional<GainsFile> restored = {}; ///< of the project, shown as they are

    bool isSameAs(const GainChoice& other) const;
};

/// What was done to the proposed gains, undone and redone in order. Nothing here reaches a device. Thread:
/// any one.
class GainHistory {
public:
    /// Nothing before it can be undone.
    void restart(GainChoice now);
    /// `what` is said to people: "Edit K_P". A change with the same key as the one before adds to its step,
    /// unless the key is empty; one that changes nothing is none.
    void record(const QString& what, const QString& key, GainChoice now);

    bool canUndo() const { return m_done > 0; }
    bool canRedo() const { return m_done < m_steps.size(); }
    /// Empty when there is nothing.
    QString undoName() const { return canUndo() ? m_steps[m_done - 1].what : QString(); }
    QString redoName() const { return canRedo() ? m_steps[m_done].what : QString(); }
    /// What the gains come from then. There must be something to undo or redo.
    const GainChoice& undo();
    const GainChoice& redo();

private:
    struct Step {
        QString what;
        QString key;
        GainChoice before;
        GainChoice after;
    };
    GainChoice m_now;
    std::vector<Step> m_steps;
    std::size_t m_done = 0; ///< those behind it were undone
};

} // namespace halbench::app
