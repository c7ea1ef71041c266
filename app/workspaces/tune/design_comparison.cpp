#include "app/workspaces/tune/design_comparison.h"

#include "app/documents/result_documents.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/design_table.h"
#include "app/workspaces/tune/tune_session.h"
#include "control/base/assert.h"
#include "widgets/language/phrasebook.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace halbench::app {

DesignComparison::DesignComparison(Workbench& bench, const TuneSession& session, DesignTable& table,
                                   QObject* parent)
    : QObject(parent), m_bench(bench), m_session(session), m_table(table) {
    connect(&session, &TuneSession::conditionsChanged, this, &DesignComparison::judgeAnew);
    connect(&table, &DesignTable::keepRequested, this, &DesignComparison::save);
    connect(&table, &DesignTable::takeUpRequested, this, &DesignComparison::takeUpRow);
    connect(&table, &DesignTable::renameRequested, this, &DesignComparison::rename);
    connect(&table, &DesignTable::removeRequested, this, [this](int row) {
        m_designs.remove(static_cast<std::size_t>(row));
        show();
    });
    connect(&table, &DesignTable::drawRequested, this, [this](int row, bool isDrawn) {
        m_designs.draw(static_cast<std::size_t>(row), isDrawn);
        show();
    });
    connect(&table, &DesignTable::undoRequested, this, [this] {
        m_designs.undo();
        judgeMissing();
    });
    connect(&table, &DesignTable::redoRequested, this, [this] {
        m_designs.redo();
        judgeMissing();
    });
}

void DesignComparison::restore(std::vector<KeptDesign> designs) {
    m_designs.restore(std::move(designs));
    judgeMissing();
}

std::string DesignComparison::adopt(const std::string& name, std::string document) {
    const std::string adopted = m_designs.adopt(name, std::move(document));
    judgeMissing();
    return adopted;
}

std::string DesignComparison::adoptLaw(const std::string& name, const std::string& document,
                                       const LoopLaw& law) {
    const auto same = std::find_if(all().begin(), all().end(), [&](const KeptDesign& design) {
        return design.document == document || (design.gains && design.gains->loopLaw() == law);
    });
    return same != all().end() ? same->name : adopt(name, document);
}

void DesignComparison::takeUp(const std::string& name) {
    const auto found = std::find_if(all().begin(), all().end(),
                                    [&](const KeptDesign& design) { return design.name == name; });
    if (found != all().end()) {
        takeUpRow(static_cast<int>(found - all().begin()));
    }
}

void DesignComparison::takeUpRow(int row) {
    const KeptDesign& design = all().at(static_cast<std::size_t>(row));
    if (design.gains) {
        Q_EMIT takenUp(design.gains->loopLaw(), QString::fromStdString(design.name));
    }
}

/// The document is what Save gains would write.
void DesignComparison::save() {
    const auto& proposed = m_session.proposed();
    if (!proposed) {
        return;
    }
    const auto text = toJsonText(gainsDocument(m_bench.designHeader(), *proposed));
    HB_ASSERT(text.has_value()); // a result holds finite numbers only
    m_judged.insert_or_assign(*text, JudgedLoop{proposed->predicted, m_session.bandwidth_rad_s()});
    const std::size_t at = m_designs.keep(proposed->method, *text);
    show();
    m_table.editName(static_cast<int>(at));
}

void DesignComparison::rename(int row, const QString& name) {
    const auto renamed = m_designs.rename(static_cast<std::size_t>(row), name.toStdString());
    if (!renamed) {
        Q_EMIT failed(renamed.error());
    }
    show(); // with the old name, if the new one cannot be
}

/// Those that were not judged for this motor in these surroundings yet.
void DesignComparison::judgeMissing() {
    show();
    std::vector<std::pair<std::string, LoopLaw>> asked;
    for (const KeptDesign& design : all()) {
        if (design.gains && m_judged.count(design.document) + m_unjudged.count(design.document) == 0) {
            asked.emplace_back(design.document, design.gains->loopLaw());
        }
    }
    if (asked.empty() || !m_bench.identification()) {
        return;
    }
    using Judged = std::map<std::string, Result<JudgedLoop>>;
    m_judging.run(
        [asked, motor = motorEstimate(*m_bench.identification()), conditions = m_session.conditions()] {
            Judged judged;
            for (const auto& [document, law] : asked) {
                judged.insert_or_assign(document, judgeLoop(motor, law, conditions));
            }
            return judged;
        },
        [this](const Judged& judged) {
            for (const auto& [document, loop] : judged) {
                if (loop) {
                    m_judged.insert_or_assign(document, *loop);
                } else {
                    m_unjudged.insert_or_assign(document, loop.error());
                }
            }
            show();
        });
}

void DesignComparison::judgeAnew() {
    m_judging.cancel();
    m_judged.clear();
    m_unjudged.clear();
    judgeMissing();
}

/// Of a row without figures.
QString DesignComparison::reasonOf(const KeptDesign& design) const {
    if (!design.gains) {
        return tr("not assessed: project entry cannot be read");
    }
    const auto found = m_unjudged.find(design.document);
    return found == m_unjudged.end() ? tr("not assessed yet")
                                     : tr("not assessed: %1").arg(widgets::inWords(found->second.message));
}

ComparedDesign DesignComparison::rowOf(const KeptDesign& design) const {
    ComparedDesign row{design.name, {}, {}, {}, {}, design.isDrawn, reasonOf(design)};
    if (design.gains) {
        row.method = design.gains->method;
        row.gains = design.gains->law.gains;
        row.isFiltered = design.gains->filtered.has_value();
    }
    if (const auto found = m_judged.find(design.document); found != m_judged.end()) {
        row.predicted = found->second.predicted;
        row.bandwidth_rad_s = found->second.bandwidth_rad_s;
    }
    return row;
}

void DesignComparison::show() {
    std::optional<ComparedDesign> proposed;
    if (const auto& result = m_session.proposed()) {
        proposed = {{},
                    result->method,
                    result->law.gains,
                    result->predicted,
                    m_session.bandwidth_rad_s(),
                    true,
                    {},
                    result->filtered.has_value()};
    } else if (const auto& problem = m_session.problem()) {
        proposed.emplace();
        proposed->reason = tr("not assessed: %1").arg(widgets::inWords(problem->message));
    }
    std::vector<ComparedDesign> saved;
    for (const KeptDesign& design : all()) {
        saved.push_back(rowOf(design));
    }
    m_table.setDesigns(proposed, saved, m_bench.displayUnits());
    m_table.setHistory(m_designs.canUndo(), m_designs.canRedo());
    Q_EMIT shown();
}

std::vector<NamedLoop> DesignComparison::drawnLoops() const {
    std::vector<NamedLoop> loops;
    for (const KeptDesign& design : all()) {
        const auto found = m_judged.find(design.document);
        if (design.isDrawn && found != m_judged.end()) {
            loops.push_back({design.name, &found->second.predicted});
        }
    }
    return loops;
}

} // namespace halbench::app
