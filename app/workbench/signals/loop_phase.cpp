#include "app/workbench/signals/loop_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace halbench::app {
namespace {

using widgets::Curve;
using widgets::CurveStyle;

constexpr double Turn_deg = 360.0;
constexpr double Half_deg = 180.0;

/// In which turn an angle lies: 0 within half a turn of zero.
double turnOf(double phase_deg) {
    return std::ceil((phase_deg - Half_deg) / Turn_deg);
}

void add(Curve& curve, double x, double y) {
    curve.x.push_back(x);
    curve.y.push_back(y);
}

/// To the edge where the line between two samples leaves, and from the other on: straight over the logarithm
/// of the frequency, as it is drawn.
void addEdge(Curve& curve, std::pair<double, double> from, std::pair<double, double> to) {
    const bool isFalling = to.second < from.second;
    const double turn = turnOf(isFalling ? from.second : to.second);
    const double edge_deg = Turn_deg * turn - Half_deg; // below which the next turn lies
    const double share = (edge_deg - from.second) / (to.second - from.second);
    const double x = from.first * std::pow(to.first / from.first, share);
    add(curve, x, isFalling ? -Half_deg : Half_deg);
    add(curve, x, std::numeric_limits<double>::quiet_NaN());
    add(curve, x, isFalling ? Half_deg : -Half_deg);
}

Curve wrappedCurve(const Curve& curve) {
    Curve result = curve;
    result.x.clear();
    result.y.clear();
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const bool isJoined = i > 0 && !widgets::isMarkers(curve.style) && std::isfinite(curve.y[i - 1]) &&
                              std::isfinite(curve.y[i]);
        if (isJoined && turnOf(curve.y[i - 1]) != turnOf(curve.y[i])) {
            addEdge(result, {curve.x[i - 1], curve.y[i - 1]}, {curve.x[i], curve.y[i]});
        }
        add(result, curve.x[i], wrapped_deg(curve.y[i]));
    }
    return result;
}

/// The outline once for each turn that it reaches; the panel cuts off what is not of its own.
std::vector<Curve> wrappedBand(const Curve& band) {
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    for (const double phase_deg : band.y) {
        first = std::isfinite(phase_deg) ? std::min(first, turnOf(phase_deg)) : first;
        last = std::isfinite(phase_deg) ? std::max(last, turnOf(phase_deg)) : last;
    }
    std::vector<Curve> bands;
    for (double turn = first; turn <= last; ++turn) {
        Curve copy = band;
        for (double& phase_deg : copy.y) {
            phase_deg -= Turn_deg * turn;
        }
        if (!bands.empty()) {
            copy.label.clear(); // the legend has it once
        }
        bands.push_back(std::move(copy));
    }
    return bands;
}

} // namespace

double wrapped_deg(double phase_deg) {
    return phase_deg - Turn_deg * turnOf(phase_deg);
}

widgets::Figure withWrappedPhase(widgets::Figure bode) {
    widgets::Panel& phase = bode.panels.at(1);
    std::vector<Curve> curves;
    for (const Curve& curve : phase.curves) {
        if (curve.style == CurveStyle::Band) {
            for (Curve& band : wrappedBand(curve)) {
                curves.push_back(std::move(band));
            }
        } else {
            curves.push_back(wrappedCurve(curve));
        }
    }
    phase.curves = std::move(curves);
    phase.y.min = -Half_deg;
    phase.y.max = Half_deg;
    return bode;
}

} // namespace halbench::app
