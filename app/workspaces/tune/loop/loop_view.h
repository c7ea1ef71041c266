#pragma once

#include "app/figures/tuning_figures.h"
#include "app/workbench/display_quantity.h"
#include "control/analysis/locus_gain.h"
#include "widgets/figure/figure_handle.h"

#include <QWidget>

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;

namespace halbench::widgets {
class FigureView;
} // namespace halbench::widgets

namespace halbench::app {

/// The open loop as the user wants to see it: Bode, Nyquist, Nichols, its sensitivity or its root locus. In
/// Bode its crossover and its phase margin can be moved, in the root locus the poles of the closed loop along
/// their branches; it only asks, whoever owns it changes the loop. The frequency that is read stays from view
/// to view, and its phase is drawn whole or, where that is chosen, within +-180 degrees. Only the picture of
/// the chosen view is made: another view asks for the loops again.
class LoopView : public QWidget {
    Q_OBJECT
public:
    enum class View { Bode, Nyquist, Nichols, Sensitivity, RootLocus };

    explicit LoopView(QWidget* parent = nullptr);

    void setLoops(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                  const std::vector<NamedLoop>& others,
                  const std::optional<MeasuredLoop>& measured = std::nullopt, ///< in Bode, Nyquist, Nichols
                  const std::optional<LoopUncertainty>& uncertainty = std::nullopt); ///< in the Bode plot
    void setView(View view);
    /// A control of whoever owns this, beside the choice of the view.
    void addTool(QWidget& tool);
    void setFrequencyUnit(FrequencyUnit unit); ///< of the axes; handles and signals stay in rad/s
    widgets::FigureView& picture() { return *m_picture; }

Q_SIGNALS:
    void loopsWanted(); ///< another view was chosen: its picture is made by setLoops()
    void taken();
    void released();
    void crossoverMoved(double crossover_rad_s); ///< between taken() and released(), or by itself
    void phaseMarginMoved(double phaseMargin_deg);
    void gainMoved(double factor); ///< on the gains as they were when a pole was taken

protected:
    void changeEvent(QEvent* event) override;

private:
    static constexpr int Views = 5;
    /// What is known of the predicted loop where it can be taken.
    struct Grips {
        control::StabilityMargins margins;
        double phase_deg = 0.0; ///< at the gain crossover, as the picture has it
        control::RootLocus locus;
        control::LocusLoop loop;                 ///< of the locus
        std::vector<std::complex<double>> poles; ///< of the closed loop, those that are handles
    };
    void sayWords();
    void show();
    void choose();
    widgets::Figure shown() const;
    void connectHandles();
    void findGrips(const AnalysisResult& predicted);
    void take();
    void move(int handle, double x, double y);
    void step(int handle, int steps);
    std::vector<widgets::FigureHandle> handlesOf(View view) const;
    View view() const;

    widgets::Figure m_figure; ///< of the view that was chosen last
    bool m_hasLoops = false;  ///< for this view
    FrequencyUnit m_unit = FrequencyUnit::Hertz;
    std::optional<double> m_probed; ///< frequency that is read, as the pictures have it
    Grips m_grips;
    Grips m_taken; ///< as they were then
    QLabel* m_label = nullptr;
    QComboBox* m_choice = nullptr;
    QCheckBox* m_wrap = nullptr; ///< phase of the Bode plot within half a turn
    widgets::FigureView* m_picture = nullptr;
    QLabel* m_note = nullptr;     ///< why a picture is missing
    QHBoxLayout* m_row = nullptr; ///< above the picture
};

} // namespace halbench::app
