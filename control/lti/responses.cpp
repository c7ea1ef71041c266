#include "control/lti/responses.h"

#include "control/base/assert.h"
#include "control/lti/discretize.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::control {

std::vector<double> simulate(const TransferFunction& sampledSystem, const std::vector<double>& input) {
    HB_ASSERT(sampledSystem.timeBase().isSampled());
    const StateSpace system = toStateSpace(sampledSystem);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(system.states());
    std::vector<double> output;
    output.reserve(input.size());
    for (const double u : input) {
        output.push_back((system.C * x).value() + system.D(0, 0) * u);
        x = system.A * x + system.B.col(0) * u;
    }
    return output;
}

Result<TimeResponse> stepResponse(const TransferFunction& system, double duration_s, double resolution_s) {
    const double period_s = system.timeBase().isSampled() ? system.timeBase().period_s() : resolution_s;
    constexpr double MaxPoints = 1e7;
    if (!(duration_s > 0.0 && period_s > 0.0 && duration_s / period_s < MaxPoints)) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("a step response of {} s in steps of {} s is not possible", duration_s, period_s));
    }
    Result<TransferFunction> sampled = system;
    if (system.timeBase().isContinuous()) {
        sampled = discretize(system, period_s, Hold::Zoh{});
        if (!sampled) {
            return failure(sampled.error());
        }
    }
    const auto points = static_cast<std::size_t>(std::floor(duration_s / period_s * (1.0 + 1e-12))) + 1;
    TimeResponse response;
    response.value = simulate(*sampled, std::vector<double>(points, 1.0));
    for (std::size_t i = 0; i < points; ++i) {
        response.time_s.push_back(static_cast<double>(i) * period_s);
    }
    return response;
}

} // namespace halbench::control
