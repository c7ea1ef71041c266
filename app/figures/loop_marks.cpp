#include "app/figures/loop_marks.h"

#include "app/figures/loop_curves.h"
#include "control/analysis/nyquist.h"
#include "control/base/units.h"
#include "control/lti/zero_pole_gain.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>

namespace halbench::app {
namespace {

using widgets::Curve;
using widgets::CurveStyle;
using Complex = std::complex<double>;
using Direction = widgets::ReferenceLine::Direction;
using Kind = control::Crossing::Kind;

constexpr int OtherColour = 7; // of the theme, the quietest

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::TuningFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

std::string phaseMarginText(double margin_deg) {
    return fmt::format("{} {:.0f}\u00b0", utf8(Words::tr("phase margin")), margin_deg);
}

/// In the unit of the axis it is read on.
std::string decibelText(double ratio) {
    return fmt::format("{:.1f} dB", 20.0 * std::log10(ratio));
}

std::string gainMarginText(double margin_ratio) {
    return fmt::format("{} {}", utf8(Words::tr("gain margin")), decibelText(margin_ratio));
}

/// Whether a crossing is where the margin of its kind was found.
bool isDeciding(const control::Crossing& crossing, const control::StabilityMargins& margins) {
    const auto& at = crossing.kind == Kind::Gain ? margins.gainCrossover_rad_s : margins.phaseCrossover_rad_s;
    return at && std::abs(crossing.frequency_rad_s - *at) <= 1e-9 * *at;
}

/// Without a number: it is not the margin.
void markOther(widgets::BodeContent& content, const control::Crossing& crossing) {
    const double at_Hz = crossing.frequency_rad_s / (2.0 * Pi);
    const bool isGain = crossing.kind == Kind::Gain;
    widgets::ReferenceLine line{Direction::Vertical, at_Hz, {}, true};
    content.magnitudeLines.push_back(line);
    content.phaseLines.push_back(line);
    (isGain ? content.phaseLines : content.magnitudeLines).back().label =
        isGain ? fmt::format("{:.0f}\u00b0", crossing.phaseMargin_deg)
               : decibelText(crossing.gainMargin_ratio);
}

using Place = std::pair<double, double>; ///< x and y

/// The curve's place at a crossing, in the complex plane.
Place placeInPlane(const control::Crossing& crossing) {
    const Complex value = crossing.kind == Kind::Gain
                              ? std::polar(1.0, degreesToRadians(crossing.phaseMargin_deg - 180.0))
                              : Complex(-1.0 / crossing.gainMargin_ratio, 0.0);
    return {value.real(), value.imag()};
}

/// And over the phase, on the turn where the curve crosses.
Place placeInNichols(const control::Crossing& crossing, const AnalysisResult::Bode& bode) {
    const bool isGain = crossing.kind == Kind::Gain;
    const double phase_deg = isGain ? crossing.phaseMargin_deg - 180.0 : -180.0;
    const auto next = std::lower_bound(bode.frequency_Hz.begin(), bode.frequency_Hz.end(),
                                       crossing.frequency_rad_s / (2.0 * Pi));
    const auto at =
        std::min(static_cast<std::size_t>(next - bode.frequency_Hz.begin()), bode.frequency_Hz.size() - 1);
    const double turns = std::round((bode.phase_deg[at] - phase_deg) / 360.0);
    return {phase_deg + 360.0 * turns, isGain ? 0.0 : -20.0 * std::log10(crossing.gainMargin_ratio)};
}

bool isWithin(const widgets::Axis& axis, double value) {
    return (!axis.min || value >= *axis.min) && (!axis.max || value <= *axis.max);
}

void appendCrosses(widgets::Panel& panel, const widgets::Axis& xAxis, const AnalysisResult& loop,
                   const std::function<Place(const control::Crossing&)>& placeOf) {
    Curve others{utf8(Words::tr("other crossings")), {}, {}, CurveStyle::Crosses, OtherColour};
    for (const control::Crossing& crossing : loop.crossings) {
        const auto [x, y] = placeOf(crossing);
        if (!isDeciding(crossing, loop.margins)) {
            if (isWithin(xAxis, x) && isWithin(panel.y, y)) { // else the legend has what is not there
                others.x.push_back(x);
                others.y.push_back(y);
            }
            continue;
        }
        const std::string label = crossing.kind == Kind::Gain ? phaseMarginText(crossing.phaseMargin_deg)
                                                              : gainMarginText(crossing.gainMargin_ratio);
        panel.curves.push_back({label, {x}, {y}, CurveStyle::Crosses, MarkColour});
    }
    if (!others.x.empty()) {
        panel.curves.push_back(std::move(others));
    }
}

/// The open loop once more; its gain from the middle of its Bode plot, where all digits are there.
Result<control::DeltaSystem> fromRoots(const AnalysisResult& loop) {
    const auto timeBase = control::TimeBase::sampledChecked(loop.roots.period_s);
    if (!timeBase) {
        return failure(timeBase.error());
    }
    const auto shape = control::ZeroPoleGain::make(loop.roots.zeros, loop.roots.openLoop, 1.0, *timeBase);
    if (!shape) {
        return failure(shape.error());
    }
    const std::size_t middle = loop.bode.frequency_Hz.size() / 2;
    const Complex value = std::polar(std::pow(10.0, loop.bode.magnitude_dB[middle] / 20.0),
                                     degreesToRadians(loop.bode.phase_deg[middle]));
    const auto delta = control::toDeltaSystem(*shape);
    if (!delta) {
        return failure(delta.error());
    }
    const double gain = (value / delta->atFrequency(2.0 * Pi * loop.bode.frequency_Hz[middle])).real();
    return control::DeltaSystem::make(delta->zeros(), delta->poles(), gain, *timeBase);
}

} // namespace

void markCrossings(widgets::BodeContent& content, const AnalysisResult& loop) {
    const control::StabilityMargins& margins = loop.margins;
    for (const control::Crossing& crossing : loop.crossings) {
        if (!isDeciding(crossing, margins)) {
            markOther(content, crossing);
        }
    }
    if (margins.gainCrossover_rad_s) {
        const double crossover_Hz = *margins.gainCrossover_rad_s / (2.0 * Pi);
        content.magnitudeLines.push_back({Direction::Vertical, crossover_Hz, {}});
        content.phaseLines.push_back(
            {Direction::Vertical, crossover_Hz, phaseMarginText(margins.phaseMargin_deg)});
    }
    if (margins.phaseCrossover_rad_s && std::isfinite(margins.gainMargin_ratio)) {
        const double crossover_Hz = *margins.phaseCrossover_rad_s / (2.0 * Pi);
        content.magnitudeLines.push_back(
            {Direction::Vertical, crossover_Hz, gainMarginText(margins.gainMargin_ratio)});
        content.phaseLines.push_back({Direction::Vertical, crossover_Hz, {}});
    }
}

void appendCrossings(widgets::Panel& plane, const widgets::Axis& x, const AnalysisResult& loop) {
    appendCrosses(plane, x, loop, placeInPlane);
}

void appendNicholsCrossings(widgets::Panel& panel, const widgets::Axis& x, const AnalysisResult& loop) {
    if (!loop.bode.frequency_Hz.empty()) {
        appendCrosses(panel, x, loop,
                      [&](const control::Crossing& crossing) { return placeInNichols(crossing, loop.bode); });
    }
}

std::optional<NyquistCount> nyquistCount(const AnalysisResult& loop) {
    if (loop.roots.openLoop.empty() || loop.bode.frequency_Hz.empty()) {
        return std::nullopt;
    }
    const auto openLoop = fromRoots(loop);
    if (!openLoop) {
        return std::nullopt;
    }
    const auto counted = control::nyquist(*openLoop);
    return counted ? std::optional(NyquistCount{counted->encirclements, counted->unstableOpenLoopPoles})
                   : std::nullopt;
}

std::string criticalPoint(const AnalysisResult& loop) {
    const std::string point = "\u22121";
    const auto count = nyquistCount(loop);
    return count ? fmt::format("{}, {}", point,
                               utf8(Words::tr("%1 encirclements; unstable poles of L: %2")
                                        .arg(count->encirclements)
                                        .arg(count->unstableOpenLoopPoles)))
                 : point;
}

} // namespace halbench::app
