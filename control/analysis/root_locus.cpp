#include "control/analysis/root_locus.h"

#include "control/analysis/margins.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;
using Points = std::vector<Complex>;

Polynomial derivative(const Polynomial& p) {
    Polynomial result;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        result.push_back(p[i] * static_cast<double>(p.size() - 1 - i));
    }
    return trimmed(std::move(result));
}

/// Smallest distance between two points of a set; infinite for one.
double separation(const Points& points) {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            least = std::min(least, std::abs(points[i] - points[j]));
        }
    }
    return least;
}

/// The new points in the order of the old ones, nearest pairs first, and the farthest move.
struct Match {
    Points points;
    double farthest = 0.0;
};

Match matched(const Points& from, const Points& to) {
    struct Pair {
        double distance;
        std::size_t old;
        std::size_t next;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < from.size(); ++i) {
        for (std::size_t j = 0; j < to.size(); ++j) {
            pairs.push_back({std::abs(from[i] - to[j]), i, j});
        }
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    Match match{Points(from.size()), 0.0};
    std::vector<bool> isOldDone(from.size(), false);
    std::vector<bool> isNextDone(to.size(), false);
    for (const Pair& pair : pairs) {
        if (!isOldDone[pair.old] && !isNextDone[pair.next]) {
            isOldDone[pair.old] = true;
            isNextDone[pair.next] = true;
            match.points[pair.old] = to[pair.next];
            match.farthest = std::max(match.farthest, pair.distance);
        }
    }
    return match;
}

/// N' D - N D' = 0 with a real positive K = -D/N.
std::vector<RootLocus::Breakaway> breakaways(const TransferFunction& loop) {
    const Polynomial& N = loop.numerator();
    const Polynomial& D = loop.denominator();
    const Polynomial condition = add(multiply(derivative(N), D), scale(multiply(N, derivative(D)), -1.0));
    std::vector<RootLocus::Breakaway> result;
    for (const Complex& point : condition == Polynomial{0.0} ? Points{} : roots(condition)) {
        const Complex gain = -evaluate(D, point) / evaluate(N, point);
        const bool isReal = std::abs(gain.imag()) <= 1e-6 * std::abs(gain);
        if (isReal && gain.real() > 0.0 && std::isfinite(gain.real())) {
            result.push_back({point, gain.real()});
        }
    }
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.gain < b.gain; });
    return result;
}

/// Whether a polynomial at rest is more than what rounding leaves of a root there. Each coefficient is known
/// to a few roundings, products of factors as it mostly is, and Horner's rule adds two for each order
/// (Higham, "Accuracy and Stability of Numerical Algorithms", 5.1).
bool isClearAtRest(const Polynomial& polynomial, const TimeBase& base) {
    const double rest = base.isSampled() ? 1.0 : 0.0;
    double terms = 0.0;
    for (const double coefficient : polynomial) {
        terms = terms * rest + std::abs(coefficient);
    }
    const double roundings = 4.0 + 2.0 * degree(polynomial);
    return std::abs(evaluate(polynomial, Complex(rest, 0.0))) >
           roundings * std::numeric_limits<double>::epsilon() * terms;
}

/// Gains that bring the loop onto -1, from its own crossings of the real axis, and at rest. Integrators that
/// went into one polynomial leave 1e-16 at z = 1, of either sign: no gain, but the root that it is.
std::vector<RootLocus::AxisCrossing> axisCrossings(const TransferFunction& loop) {
    std::vector<RootLocus::AxisCrossing> result;
    const bool isClear = isClearAtRest(loop.numerator(), loop.timeBase()) &&
                         isClearAtRest(loop.denominator(), loop.timeBase());
    if (const double rest = loop.dcGain(); isClear && std::isfinite(rest) && rest < 0.0) {
        result.push_back({-1.0 / rest, 0.0});
    }
    for (const Crossing& crossing : allCrossings(loop)) {
        if (crossing.kind == Crossing::Kind::Phase) {
            result.push_back({crossing.gainMargin_ratio, crossing.frequency_rad_s});
        }
    }
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.gain < b.gain; });
    return result;
}

/// Size of the picture: the farthest pole or zero from the middle of the poles, at least a little.
double extentOf(const Points& poles, const Points& zeros, Complex middle) {
    double extent = 1e-3 * (1.0 + std::abs(middle));
    for (const auto& list : {poles, zeros}) {
        for (const Complex& point : list) {
            extent = std::max(extent, std::abs(point - middle));
        }
    }
    return extent;
}

class Follower {
public:
    Follower(const TransferFunction& loop, RootLocus& locus)
        : m_loop(loop), m_locus(locus), m_here(poles(loop)), m_zeros(zeros(loop)) {
        const Complex sum = std::accumulate(m_here.begin(), m_here.end(), Complex(0.0));
        m_middle = sum / static_cast<double>(m_here.size());
        m_extent = extentOf(m_here, m_zeros, m_middle);
        m_locus.branch.resize(m_here.size());
        record();
    }

    void follow(std::optional<double> mostGain) {
        constexpr int MostPoints = 20000;
        double step = firstStep();
        std::size_t nextBreak = 0;
        for (int i = 0; i < MostPoints && !(mostGain ? m_gain >= *mostGain : hasArrived()); ++i) {
            while (nextBreak < m_locus.breakaways.size() && m_locus.breakaways[nextBreak].gain <= m_gain) {
                ++nextBreak;
            }
            const double end = mostGain.value_or(HUGE_VAL);
            const double meeting =
                nextBreak < m_locus.breakaways.size() ? m_locus.breakaways[nextBreak].gain : HUGE_VAL;
            step = advance(step, std::min(end, meeting), meeting);
        }
    }

private:
    Points rootsAt(double gain) const {
        return roots(add(m_loop.denominator(), scale(m_loop.numerator(), gain)));
    }

    double firstStep() const {
        // Far below what moves any pole by the size of the picture.
        const Complex outside = m_middle + 3.0 * m_extent;
        return 1e-6 *
               std::abs(evaluate(m_loop.denominator(), outside) / evaluate(m_loop.numerator(), outside));
    }

    /// One step up, halved until it is safe; returns the next step to try.
    double advance(double step, double limit, double meeting) {
        constexpr double Across = 1e-9; // of the gain of a breakaway: its poles have parted to about 3e-5
        const double LargestMove = 0.01 * m_extent;
        for (int halvings = 0;; ++halvings) {
            double next = std::min(m_gain + step, limit);
            const bool isAcross = next >= meeting * (1.0 - 2.0 * Across);
            next = isAcross ? meeting * (1.0 + Across) : next;
            const Points found = rootsAt(next);
            const Match match = matched(m_here, found);
            const double room = std::min(separation(m_here), separation(found));
            const double farthest = match.farthest;
            const double spread = std::max(1.0, radius() / m_extent); // far outside steps may be larger
            const bool isSafe =
                farthest <= LargestMove * spread && (farthest <= 0.3 * room || isAcross || !isClear());
            constexpr int MostHalvings = 60;
            if (isSafe || halvings == MostHalvings) {
                m_gain = next;
                m_here = match.points;
                record();
                return farthest < 0.3 * LargestMove * spread && farthest < 0.1 * room ? 2.0 * step : step;
            }
            step *= 0.5;
        }
    }

    /// False at the start on multiple open-loop poles, which no step can tell apart.
    bool isClear() const { return separation(m_here) > 1e-6 * m_extent; }

    double radius() const {
        double result = 0.0;
        for (const Complex& point : m_here) {
            result = std::max(result, std::abs(point - m_middle));
        }
        return result;
    }

    bool hasArrived() const {
        Points near = m_zeros;
        for (const Complex& point : m_here) {
            const auto zero = std::find_if(near.begin(), near.end(),
                                           [&](Complex z) { return std::abs(point - z) <= 0.01 * m_extent; });
            if (zero != near.end()) {
                near.erase(zero);
            } else if (std::abs(point - m_middle) < 5.0 * m_extent) {
                return false;
            }
        }
        return true;
    }

    void record() {
        m_locus.gain.push_back(m_gain);
        for (std::size_t b = 0; b < m_here.size(); ++b) {
            m_locus.branch[b].push_back(m_here[b]);
        }
    }

    const TransferFunction& m_loop;
    RootLocus& m_locus;
    Points m_here;
    Points m_zeros;
    Complex m_middle;
    double m_extent = 1.0;
    double m_gain = 0.0;
};

/// Centroid (sum of poles - sum of zeros)/(n - m), angles (2 k + 1) pi/(n - m); turned by pi when the loop's
/// gain is negative.
void addAsymptotes(RootLocus& locus, const TransferFunction& loop) {
    const Points p = poles(loop);
    const Points z = zeros(loop);
    const auto excess = static_cast<int>(p.size()) - static_cast<int>(z.size());
    if (excess == 0) {
        return;
    }
    const Complex sum =
        std::accumulate(p.begin(), p.end(), Complex(0.0)) - std::accumulate(z.begin(), z.end(), Complex(0.0));
    locus.asymptoteCentroid = sum.real() / excess;
    const bool isPositive = loop.numerator().front() / loop.denominator().front() > 0.0;
    for (int k = 0; k < excess; ++k) {
        locus.asymptoteAngles_rad.push_back(Pi * (2 * k + (isPositive ? 1 : 0)) / excess);
    }
}

} // namespace

Result<RootLocus> rootLocus(const TransferFunction& openLoop, std::optional<double> mostGain) {
    if (openLoop.order() == 0 || openLoop.numerator() == Polynomial{0.0}) {
        return failure(ErrorCode::InvalidInput, "a root locus needs a loop with poles and a gain");
    }
    if (mostGain && !(*mostGain > 0.0 && std::isfinite(*mostGain))) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("the largest gain of a root locus, {}, is not positive", *mostGain));
    }
    RootLocus locus;
    locus.breakaways = breakaways(openLoop);
    locus.axisCrossings = axisCrossings(openLoop);
    addAsymptotes(locus, openLoop);
    Follower(openLoop, locus).follow(mostGain);
    return locus;
}

} // namespace halbench::control
