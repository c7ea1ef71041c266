#include "control/analysis/locus_gain.h"

#include "control/base/assert.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::control {

namespace {

std::complex<double> upper(std::complex<double> place) {
    return {place.real(), std::abs(place.imag())};
}

using Roots = std::vector<std::complex<double>>;

struct Value {
    std::complex<double> value{1.0, 0.0};
    std::complex<double> slope{0.0, 0.0};
};

/// prod(x - roots) with its derivative.
Value product(const Roots& roots, std::complex<double> x) {
    Value result;
    for (const std::complex<double>& root : roots) {
        result.slope = result.slope * (x - root) + result.value;
        result.value *= x - root;
    }
    return result;
}

/// Where the straight lines between the points of a branch are at this gain.
std::complex<double> between(const RootLocus& locus, std::size_t branch, double gain) {
    const auto after = std::upper_bound(locus.gain.begin(), locus.gain.end(), gain);
    const auto& way = locus.branch[branch];
    if (after == locus.gain.end()) {
        return way.back();
    }
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - locus.gain.begin(), 1));
    const double share = (gain - locus.gain[i - 1]) / (locus.gain[i] - locus.gain[i - 1]);
    return way[i - 1] + share * (way[i] - way[i - 1]);
}

/// The closed-loop pole at a gain, from near it. Where Newton's method goes elsewhere, at a breakaway, the
/// line has to do: it is a point of the locus there.
std::complex<double> poleAt(const LocusLoop& loop, double gain, std::complex<double> start) {
    constexpr int MostRounds = 60;
    constexpr double Rounding = 1e-15;
    constexpr double MostWay_ratio = 0.25; // of a line that is some hundredths long
    std::complex<double> pole = start;
    for (int round = 0; round < MostRounds; ++round) {
        const Value poles = product(loop.poles, pole);
        const Value zeros = product(loop.zeros, pole);
        const double factor = gain * loop.gain;
        const std::complex<double> slope = poles.slope + factor * zeros.slope;
        if (slope == 0.0) {
            break;
        }
        const std::complex<double> step = (poles.value + factor * zeros.value) / slope;
        pole -= step;
        if (std::abs(step) <= Rounding * (1.0 + std::abs(pole))) {
            break;
        }
    }
    return std::abs(pole - start) <= MostWay_ratio * (1.0 + std::abs(start)) ? pole : start;
}

} // namespace

std::optional<std::size_t> branchAt(const RootLocus& locus, double gain, std::complex<double> pole) {
    if (locus.gain.empty() || locus.branch.empty()) {
        return std::nullopt;
    }
    const auto after = std::lower_bound(locus.gain.begin(), locus.gain.end(), gain);
    const auto at = static_cast<std::size_t>(
        std::min(after - locus.gain.begin(), static_cast<std::ptrdiff_t>(locus.gain.size()) - 1));
    const auto away = [&](const auto& branch) { return std::abs(branch[at] - pole); };
    const auto found =
        std::min_element(locus.branch.begin(), locus.branch.end(),
                         [&](const auto& one, const auto& other) { return away(one) < away(other); });
    return static_cast<std::size_t>(found - locus.branch.begin());
}

double gainNearest(const RootLocus& locus, std::size_t branch, std::complex<double> place) {
    HB_ASSERT(branch < locus.branch.size() && !locus.gain.empty());
    const auto& way = locus.branch[branch];
    const std::complex<double> aim = upper(place);
    double gain = locus.gain.front();
    double least = std::norm(upper(way.front()) - aim);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const std::complex<double> from = upper(way[i]);
        const std::complex<double> along = upper(way[i + 1]) - from;
        const double length2 = std::norm(along);
        const double share =
            length2 > 0.0 ? std::clamp((std::conj(along) * (aim - from)).real() / length2, 0.0, 1.0) : 0.0;
        const double away2 = std::norm(from + share * along - aim);
        if (away2 < least) {
            least = away2;
            gain = locus.gain[i] + share * (locus.gain[i + 1] - locus.gain[i]);
        }
    }
    return gain;
}

LocusLoop loopThrough(Roots zeros, Roots poles, std::complex<double> closedLoopPole) {
    const std::complex<double> gain =
        -product(poles, closedLoopPole).value / product(zeros, closedLoopPole).value;
    return {std::move(zeros), std::move(poles), gain.real()};
}

double solvedGainNearest(const RootLocus& locus, std::size_t branch, std::complex<double> place,
                         const LocusLoop& loop) {
    constexpr double Golden_ratio = 0.6180339887498949;
    constexpr int Rounds = 70; // 0.618^70 of the interval: rounding
    const double near = gainNearest(locus, branch, place);
    const auto& gains = locus.gain;
    const auto at = std::lower_bound(gains.begin(), gains.end(), near) - gains.begin();
    const auto last = static_cast<std::ptrdiff_t>(gains.size()) - 1;
    const std::complex<double> aim = upper(place);
    const auto away = [&](double gain) {
        return std::abs(upper(poleAt(loop, gain, between(locus, branch, gain))) - aim);
    };
    double low = gains[static_cast<std::size_t>(std::max<std::ptrdiff_t>(at - 2, 0))];
    double high = gains[static_cast<std::size_t>(std::min(at + 2, last))];
    for (int round = 0; round < Rounds; ++round) {
        const double inner = Golden_ratio * (high - low);
        if (away(high - inner) <= away(low + inner)) {
            high = low + inner;
        } else {
            low = high - inner;
        }
    }
    const double found = 0.5 * (low + high);
    return away(found) <= away(near) ? found : near;
}

} // namespace halbench::control
