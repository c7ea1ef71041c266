#pragma once

#include "app/figures/loop_curves.h"
#include "app/workbench/latest_task.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/tune/saved_designs.h"
#include "app/workspaces/tune/tune_question.h"

#include <QObject>

#include <map>
#include <string>
#include <vector>

namespace halbench::app {

struct ComparedDesign;
class DesignTable;
class TuneSession;

/// Saved designs, judged for the present motor and compared with the proposed gains in a table. A worker
/// judges them. Thread: GUI.
class DesignComparison : public QObject {
    Q_OBJECT
public:
    /// `session` and `table` outlive it.
    DesignComparison(Workbench& bench, const TuneSession& session, DesignTable& table,
                     QObject* parent = nullptr);

    const std::vector<KeptDesign>& all() const { return m_designs.all(); }
    /// As a project holds them; nothing before it can be undone.
    void restore(std::vector<KeptDesign> designs);
    /// Adds one that stays whatever is undone. Returns its name.
    std::string adopt(const std::string& name, std::string document);
    /// The same unless a saved design has this document or law already. Returns the name of either.
    std::string adoptLaw(const std::string& name, const std::string& document, const LoopLaw& law);
    /// Takes up a saved design by its name; nothing without one of this name.
    void takeUp(const std::string& name);
    /// Judges all saved designs anew: for another motor or in other surroundings.
    void judgeAnew();
    /// Fills the table with the designs and the proposed gains.
    void show();
    /// Saved designs to draw beside the proposed gains; they point into this object.
    std::vector<NamedLoop> drawnLoops() const;

Q_SIGNALS:
    void shown(); ///< the table; the pictures are due
    void takenUp(const halbench::app::LoopLaw& law, const QString& name);
    void failed(const halbench::Error& error);

private:
    void save();
    void takeUpRow(int row);
    void rename(int row, const QString& name);
    void judgeMissing();
    QString reasonOf(const KeptDesign& design) const;
    ComparedDesign rowOf(const KeptDesign& design) const;

    Workbench& m_bench;
    const TuneSession& m_session;
    DesignTable& m_table;
    SavedDesigns m_designs;
    std::map<std::string, JudgedLoop> m_judged; ///< by their document
    std::map<std::string, Error> m_unjudged;    ///< likewise: why not
    LatestTask m_judging;
};

} // namespace halbench::app
