#include "control/analysis/root_locus.h"

#include "control/analysis/frequency_scan.h"
#include "control/analysis/margins.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
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

/// Distance of a point of a set to the nearest other; infinite for one alone.
double roomOf(const Points& points, std::size_t i) {
    double least = HUGE_VAL;
    for (std::size_t j = 0; j < points.size(); ++j) {
        least = j == i ? least : std::min(least, std::abs(points[i] - points[j]));
    }
    return least;
}

/// The new points in the order of the old ones, nearest pairs first, and the farthest move.
struct Match {
    Points points;
    double farthest = 0.0;
    double ofRoom_ratio = 0.0; ///< the largest move as a share of the way to the nearest neighbour
};

/// Points that lie together, multiple poles of the open loop or a pair at a breakaway, count as having all
/// room: no step can tell them apart.
Match matched(const Points& from, const Points& to, const std::function<double(Complex)>& together) {
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
    Match match{Points(from.size()), 0.0, 0.0};
    std::vector<bool> isOldDone(from.size(), false);
    std::vector<bool> isNextDone(to.size(), false);
    for (const Pair& pair : pairs) {
        if (!isOldDone[pair.old] && !isNextDone[pair.next]) {
            isOldDone[pair.old] = true;
            isNextDone[pair.next] = true;
            match.points[pair.old] = to[pair.next];
            match.farthest = std::max(match.farthest, pair.distance);
            const double before = roomOf(from, pair.old);
            if (before > together(from[pair.old]) && pair.distance > 0.0) {
                const double room = std::min(before, roomOf(to, pair.next));
                match.ofRoom_ratio = std::max(match.ofRoom_ratio, pair.distance / room);
            }
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

/// The same of sum 1/(d - pole) = sum 1/(d - zero): on the real axis between neighbouring roots, close to
/// both of them; elsewhere by the polynomial in d.
class MeetingPoints {
public:
    explicit MeetingPoints(const DeltaSystem& loop) : m_loop(loop) {}

    std::vector<RootLocus::Breakaway> found() const {
        std::vector<RootLocus::Breakaway> result;
        const auto take = [&](Complex point) {
            const Complex gain = -1.0 / m_loop.at(point);
            const bool isReal = std::abs(gain.imag()) <= 1e-6 * std::abs(gain);
            if (isReal && gain.real() > 0.0 && std::isfinite(gain.real())) {
                result.push_back({point, gain.real()});
            }
        };
        for (const double point : onAxis()) {
            take(point);
        }
        for (const Complex& point : offAxis()) {
            take(point);
        }
        std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.gain < b.gain; });
        return result;
    }

private:
    double slopeAt(double d) const {
        double sum = 0.0;
        for (const Complex& pole : m_loop.poles()) {
            sum += (1.0 / (d - pole)).real();
        }
        for (const Complex& zero : m_loop.zeros()) {
            sum -= (1.0 / (d - zero)).real();
        }
        return sum;
    }

    /// Real roots in ascending order, each once.
    std::vector<double> realRoots() const {
        std::vector<double> result;
        for (const Points* list : {&m_loop.poles(), &m_loop.zeros()}) {
            for (const Complex& root : *list) {
                if (root.imag() == 0.0) {
                    result.push_back(root.real());
                }
            }
        }
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    std::vector<double> onAxis() const {
        constexpr double Outside = 1e3; // beyond the outermost root, in d
        const std::vector<double> roots = realRoots();
        std::vector<double> result;
        for (std::size_t i = 0; i <= roots.size() && !roots.empty(); ++i) {
            const double low = i == 0 ? roots.front() - Outside : roots[i - 1];
            const double high = i == roots.size() ? roots.back() + Outside : roots[i];
            const std::vector<double> places = gradedBetween(low, high);
            for (std::size_t n = 1; n < places.size(); ++n) {
                if ((slopeAt(places[n - 1]) < 0.0) != (slopeAt(places[n]) < 0.0)) {
                    result.push_back(
                        rootBetween([this](double d) { return slopeAt(d); }, places[n - 1], places[n]));
                }
            }
        }
        return result;
    }

    /// Ten points a decade towards either end.
    static std::vector<double> gradedBetween(double low, double high) {
        constexpr int Steps = 90;
        std::vector<double> result;
        for (int i = 0; i <= 2 * Steps; ++i) {
            const double share = 0.5 * std::pow(10.0, -0.1 * std::abs(i - Steps));
            const double place = i >= Steps ? low + (high - low) * share : high - (high - low) * share;
            if (place > low && place < high) {
                result.push_back(place);
            }
        }
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    Points offAxis() const {
        const Polynomial N = fromRoots(m_loop.zeros());
        const Polynomial D = fromRoots(m_loop.poles());
        const Polynomial condition = add(multiply(derivative(N), D), scale(multiply(N, derivative(D)), -1.0));
        Points result = condition == Polynomial{0.0} ? Points{} : roots(condition);
        std::erase_if(result, [](Complex d) { return std::abs(d.imag()) <= 1e-3 * std::abs(d); });
        return result;
    }

    const DeltaSystem& m_loop;
};

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

/// Gains that bring the loop onto -1: at rest, and at its crossings of the negative real axis.
std::vector<RootLocus::AxisCrossing> axisCrossings(std::optional<double> rest,
                                                   const std::vector<Crossing>& crossings) {
    std::vector<RootLocus::AxisCrossing> result;
    if (rest && std::isfinite(*rest) && *rest < 0.0) {
        result.push_back({-1.0 / *rest, 0.0});
    }
    for (const Crossing& crossing : crossings) {
        if (crossing.kind == Crossing::Kind::Phase) {
            result.push_back({crossing.gainMargin_ratio, crossing.frequency_rad_s});
        }
    }
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.gain < b.gain; });
    return result;
}

/// What L is at rest. Integrators that went into one polynomial leave 1e-16 at z = 1, of either sign: no
/// gain, but the root that it is.
std::optional<double> clearRest(const TransferFunction& loop) {
    const bool isClear = isClearAtRest(loop.numerator(), loop.timeBase()) &&
                         isClearAtRest(loop.denominator(), loop.timeBase());
    return isClear ? std::optional(loop.dcGain()) : std::nullopt;
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

/// A loop by its roots, in the plane in which it is followed.
struct Followed {
    Points poles;
    Points zeros;
    double gain = 1.0;
    /// Poles as near to each other as this share are together: of their size in the d plane, whose roots keep
    /// all digits towards d = 0, else of the picture.
    double together = 0.0;
    bool isGraded = false;
    std::function<Points(double, const Points&)> rootsAt; ///< at a gain, near where they were before
};

class Follower {
public:
    Follower(const Followed& loop, RootLocus& locus)
        : m_loop(loop), m_locus(locus), m_here(loop.poles), m_zeros(loop.zeros) {
        const Complex sum = std::accumulate(m_here.begin(), m_here.end(), Complex(0.0));
        m_middle = sum / static_cast<double>(m_here.size());
        m_extent = extentOf(m_here, m_zeros, m_middle);
        m_together = [graded = loop.isGraded, share = loop.together, extent = m_extent](Complex point) {
            return share * (graded ? std::abs(point) : extent);
        };
        m_locus.branch.resize(m_here.size());
        record();
    }

    void follow(std::optional<double> mostGain) {
        constexpr int MostPoints = 6000;
        constexpr int Patient = 3000; // beyond, branches that lie too close together are not told apart
        constexpr double Coarse_ratio = 0.005;
        double step = firstStep();
        std::size_t nextBreak = 0;
        for (int i = 0; i < MostPoints && !(mostGain ? m_gain >= *mostGain : hasArrived()); ++i) {
            while (nextBreak < m_locus.breakaways.size() && m_locus.breakaways[nextBreak].gain <= m_gain) {
                ++nextBreak;
            }
            const double end = mostGain.value_or(HUGE_VAL);
            const double meeting =
                nextBreak < m_locus.breakaways.size() ? m_locus.breakaways[nextBreak].gain : HUGE_VAL;
            step = advance(step, i < Patient ? 0.0 : Coarse_ratio * m_gain, std::min(end, meeting), meeting);
        }
    }

private:
    double firstStep() const {
        // Far below what moves any pole by the size of the picture.
        const Complex outside = m_middle + 3.0 * m_extent;
        double ratio = 1.0 / std::abs(m_loop.gain);
        for (std::size_t i = 0; i < m_loop.poles.size(); ++i) {
            ratio *= std::abs(outside - m_loop.poles[i]);
            ratio /= i < m_zeros.size() ? std::abs(outside - m_zeros[i]) : 1.0;
        }
        return 1e-6 * ratio;
    }

    /// One step up, halved until it is safe or the least; returns the next step to try.
    double advance(double step, double least, double limit, double meeting) {
        constexpr double Across = 1e-9; // of the gain of a breakaway: its poles have parted to about 3e-5
        const double LargestMove = 0.01 * m_extent;
        step = std::max(step, least);
        for (int halvings = 0;; ++halvings) {
            double next = std::min(m_gain + step, limit);
            const bool isAcross = next >= meeting * (1.0 - 2.0 * Across);
            next = isAcross ? meeting * (1.0 + Across) : next;
            const Match match = matched(m_here, m_loop.rootsAt(next, m_here), m_together);
            const double farthest = match.farthest;
            const double spread = std::max(1.0, radius() / m_extent); // far outside steps may be larger
            const bool isSafe = farthest <= LargestMove * spread && (match.ofRoom_ratio <= 0.3 || isAcross);
            constexpr int MostHalvings = 60;
            if (isSafe || halvings == MostHalvings || step <= least) {
                m_gain = next;
                m_here = match.points;
                record();
                return farthest < 0.3 * LargestMove * spread && match.ofRoom_ratio < 0.1 ? 2.0 * step : step;
            }
            step *= 0.5;
        }
    }

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

    const Followed& m_loop;
    RootLocus& m_locus;
    Points m_here;
    Points m_zeros;
    Complex m_middle;
    double m_extent = 1.0;
    std::function<double(Complex)> m_together;
    double m_gain = 0.0;
};

/// Centroid (sum of poles - sum of zeros)/(n - m), angles (2 k + 1) pi/(n - m); turned by pi when the loop's
/// gain is negative.
void addAsymptotes(RootLocus& locus, const Followed& loop) {
    const Points& p = loop.poles;
    const Points& z = loop.zeros;
    const auto excess = static_cast<int>(p.size()) - static_cast<int>(z.size());
    if (excess == 0) {
        return;
    }
    const Complex sum =
        std::accumulate(p.begin(), p.end(), Complex(0.0)) - std::accumulate(z.begin(), z.end(), Complex(0.0));
    locus.asymptoteCentroid = sum.real() / excess;
    for (int k = 0; k < excess; ++k) {
        locus.asymptoteAngles_rad.push_back(Pi * (2 * k + (loop.gain > 0.0 ? 1 : 0)) / excess);
    }
}

Result<void> checkFollowed(const Followed& loop, std::optional<double> mostGain) {
    if (loop.poles.empty() || loop.gain == 0.0) {
        return failure(ErrorCode::InvalidInput, "a root locus needs a loop with poles and a gain");
    }
    if (mostGain && !(*mostGain > 0.0 && std::isfinite(*mostGain))) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("the largest gain of a root locus, {}, is not positive", *mostGain));
    }
    return {};
}

/// From the d plane.
void moveToZ(RootLocus& locus) {
    for (auto& branch : locus.branch) {
        for (Complex& point : branch) {
            point += 1.0;
        }
    }
    for (RootLocus::Breakaway& breakaway : locus.breakaways) {
        breakaway.point += 1.0;
    }
    locus.asymptoteCentroid += locus.asymptoteAngles_rad.empty() ? 0.0 : 1.0;
}

} // namespace

Result<RootLocus> rootLocus(const TransferFunction& openLoop, std::optional<double> mostGain) {
    const Polynomial& N = openLoop.numerator();
    const Polynomial& D = openLoop.denominator();
    const Followed loop{poles(openLoop),
                        zeros(openLoop),
                        N.front() / D.front(),
                        1e-6,
                        false,
                        [&](double gain, const Points&) { return roots(add(D, scale(N, gain))); }};
    if (const auto valid = checkFollowed(loop, mostGain); !valid) {
        return failure(valid.error());
    }
    RootLocus locus;
    locus.breakaways = breakaways(openLoop);
    locus.axisCrossings = axisCrossings(clearRest(openLoop), allCrossings(openLoop));
    addAsymptotes(locus, loop);
    Follower(loop, locus).follow(mostGain);
    return locus;
}

Result<RootLocus> rootLocus(const DeltaSystem& openLoop, std::optional<double> mostGain) {
    const Followed loop{
        openLoop.poles(),
        openLoop.zeros(),
        openLoop.gain(),
        1e-5,
        true,
        [&](double gain, const Points& near) { return closedLoopRoots(openLoop, gain, near); }};
    if (const auto valid = checkFollowed(loop, mostGain); !valid) {
        return failure(valid.error());
    }
    RootLocus locus;
    locus.breakaways = MeetingPoints(openLoop).found();
    locus.axisCrossings = axisCrossings(openLoop.dcGain(), allCrossings(openLoop));
    addAsymptotes(locus, loop);
    Follower(loop, locus).follow(mostGain);
    moveToZ(locus);
    return locus;
}

} // namespace halbench::control
