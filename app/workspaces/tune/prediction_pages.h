#pragma once

#include "app/figures/loop_curves.h"
#include "app/workbench/workbench.h"
#include "app/workspaces/parts/page_chooser.h"

#include <vector>

namespace halbench::widgets {
class FigureView;
}

namespace halbench::app {

class DesignTable;
class LoopView;
class MeasuredOverlay;
class TuneNumbers;
class TuneSession;

/// Pages with the predictions of the proposed gains: open loop, large and small step, disturbance, numbers,
/// and the table of designs. Thread: GUI.
class PredictionPages : public PageChooser {
    Q_OBJECT
public:
    /// `session` outlives it.
    PredictionPages(Workbench& bench, const TuneSession& session, QWidget* parent = nullptr);

    /// Adds its own pages, then these, whose parent it is.
    void addPages(const std::vector<QWidget*>& further);
    /// All pictures; `others`: saved designs beside the proposed gains.
    void draw(const std::vector<NamedLoop>& others);
    void drawDisturbance();
    void showNumbers();
    void refreshTexts();

    LoopView& loop() { return *m_loop; }
    MeasuredOverlay& measured() { return *m_measured; }
    TuneNumbers& numbers() { return *m_numbers; }
    DesignTable& designs() { return *m_designs; }
    std::vector<widgets::FigureView*> pictures() const;

private:
    Workbench& m_bench;
    const TuneSession& m_session;
    LoopView* m_loop;
    MeasuredOverlay* m_measured; ///< in the open loop
    widgets::FigureView* m_large;
    widgets::FigureView* m_linear;
    widgets::FigureView* m_disturbance;
    TuneNumbers* m_numbers;
    DesignTable* m_designs;
};

} // namespace halbench::app
