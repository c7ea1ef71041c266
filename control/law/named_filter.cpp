#include "control/law/named_filter.h"

#include "control/base/units.h"
#include "control/law/filtered_delta.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace halbench::control {

namespace {

std::array<double, 5> coefficientsOf(const LawSection<double>& section) {
    return {section.b0, section.b1, section.b2, section.a1, section.a2};
}

double rounded(double value, int digits) {
    return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

/// The same filter with figures of so many digits.
LoopFilter withDigits(const LoopFilter& filter, int digits) {
    struct Kinds {
        int digits;

        LoopFilter operator()(LeadFilter f) const {
            return LeadFilter{rounded(f.frequency_rad_s, digits), rounded(f.phase_deg, digits)};
        }
        LoopFilter operator()(LagFilter f) const {
            return LagFilter{rounded(f.frequency_rad_s, digits), rounded(f.ratio, digits)};
        }
        LoopFilter operator()(NotchFilter f) const {
            return NotchFilter{rounded(f.frequency_rad_s, digits), rounded(f.depth_ratio, digits),
                               rounded(f.damping_ratio, digits)};
        }
        LoopFilter operator()(LowPassFilter f) const {
            return LowPassFilter{rounded(f.corner_rad_s, digits), f.order};
        }
        LoopFilter operator()(SectionFilter f) const { return f; }
    };
    return std::visit(Kinds{digits}, filter);
}

/// The frequency whose place in s' = d/(d + 2) is tan(w T/2).
double frequencyAt_rad_s(double place, double period_s) {
    return 2.0 / period_s * std::atan(place);
}

/// (n1 s' + n0)/(m1 s' + m0) of a section of the first order.
std::vector<LoopFilter> candidatesOfOneRoot(const LawSection<double>& section, double period_s) {
    const double n1 = 2.0 * section.b0 - section.b1;
    const double n0 = section.b1;
    const double m1 = 2.0 - section.a1;
    const double m0 = section.a1;
    if (!(m1 > 0.0) || !(m0 > 0.0)) {
        return {};
    }
    std::vector<LoopFilter> candidates = {LowPassFilter{frequencyAt_rad_s(m0 / m1, period_s), 1}};
    if (n1 > 0.0 && n0 > 0.0) {
        const double zero = n0 / n1;
        const double pole = m0 / m1;
        // A lead has its largest phase half way between zero and pole, asin((p - z)/(p + z)).
        const double sine = (pole - zero) / (pole + zero);
        candidates.push_back(LeadFilter{frequencyAt_rad_s(std::sqrt(zero * pole), period_s),
                                        radiansToDegrees(std::asin(sine))});
        candidates.push_back(LagFilter{frequencyAt_rad_s(zero, period_s), zero / pole});
    }
    return candidates;
}

/// (n2 s'^2 + n1 s' + n0)/(m2 s'^2 + m1 s' + m0) of a section of the second order.
std::vector<LoopFilter> candidatesOfTwoRoots(const LawSection<double>& section, double period_s) {
    const double n2 = 4.0 * section.b0 - 2.0 * section.b1 + section.b2;
    const double n1 = 2.0 * section.b1 - 2.0 * section.b2;
    const double m2 = 4.0 - 2.0 * section.a1 + section.a2;
    const double m1 = 2.0 * section.a1 - 2.0 * section.a2;
    const double m0 = section.a2;
    if (!(m2 > 0.0) || !(m0 > 0.0) || !(m1 > 0.0) || !(n2 >= 0.0)) {
        return {};
    }
    const double place = std::sqrt(m0 / m2);
    const double frequency_rad_s = frequencyAt_rad_s(place, period_s);
    std::vector<LoopFilter> candidates = {LowPassFilter{frequency_rad_s, 2}};
    candidates.push_back(NotchFilter{frequency_rad_s, std::max(n1, 0.0) / m1, 0.5 * m1 / (m2 * place)});
    return candidates;
}

std::optional<LoopFilter> sameOnBoard(const LoopFilter& filter, const LawSection<double>& section,
                                      double period_s) {
    const auto sections = filterSections({filter}, period_s);
    return sections && isSameOnBoard(sections->front(), section) ? std::optional(filter) : std::nullopt;
}

} // namespace

bool isSameOnBoard(const LawSection<double>& one, const LawSection<double>& other) {
    const auto ones = coefficientsOf(one);
    const auto others = coefficientsOf(other);
    double scale = 0.0;
    for (std::size_t i = 0; i < ones.size(); ++i) {
        // Sixteen times the rounding of single precision: near Nyquist the figures of a filter follow from
        // differences of its coefficients. What is a rounding error of its neighbours counts as zero.
        scale = std::max(scale, std::fabs(others[i]));
        const double allowed = 1e-6 * std::fabs(others[i]) + 1e-15 * scale;
        if (!(std::fabs(ones[i] - others[i]) <= allowed)) {
            return false;
        }
    }
    return true;
}

LoopFilter namedFilter(const LawSection<double>& section, double period_s) {
    const bool hasOneRoot = section.a2 == 0.0 && section.b2 == 0.0;
    const auto candidates =
        hasOneRoot ? candidatesOfOneRoot(section, period_s) : candidatesOfTwoRoots(section, period_s);
    for (const LoopFilter& candidate : candidates) {
        for (const int digits : {3, 4, 5, 6, 7, 8, 9}) {
            if (const auto named = sameOnBoard(withDigits(candidate, digits), section, period_s)) {
                return *named;
            }
        }
    }
    return SectionFilter{section};
}

} // namespace halbench::control
