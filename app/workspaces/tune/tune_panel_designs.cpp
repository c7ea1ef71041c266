// The named designs of the Tune panel: kept, compared, drawn beside the proposed one.
#include "app/documents/result_documents.h"
#include "app/figures/disturbance_figure.h"
#include "app/figures/tuning_figures.h"
#include "app/workspaces/tune/design_table.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/tune_panel.h"
#include "control/base/assert.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"

#include <utility>

namespace halbench::app {

void TunePanel::connectDesigns() {
    connect(m_loop, &LoopView::loopsWanted, this, &TunePanel::drawPredictions);
    connect(m_table, &DesignTable::keepRequested, this, &TunePanel::keepDesign);
    connect(m_table, &DesignTable::takeUpRequested, this, &TunePanel::takeUp);
    connect(m_table, &DesignTable::removeRequested, this, [this](int kept) {
        m_designs.remove(static_cast<std::size_t>(kept));
        showDesigns();
    });
    connect(m_table, &DesignTable::renameRequested, this, [this](int kept, const QString& name) {
        const auto renamed = m_designs.rename(static_cast<std::size_t>(kept), name.toStdString());
        if (!renamed) {
            showError(renamed.error());
        }
        showDesigns(); // with the old name, if the new one cannot be
    });
    connect(m_table, &DesignTable::drawRequested, this, [this](int kept, bool isDrawn) {
        m_designs.draw(static_cast<std::size_t>(kept), isDrawn);
        showDesigns();
    });
    connect(m_table, &DesignTable::undoRequested, this, [this] {
        m_designs.undo();
        compareDesigns();
    });
    connect(m_table, &DesignTable::redoRequested, this, [this] {
        m_designs.redo();
        compareDesigns();
    });
}

void TunePanel::setSavedDesigns(std::vector<KeptDesign> designs) {
    m_designs.restore(std::move(designs));
    compareDesigns();
}

void TunePanel::adoptDesign(const std::string& name, std::string document) {
    m_designs.adopt(name, std::move(document));
    compareDesigns();
}

/// What is kept is what Save gains would write.
void TunePanel::keepDesign() {
    if (!m_shown) {
        return;
    }
    const auto text = toJsonText(gainsDocument(m_bench.designHeader(), *m_shown));
    HB_ASSERT(text.has_value()); // a result holds finite numbers only
    m_judged.insert_or_assign(*text, JudgedLoop{m_shown->predicted, m_bandwidth_rad_s});
    const std::size_t at = m_designs.keep(m_shown->method, *text);
    showDesigns();
    m_table->editName(static_cast<int>(at));
}

void TunePanel::takeUp(int kept) {
    m_shaping.reset();
    const auto& gains = m_designs.all().at(static_cast<std::size_t>(kept)).gains;
    if (!gains) {
        return;
    }
    useEdited(gains->loopLaw());
    record(tr("Use %1").arg(QString::fromStdString(m_designs.all()[static_cast<std::size_t>(kept)].name)));
    ask();
}

/// Judges what was not judged for this motor in these surroundings yet.
void TunePanel::compareDesigns() {
    showDesigns();
    std::vector<std::pair<std::string, LoopLaw>> asked;
    for (const KeptDesign& design : m_designs.all()) {
        if (design.gains && m_judged.count(design.document) + m_unjudged.count(design.document) == 0) {
            asked.emplace_back(design.document, design.gains->loopLaw());
        }
    }
    if (asked.empty() || !m_bench.identification()) {
        return;
    }
    using Judged = std::map<std::string, Result<JudgedLoop>>;
    m_comparing.run(
        [asked, motor = motorEstimate(*m_bench.identification()), conditions = m_conditions] {
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
            showDesigns();
        });
}

/// For another motor or in other surroundings every judgement is another.
void TunePanel::forgetJudgements() {
    m_comparing.cancel();
    m_judged.clear();
    m_unjudged.clear();
    compareDesigns();
}

/// Of a row without figures.
QString TunePanel::reasonOf(const KeptDesign& design) const {
    if (!design.gains) {
        return tr("not assessed: project entry cannot be read");
    }
    const auto found = m_unjudged.find(design.document);
    return found == m_unjudged.end() ? tr("not assessed yet")
                                     : tr("not assessed: %1").arg(widgets::inWords(found->second.message));
}

void TunePanel::showDesigns() {
    std::optional<ComparedDesign> proposed;
    if (m_shown) {
        proposed = {{},
                    m_shown->method,
                    m_shown->law.gains,
                    m_shown->predicted,
                    m_bandwidth_rad_s,
                    true,
                    {},
                    m_shown->filtered.has_value()};
    } else if (m_problem) {
        proposed.emplace();
        proposed->reason = tr("not assessed: %1").arg(widgets::inWords(m_problem->message));
    }
    std::vector<ComparedDesign> kept;
    for (const KeptDesign& design : m_designs.all()) {
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
        kept.push_back(std::move(row));
    }
    m_table->setDesigns(proposed, kept, m_bench.displayUnits());
    m_table->setHistory(m_designs.canUndo(), m_designs.canRedo());
    drawPredictions();
}

std::vector<NamedLoop> TunePanel::drawnLoops() const {
    std::vector<NamedLoop> loops;
    for (const KeptDesign& design : m_designs.all()) {
        const auto found = m_judged.find(design.document);
        if (design.isDrawn && found != m_judged.end()) {
            loops.push_back({design.name, &found->second.predicted});
        }
    }
    return loops;
}

/// Of the gains on the device.
const std::optional<AnalysisResult>& TunePanel::present() const {
    static const std::optional<AnalysisResult> none;
    return m_steady.present ? m_steady.present->predicted : none;
}

/// Its band belongs to the judgement, which comes after the curve.
void TunePanel::drawLoaded() {
    const bool isJudged = m_shown && m_shown->disturbance && isSameLaw(m_shown->law, m_sketch->law) &&
                          m_shown->filtered == m_sketch->filtered;
    m_loaded->setFigure(disturbanceFigure(m_sketch->loaded,
                                          m_steady.present ? m_steady.present->loaded : std::nullopt,
                                          m_bench.displayUnits().angle, DisturbanceLoad_A,
                                          isJudged ? m_shown->disturbance->band
                                                   : std::optional<control::DisturbanceEnvelope>())
                            .value_or(widgets::Figure{}));
}

void TunePanel::drawPredictions() {
    if (!m_sketch) {
        return;
    }
    const widgets::AngleUnit unit = m_bench.displayUnits().angle;
    const AnalysisResult& predicted = m_sketch->predicted;
    const std::vector<NamedLoop> others = drawnLoops();
    const std::optional<LoopUncertainty>& uncertainty = m_sketch->uncertainty;
    m_loop->setLoops(predicted, present(), others, drawnMeasurement(), uncertainty);
    m_linear->setFigure(
        linearStepFigure(predicted, present(), unit, others, uncertainty).value_or(widgets::Figure{}));
    drawLoaded();
    m_large->setFigure(
        largeStepFigure(predicted, present(), unit, others, uncertainty).value_or(widgets::Figure{}));
}

} // namespace halbench::app
