#include "control/analysis/locus_gain.h"

#include "control/base/assert.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

std::complex<double> upper(std::complex<double> place) {
    return {place.real(), std::abs(place.imag())};
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

} // namespace halbench::control
