#include "control/identify/adequacy.h"

#include "control/base/assert.h"
#include "control/base/distributions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace halbench::control {
namespace {

std::vector<std::size_t> orderByLevel(std::span<const double> levels) {
    std::vector<std::size_t> order(levels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [levels](std::size_t a, std::size_t b) { return levels[a] < levels[b]; });
    return order;
}

bool isSameLevel(double a, double b) {
    return std::fabs(a - b) <= 1e-9 * std::max(std::fabs(a), std::fabs(b));
}

} // namespace

Result<LackOfFit> testLackOfFit(std::span<const double> levels, std::span<const double> residuals,
                                int parameters) {
    HB_ASSERT(levels.size() == residuals.size() && parameters > 0);
    const std::vector<std::size_t> order = orderByLevel(levels);
    double pure = 0.0;
    int groups = 0;
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin;
        double sum = 0.0;
        while (end < order.size() && isSameLevel(levels[order[begin]], levels[order[end]])) {
            sum += residuals[order[end++]];
        }
        const double mean = sum / static_cast<double>(end - begin);
        for (std::size_t i = begin; i < end; ++i) {
            pure += (residuals[order[i]] - mean) * (residuals[order[i]] - mean);
        }
        ++groups;
        begin = end;
    }
    LackOfFit test;
    test.pureFreedom = static_cast<int>(levels.size()) - groups;
    test.lackFreedom = groups - parameters;
    if (test.pureFreedom < 1 || test.lackFreedom < 1) {
        return failure(ErrorCode::Refused, "no repeated points to check the model", "repeat some currents");
    }
    double total = 0.0;
    for (const double residual : residuals) {
        total += residual * residual;
    }
    const double pureVariance = pure / test.pureFreedom;
    const double lackVariance = std::max(total - pure, 0.0) / test.lackFreedom;
    test.ratio = pureVariance > 0.0 ? lackVariance / pureVariance : 0.0;
    test.probability = fisherTail(test.ratio, test.lackFreedom, test.pureFreedom);
    return test;
}

RunsTest testRuns(std::span<const double> residuals) {
    RunsTest test;
    double positive = 0.0;
    double negative = 0.0;
    int last = 0;
    for (const double residual : residuals) {
        const int sign = residual > 0.0 ? 1 : -1;
        (sign > 0 ? positive : negative) += 1.0;
        if (sign != last) {
            ++test.runs;
            last = sign;
        }
    }
    if (positive < 5.0 || negative < 5.0) {
        return test;
    }
    const double count = positive + negative;
    const double product = 2.0 * positive * negative;
    test.expected = 1.0 + product / count;
    const double variance = product * (product - count) / (count * count * (count - 1.0));
    test.probability = normalProbability((test.runs + 0.5 - test.expected) / std::sqrt(variance));
    return test;
}

} // namespace halbench::control
