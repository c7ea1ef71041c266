#include "control/lti/responses.h"

#include "control/base/assert.h"
#include "control/lti/discretize.h"
#include "control/lti/hold_matrices.h"
#include "control/lti/realization.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Four samples at once: state and four inputs to the state four samples on and four outputs, by one matrix.
/// Half the products of four single steps, and the inputs' share does not wait for the state.
template <int N>
struct FourSamples {
    static constexpr int Samples = 4;
    static constexpr int Rows = N + Samples + N % 2; // columns stay aligned
    Eigen::Matrix<double, Rows, N + Samples> map = Eigen::Matrix<double, Rows, N + Samples>::Zero();

    explicit FourSamples(const StateSpace& system) {
        Eigen::Matrix<double, N, N + Samples> state = Eigen::Matrix<double, N, N + Samples>::Zero();
        state.template leftCols<N>().setIdentity();
        for (int k = 0; k < Samples; ++k) { // `state` gives x[k] of x[0] and the inputs
            map.row(N + k) = system.C * state;
            map(N + k, N + k) += system.D(0, 0);
            state = (system.A * state).eval();
            state.col(N + k) += system.B.col(0);
        }
        map.template topRows<N>() = state;
    }
};

/// y = C x + D u, x <- A x + B u with everything of fixed size N.
template <int N>
void recur(const StateSpace& system, const VectorXd& start, const std::vector<double>& input,
           double* output) {
    using Four = FourSamples<N>;
    const Four four(system);
    Eigen::Matrix<double, N, 1> x = start;
    const double* u = input.data();
    const double* const end = u + input.size();
    for (; u + Four::Samples <= end; u += Four::Samples, output += Four::Samples) {
        Eigen::Matrix<double, Four::Rows, 1> next = four.map.col(N) * u[0];
        for (int j = 1; j < Four::Samples; ++j) {
            next += four.map.col(N + j) * u[j];
        }
        for (int j = 0; j < N; ++j) {
            next += four.map.col(j) * x(j);
        }
        x = next.template head<N>();
        for (int k = 0; k < Four::Samples; ++k) {
            output[k] = next(N + k);
        }
    }
    VectorXd rest = x;
    for (; u < end; ++u) {
        *output++ = (system.C * rest).value() + system.D(0, 0) * *u;
        rest = (system.A * rest + system.B.col(0) * *u).eval();
    }
}

void recurLarge(const StateSpace& system, const VectorXd& start, const std::vector<double>& input,
                double* output) {
    VectorXd x = start;
    VectorXd next = x;
    const VectorXd c = system.C.row(0).transpose();
    for (const double u : input) {
        *output++ = c.dot(x) + system.D(0, 0) * u;
        next.noalias() = system.A * x;
        x = next + system.B.col(0) * u;
    }
}

/// Output from a state at the first sample.
std::vector<double> simulateFrom(const StateSpace& system, const VectorXd& start,
                                 const std::vector<double>& input) {
    std::vector<double> output(input.size());
    using Recursion = void (*)(const StateSpace&, const VectorXd&, const std::vector<double>&, double*);
    constexpr Recursion Fixed[] = {recurLarge, recur<1>, recur<2>, recur<3>, recur<4>,
                                   recur<5>,   recur<6>, recur<7>, recur<8>};
    const auto n = static_cast<std::size_t>(system.states());
    (n < std::size(Fixed) ? Fixed[n] : Fixed[0])(system, start, input, output.data());
    return output;
}

VectorXd rest(const StateSpace& system) {
    return VectorXd::Zero(system.states());
}

/// Times 0, T, 2 T ... up to the duration.
Result<std::vector<double>> evenTimes(const TransferFunction& system, double duration_s,
                                      double resolution_s) {
    const double period_s = system.timeBase().isSampled() ? system.timeBase().period_s() : resolution_s;
    constexpr double MaxPoints = 1e7;
    if (!(duration_s > 0.0 && period_s > 0.0 && duration_s / period_s < MaxPoints)) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("a step response of {} s in steps of {} s is not possible", duration_s, period_s));
    }
    const auto points = static_cast<std::size_t>(std::floor(duration_s / period_s * (1.0 + 1e-12))) + 1;
    std::vector<double> time_s(points);
    for (std::size_t i = 0; i < points; ++i) {
        time_s[i] = static_cast<double>(i) * period_s;
    }
    return time_s;
}

/// A sampled system's answer to an input of its own; a continuous one's, with the input of the given shape.
Result<TimeResponse> answer(const TransferFunction& system, std::vector<double> time_s,
                            const std::vector<double>& input, InputShape shape) {
    if (system.timeBase().isSampled()) {
        return TimeResponse{std::move(time_s), simulate(system, input)};
    }
    if (time_s.size() < 2) {
        return TimeResponse{std::move(time_s), {toStateSpace(system).D(0, 0) * input.front()}};
    }
    return respond(toStateSpace(system), time_s, input, shape);
}

Result<void> check(const StateSpace& system, const std::vector<double>& time_s,
                   const std::vector<double>& input) {
    if (system.timeBase.isSampled()) {
        return failure(ErrorCode::InvalidInput, "the system is already sampled");
    }
    if (system.inputs() != 1 || system.outputs() != 1) {
        return failure(ErrorCode::InvalidInput, "a response needs a system with one input and one output");
    }
    const bool ascends = std::adjacent_find(time_s.begin(), time_s.end(),
                                            [](double a, double b) { return !(b > a); }) == time_s.end();
    if (time_s.size() < 2 || input.size() != time_s.size() || !ascends) {
        return failure(ErrorCode::InvalidInput, "a response needs ascending times, each with its input");
    }
    return {};
}

bool isEven(const std::vector<double>& time_s, double period_s) {
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        if (std::abs(time_s[i] - time_s.front() - static_cast<double>(i) * period_s) > 1e-9 * period_s) {
            return false;
        }
    }
    return true;
}

std::vector<double> respondUnevenly(const StateSpace& system, const std::vector<double>& time_s,
                                    const std::vector<double>& input, InputShape shape) {
    std::vector<double> output;
    output.reserve(input.size());
    VectorXd x = rest(system);
    HeldInput held;
    double heldFor_s = 0.0;
    for (std::size_t i = 0; i < input.size(); ++i) {
        output.push_back((system.C * x).value() + system.D(0, 0) * input[i]);
        if (i + 1 == input.size()) {
            break;
        }
        const double interval_s = time_s[i + 1] - time_s[i];
        if (std::abs(interval_s - heldFor_s) > 1e-13 * interval_s) {
            held = heldInput(system.A, system.B, interval_s);
            heldFor_s = interval_s;
        }
        const double rise = shape == InputShape::Straight ? input[i + 1] - input[i] : 0.0;
        x = held.transition * x + held.constant * input[i] + held.slope * rise;
    }
    return output;
}

} // namespace

std::vector<double> simulate(const TransferFunction& sampledSystem, const std::vector<double>& input) {
    return simulate(toStateSpace(sampledSystem), input);
}

std::vector<double> simulate(const StateSpace& sampledSystem, const std::vector<double>& input) {
    HB_ASSERT(sampledSystem.timeBase.isSampled() && sampledSystem.inputs() == 1 &&
              sampledSystem.outputs() == 1);
    return simulateFrom(sampledSystem, rest(sampledSystem), input);
}

Result<TimeResponse> respond(const StateSpace& system, const std::vector<double>& time_s,
                             const std::vector<double>& input, InputShape shape) {
    if (const auto valid = check(system, time_s, input); !valid) {
        return failure(valid.error());
    }
    const StateSpace scaled = prescaled(system);
    const double period_s = (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
    if (!isEven(time_s, period_s)) {
        return TimeResponse{time_s, respondUnevenly(scaled, time_s, input, shape)};
    }
    if (shape == InputShape::Held) {
        return TimeResponse{time_s, simulate(*discretize(scaled, period_s, Hold::Zoh{}), input)};
    }
    // The shifted state x - slope u of the first-order hold begins at rest with -slope u[0].
    const StateSpace sampled = *discretize(scaled, period_s, Hold::Foh{});
    const VectorXd start = -heldInput(scaled.A, scaled.B, period_s).slope * input.front();
    return TimeResponse{time_s, simulateFrom(sampled, start, input)};
}

Result<TimeResponse> stepResponse(const TransferFunction& system, double duration_s, double resolution_s) {
    auto time_s = evenTimes(system, duration_s, resolution_s);
    if (!time_s) {
        return failure(time_s.error());
    }
    const std::vector<double> input(time_s->size(), 1.0);
    return answer(system, std::move(*time_s), input, InputShape::Held);
}

Result<TimeResponse> impulseResponse(const TransferFunction& system, double duration_s, double resolution_s) {
    auto time_s = evenTimes(system, duration_s, resolution_s);
    if (!time_s) {
        return failure(time_s.error());
    }
    const double period_s = system.timeBase().isSampled() ? system.timeBase().period_s() : resolution_s;
    std::vector<double> input(time_s->size(), 0.0);
    input.front() = 1.0 / period_s;
    if (system.timeBase().isSampled()) {
        return answer(system, std::move(*time_s), input, InputShape::Held);
    }
    // The impulse-invariant rule answers one sample of 1/T with h(k T).
    const auto sampled = discretize(prescaled(toStateSpace(system)), period_s, Hold::Impulse{});
    if (!sampled) {
        return failure(sampled.error());
    }
    return TimeResponse{std::move(*time_s), simulate(*sampled, input)};
}

Result<TimeResponse> rampResponse(const TransferFunction& system, double duration_s, double resolution_s) {
    auto time_s = evenTimes(system, duration_s, resolution_s);
    if (!time_s) {
        return failure(time_s.error());
    }
    const std::vector<double> input = *time_s;
    return answer(system, std::move(*time_s), input, InputShape::Straight);
}

} // namespace halbench::control
