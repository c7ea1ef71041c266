#include "app/figures/root_locus_figure.h"

#include "control/base/units.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <limits>

namespace halbench::app {
namespace {

using widgets::Curve;
using widgets::CurveStyle;
using Complex = std::complex<double>;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::RootLocusFigure)
};

constexpr int MarkColour = 6; ///< of what belongs to the picture and not to a loop
constexpr int WayColour = 7;
constexpr double Damping_ratio = 0.7;
constexpr double Extent = 1.2;
constexpr double LeastFactor = 1e-3; ///< below it the poles leave 1, where those of the open loop are

std::string utf8(const QString& text) {
    return text.toStdString();
}

void add(Curve& curve, Complex point) {
    curve.x.push_back(point.real());
    curve.y.push_back(point.imag());
}

Curve points(const std::string& label, const std::vector<Complex>& places, CurveStyle style, int colour) {
    Curve curve{label, {}, {}, style, colour};
    for (const Complex& place : places) {
        add(curve, place);
    }
    return curve;
}

Curve unitCircle() {
    constexpr int Sides = 180;
    Curve curve{utf8(Words::tr("limit of stability")), {}, {}, CurveStyle::DottedLine, MarkColour};
    for (int i = 0; i <= Sides; ++i) {
        add(curve, std::polar(1.0, 2.0 * Pi * i / Sides));
    }
    return curve;
}

/// z = e^(s T) of s = w (-zeta +- i sqrt(1 - zeta^2)), from w = 0 to the Nyquist frequency.
Curve dampingLine() {
    constexpr int Places = 120;
    const double across = std::sqrt(1.0 - Damping_ratio * Damping_ratio);
    Curve curve{fmt::format("{} {:.1f}", utf8(Words::tr("damping ratio")), Damping_ratio),
                {},
                {},
                CurveStyle::DashedLine,
                MarkColour};
    for (int i = -Places; i <= Places; ++i) {
        const double angle_rad = Pi * i / Places;
        add(curve, std::polar(std::exp(-Damping_ratio / across * std::abs(angle_rad)), angle_rad));
    }
    return curve;
}

/// All branches as one curve, interrupted between them, so that the legend names them once.
Curve ways(const control::RootLocus& locus) {
    constexpr double Interruption = std::numeric_limits<double>::quiet_NaN();
    Curve curve{utf8(Words::tr("gain from 0 to %1 times").arg(RootLocusMost_ratio)),
                {},
                {},
                CurveStyle::Line,
                WayColour};
    for (const auto& branch : locus.branch) {
        for (const Complex& pole : branch) {
            add(curve, pole);
        }
        add(curve, {Interruption, Interruption});
    }
    return curve;
}

/// Where a branch leaves or enters the unit circle.
Curve limits(const control::RootLocus& locus, double period_s) {
    Curve curve{{}, {}, {}, CurveStyle::HollowPoints, MarkColour};
    std::string factors;
    for (const auto& crossing : locus.axisCrossings) {
        if (crossing.gain < LeastFactor || crossing.gain > RootLocusMost_ratio) {
            continue;
        }
        const Complex place = std::polar(1.0, crossing.frequency_rad_s * period_s);
        add(curve, place);
        add(curve, std::conj(place));
        factors += fmt::format("{}{:.2f}", factors.empty() ? "" : ", ", crossing.gain);
    }
    if (!factors.empty()) {
        curve.label = fmt::format("{}: {}", utf8(Words::tr("limit at gain factor")), factors);
    }
    return curve;
}

} // namespace

widgets::Figure rootLocusFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                                const std::vector<NamedLoop>& others) {
    const AnalysisResult::Roots& roots = predicted.roots;
    widgets::Panel plane;
    plane.y = {utf8(Words::tr("imaginary part of z")), {}, false, -Extent, Extent, {}};
    plane.height_px = 360;
    plane.curves = {unitCircle(), dampingLine(), ways(roots.locus), limits(roots.locus, roots.period_s)};
    plane.curves.push_back(
        points(utf8(Words::tr("poles of the open loop")), roots.openLoop, CurveStyle::Crosses, WayColour));
    plane.curves.push_back(
        points(utf8(Words::tr("zeros")), roots.zeros, CurveStyle::HollowPoints, WayColour));
    for (const LoopCurve& each : loopCurves(predicted, present, others)) {
        const std::string name =
            each.label.empty() ? utf8(Words::tr("poles of the closed loop"))
                               : utf8(Words::tr("closed loop: %1").arg(QString::fromStdString(each.label)));
        plane.curves.push_back(points(name, each.loop->roots.closedLoop, CurveStyle::Points, each.colour));
    }
    widgets::Figure figure;
    figure.title = utf8(Words::tr("Root locus"));
    figure.x = {utf8(Words::tr("real part of z")), {}, false, -Extent, Extent, {}};
    figure.panels = {std::move(plane)};
    figure.isEqualScale = true;
    return figure;
}

} // namespace halbench::app
