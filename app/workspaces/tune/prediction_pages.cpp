#include "app/workspaces/tune/prediction_pages.h"

#include "app/figures/disturbance_figure.h"
#include "app/figures/tuning_figures.h"
#include "app/workspaces/tune/design_table.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/measured_overlay.h"
#include "app/workspaces/tune/tune_numbers.h"
#include "app/workspaces/tune/tune_session.h"
#include "widgets/figure/figure_view.h"

namespace halbench::app {

PredictionPages::PredictionPages(Workbench& bench, const TuneSession& session, QWidget* parent)
    : PageChooser(parent), m_bench(bench), m_session(session), m_loop(new LoopView(this)),
      m_measured(new MeasuredOverlay(session, m_loop)), m_large(new widgets::FigureView(this)),
      m_linear(new widgets::FigureView(this)), m_disturbance(new widgets::FigureView(this)),
      m_numbers(new TuneNumbers(this)), m_designs(new DesignTable(this)) {
    m_loop->addTool(*m_measured);
}

void PredictionPages::addPages(const std::vector<QWidget*>& further) {
    std::vector<QWidget*> pages = {m_loop, m_large, m_linear, m_disturbance, m_numbers, m_designs};
    pages.insert(pages.end(), further.begin(), further.end());
    for (QWidget* page : pages) {
        addPage(page);
    }
    constexpr int CharactersOfAPicture = 52; // less squeezes its axes
    pairWhenWide(m_loop, m_large, 2 * CharactersOfAPicture * fontMetrics().averageCharWidth());
}

void PredictionPages::draw(const std::vector<NamedLoop>& others) {
    const auto& sketch = m_session.sketch();
    if (!sketch) {
        return;
    }
    const widgets::AngleUnit unit = m_bench.displayUnits().angle;
    const AnalysisResult& predicted = sketch->predicted;
    const std::optional<AnalysisResult>& present = m_session.present();
    const std::optional<LoopUncertainty>& uncertainty = sketch->uncertainty;
    m_loop->setLoops(predicted, present, others, m_measured->loop(), uncertainty);
    m_linear->setFigure(
        linearStepFigure(predicted, present, unit, others, uncertainty).value_or(widgets::Figure{}));
    drawDisturbance();
    m_large->setFigure(
        largeStepFigure(predicted, present, unit, others, uncertainty).value_or(widgets::Figure{}));
}

/// Its band belongs to the judgement, which comes after the curve.
void PredictionPages::drawDisturbance() {
    const auto& sketch = m_session.sketch();
    if (!sketch) {
        return;
    }
    const auto& proposed = m_session.proposed();
    const bool isJudged = proposed && proposed->disturbance && isSameLaw(proposed->law, sketch->law) &&
                          proposed->filtered == sketch->filtered;
    const auto& present = m_session.steady().present;
    m_disturbance->setFigure(disturbanceFigure(sketch->loaded, present ? present->loaded : std::nullopt,
                                               m_bench.displayUnits().angle, DisturbanceLoad_A,
                                               isJudged ? proposed->disturbance->band
                                                        : std::optional<control::DisturbanceEnvelope>())
                                 .value_or(widgets::Figure{}));
}

void PredictionPages::showNumbers() {
    if (const auto& proposed = m_session.proposed()) {
        m_numbers->setNumbers(tuneNumbers(*proposed, m_session.present(), m_bench.displayUnits()));
    }
}

void PredictionPages::refreshTexts() {
    setTitle(m_loop, tr("Open loop"), tr("Bode, Nyquist and Nichols plot, and sensitivity"));
    setTitle(m_large, tr("Step of %1").arg(angleText(LargeStep_rad, m_bench.displayUnits())),
             tr("A large step with friction and current limit"));
    setTitle(m_linear, tr("Small step"), tr("Step of the linear loop"));
    setTitle(m_disturbance, tr("Disturbance"), tr("Effect of a load step on the angle"));
    setTitle(m_numbers, tr("Numbers"), tr("All predicted figures, margins with intervals"));
    setTitle(m_designs, tr("Designs"), tr("Saved designs, compared with the proposed gains"));
    setAccessibleName(tr("Predictions"));
}

std::vector<widgets::FigureView*> PredictionPages::pictures() const {
    return {&m_loop->picture(), m_large, m_linear, m_disturbance};
}

} // namespace halbench::app
