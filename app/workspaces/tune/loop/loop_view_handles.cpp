// What can be moved in the pictures of the open loop.
#include "app/workbench/signals/loop_phase.h"
#include "app/workspaces/parts/figure_units.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "control/base/units.h"
#include "widgets/figure/figure_view.h"

#include <QCheckBox>
#include <QComboBox>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using widgets::FigureHandle;

enum BodeHandle { CrossoverHandle, MarginHandle };

constexpr double CrossoverStep_ratio = 1.02;
constexpr double MarginStep_deg = 1.0;
constexpr double GainStep_ratio = 1.05;

/// Straight over the logarithm of the frequency, as it is drawn; nothing beyond what is drawn.
std::optional<double> phaseAt(const AnalysisResult::Bode& bode, double frequency_Hz) {
    const auto after = std::lower_bound(bode.frequency_Hz.begin(), bode.frequency_Hz.end(), frequency_Hz);
    if (after == bode.frequency_Hz.begin() || after == bode.frequency_Hz.end()) {
        return std::nullopt;
    }
    const auto i = static_cast<std::size_t>(after - bode.frequency_Hz.begin());
    const double share = std::log(frequency_Hz / bode.frequency_Hz[i - 1]) /
                         std::log(bode.frequency_Hz[i] / bode.frequency_Hz[i - 1]);
    return bode.phase_deg[i - 1] + share * (bode.phase_deg[i] - bode.phase_deg[i - 1]);
}

/// The pole that is farthest from z = 1, where open and closed loop have most of theirs: it says the loop's
/// gain with most digits.
std::complex<double> fastestOf(const std::vector<std::complex<double>>& poles) {
    return *std::max_element(poles.begin(), poles.end(), [](const auto& one, const auto& other) {
        return std::abs(one - 1.0) < std::abs(other - 1.0);
    });
}

} // namespace

void LoopView::connectHandles() {
    connect(m_picture, &widgets::FigureView::handleTaken, this, [this] {
        take();
        Q_EMIT taken();
    });
    connect(m_picture, &widgets::FigureView::handleMoved, this, &LoopView::move);
    connect(m_picture, &widgets::FigureView::handleReleased, this, &LoopView::released);
    connect(m_picture, &widgets::FigureView::handleStepped, this, &LoopView::step);
}

LoopView::View LoopView::view() const {
    return static_cast<View>(m_choice->currentIndex());
}

void LoopView::findGrips(const AnalysisResult& predicted) {
    const AnalysisResult::Roots& roots = predicted.roots;
    m_grips = {predicted.margins, 0.0, {}, {}, {}};
    if (view() == View::RootLocus && !roots.closedLoop.empty()) {
        m_grips.locus = roots.locus;
        m_grips.loop = control::loopThrough(roots.zeros, roots.openLoop, fastestOf(roots.closedLoop));
    }
    if (const auto& crossover_rad_s = m_grips.margins.gainCrossover_rad_s) {
        const auto phase_deg = phaseAt(predicted.bode, *crossover_rad_s / (2.0 * Pi));
        m_grips.phase_deg = phase_deg.value_or(0.0);
        if (!phase_deg) {
            m_grips.margins.gainCrossover_rad_s.reset(); // not in the picture
        }
    }
    for (const std::complex<double>& pole : predicted.roots.closedLoop) {
        constexpr double Axis = -1e-9; // the other of a pair goes with it
        if (pole.imag() >= Axis) {
            m_grips.poles.push_back(pole);
        }
    }
}

std::vector<FigureHandle> LoopView::handlesOf(View view) const {
    const auto& crossover_rad_s = m_grips.margins.gainCrossover_rad_s;
    std::vector<FigureHandle> handles;
    if (view == View::Bode && crossover_rad_s) {
        const double crossover = *crossover_rad_s / (2.0 * Pi) * frequencyFactor(m_unit);
        handles = {{0, crossover, 0.0, FigureHandle::Way::Horizontal, tr("gain crossover")},
                   {1, crossover, m_wrap->isChecked() ? wrapped_deg(m_grips.phase_deg) : m_grips.phase_deg,
                    FigureHandle::Way::Vertical, tr("phase margin")}};
    } else if (view == View::RootLocus) {
        for (const std::complex<double>& pole : m_grips.poles) {
            handles.push_back(
                {0, pole.real(), pole.imag(), FigureHandle::Way::Free, tr("all gains, along the branch")});
        }
    }
    return handles;
}

void LoopView::take() {
    m_taken = m_grips;
}

void LoopView::move(int handle, double x, double y) {
    if (view() == View::RootLocus) {
        const auto at = static_cast<std::size_t>(handle);
        const auto branch = at < m_taken.poles.size()
                                ? control::branchAt(m_taken.locus, 1.0, m_taken.poles[at])
                                : std::nullopt;
        if (branch) {
            Q_EMIT gainMoved(control::solvedGainNearest(m_taken.locus, *branch, {x, y}, m_taken.loop));
        }
    } else if (handle == CrossoverHandle) {
        Q_EMIT crossoverMoved(2.0 * Pi * x / frequencyFactor(m_unit));
    } else {
        const double way_deg = y - m_taken.phase_deg;
        Q_EMIT phaseMarginMoved(m_taken.margins.phaseMargin_deg +
                                (m_wrap->isChecked() ? wrapped_deg(way_deg) : way_deg));
    }
}

void LoopView::step(int handle, int steps) {
    if (view() == View::RootLocus) {
        Q_EMIT gainMoved(std::pow(GainStep_ratio, steps));
    } else if (handle == CrossoverHandle) {
        Q_EMIT crossoverMoved(*m_grips.margins.gainCrossover_rad_s * std::pow(CrossoverStep_ratio, steps));
    } else {
        Q_EMIT phaseMarginMoved(m_grips.margins.phaseMargin_deg + steps * MarginStep_deg);
    }
}

} // namespace halbench::app
