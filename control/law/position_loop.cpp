#include "control/law/position_loop.h"

#include "control/base/assert.h"
#include "control/law/board_gains.h"
#include "control/law/gain_limit.h"
#include "control/law/sampled_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

Result<TransferFunction> seriesOf(const Result<TransferFunction>& first, const TransferFunction& second) {
    return first ? series(*first, second) : first;
}

} // namespace

Result<PidGains> boardGains(const PidGains& gains) {
    auto board = convert(gains, PidForm::Parallel, GainUnit::PerRadian);
    if (!board) {
        return board;
    }
    if (board->derivative != 0.0 && board->filter_s.value_or(0.0) > 0.0) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format(
                "the device's control law has no derivative filter; these gains have a filter of {:.4g} s",
                *board->filter_s),
            "omit the filter (filter_s null): the device uses the difference of two samples; if the noise is "
            "too large, reduce K_D");
    }
    board->filter_s.reset();
    return board;
}

Result<void> checkPlant(const PositionPlant& plant) {
    if (!std::isfinite(plant.dampingRate_1_s) || !std::isfinite(plant.accelerationGain_rad_s2_A) ||
        !std::isfinite(plant.breakawayCurrent_A)) {
        return failure(ErrorCode::NotFinite, "a constant of the motor model is not a finite number");
    }
    if (plant.accelerationGain_rad_s2_A <= 0.0 || plant.dampingRate_1_s < 0.0 ||
        plant.breakawayCurrent_A < 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("phi/J = {:.4g}, c/J = {:.4g}, K_f/phi = {:.4g} is not a valid motor: "
                                   "torque per ampere must be positive, damping and friction not negative",
                                   plant.accelerationGain_rad_s2_A, plant.dampingRate_1_s,
                                   plant.breakawayCurrent_A),
                       "identify the motor again");
    }
    return {};
}

Result<void> checkTiming(const LoopTiming& timing) {
    if (const auto base = TimeBase::sampledChecked(timing.period_s); !base) {
        return failure(base.error());
    }
    constexpr int MaxDelay = 10;
    if (timing.delay_samples < 0 || timing.delay_samples > MaxDelay) {
        return failure(ErrorCode::OutOfRange, fmt::format("a delay of {} samples is not between 0 and {}",
                                                          timing.delay_samples, MaxDelay));
    }
    return {};
}

TransferFunction continuousPlant(const PositionPlant& plant) {
    const auto system = TransferFunction::make({plant.accelerationGain_rad_s2_A},
                                               {1.0, plant.dampingRate_1_s, 0.0}, TimeBase::continuous());
    HB_ASSERT(system.has_value());
    return *system;
}

TransferFunction sampledPlant(const PositionPlant& plant, double period_s) {
    const double x = plant.dampingRate_1_s * period_s;
    const double decay = std::exp(-x);
    const double scale = plant.accelerationGain_rad_s2_A * period_s * period_s;
    const double b1 = scale * heldAngleShare(x);
    const double b2 = scale * (heldSpeedShare(x) - heldAngleShare(x));
    const auto system =
        TransferFunction::make({b1, b2}, {1.0, -(1.0 + decay), decay}, TimeBase::sampled(period_s));
    HB_ASSERT(system.has_value());
    return *system;
}

Result<TransferFunction> sampledController(const PidGains& gains, double period_s) {
    const auto board = boardGains(gains);
    if (!board) {
        return failure(board.error());
    }
    const auto base = TimeBase::sampledChecked(period_s);
    if (!base) {
        return failure(base.error());
    }
    // A term that is zero adds no pole: an integrator nobody feeds would sit on the unit circle for ever.
    const auto proportional = TransferFunction::gain(board->proportional, *base);
    Result<TransferFunction> sum = proportional;
    if (board->integral != 0.0) {
        const auto integral = TransferFunction::make({period_s * board->integral}, {1.0, -1.0}, *base);
        sum = integral ? parallel(*sum, *integral) : integral;
    }
    if (sum && board->derivative != 0.0) {
        const double slope = board->derivative / period_s;
        const auto derivative = TransferFunction::make({slope, -slope}, {1.0, 0.0}, *base);
        sum = derivative ? parallel(*sum, *derivative) : derivative;
    }
    return sum;
}

Result<TransferFunction> sampledOpenLoop(const PositionPlant& plant, const PidGains& gains,
                                         const LoopTiming& timing) {
    if (const auto valid = checkPlant(plant); !valid) {
        return failure(valid.error());
    }
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    const auto delayed = seriesOf(sampledController(gains, timing.period_s),
                                  TransferFunction::delay(timing.delay_samples, timing.period_s));
    return seriesOf(delayed, sampledPlant(plant, timing.period_s));
}

Result<TransferFunction> continuousOpenLoop(const PositionPlant& plant, const PidGains& gains) {
    if (const auto valid = checkPlant(plant); !valid) {
        return failure(valid.error());
    }
    const auto board = convert(gains, PidForm::Parallel, GainUnit::PerRadian);
    if (!board) {
        return failure(board.error());
    }
    if (board->filter_s.value_or(0.0) > 0.0) {
        return seriesOf(continuousController(*board), continuousPlant(plant));
    }
    Polynomial numerator = {board->derivative, board->proportional};
    Polynomial denominator = {1.0, plant.dampingRate_1_s, 0.0};
    if (board->integral != 0.0) {
        numerator.push_back(board->integral);
        denominator.push_back(0.0);
    }
    return TransferFunction::make(scale(numerator, plant.accelerationGain_rad_s2_A), std::move(denominator),
                                  TimeBase::continuous());
}

std::vector<std::complex<double>> closedLoopPoles(const TransferFunction& openLoop) {
    return roots(add(openLoop.numerator(), openLoop.denominator()));
}

double poleRadius(const TransferFunction& openLoop) {
    double radius = 0.0;
    for (const auto& pole : closedLoopPoles(openLoop)) {
        radius = std::max(radius, std::abs(pole));
    }
    return radius;
}

double largestStableGain(const PositionPlant& plant, const LoopTiming& timing,
                         const std::function<bool(double)>& isStableAt) {
    // 1/(k T^2) turns the rotor by one radian per sample and radian: far beyond any stable gain.
    const double scale = 1.0 / (plant.accelerationGain_rad_s2_A * timing.period_s * timing.period_s);
    double stable = 1e-6 * scale;
    if (!isStableAt(stable)) {
        return 0.0;
    }
    double unstable = stable;
    while (unstable < 1e3 * scale && isStableAt(unstable)) {
        stable = unstable;
        unstable *= 1.1;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (stable + unstable);
        (isStableAt(middle) ? stable : unstable) = middle;
    }
    return stable;
}

double proportionalLimit_A_per_rad(const PositionPlant& plant, const LoopTiming& timing,
                                   double derivative_A_s_per_rad) {
    const auto isStableAt = [&](double proportional) {
        PidGains gains;
        gains.proportional = proportional;
        gains.derivative = derivative_A_s_per_rad;
        const auto loop = sampledOpenLoop(plant, gains, timing);
        return loop.has_value() && poleRadius(*loop) < 1.0;
    };
    return largestStableGain(plant, timing, isStableAt);
}

double frictionBand_rad(double breakaway_A, double proportional_A_per_rad, double assist_A,
                        double assistThreshold_rad) {
    const double unaided_rad = breakaway_A / proportional_A_per_rad;
    if (assist_A <= 0.0) {
        return unaided_rad;
    }
    return std::max((breakaway_A - assist_A) / proportional_A_per_rad,
                    std::min(assistThreshold_rad, unaided_rad));
}

double frictionBand_rad(const PositionPlant& plant, const PositionLaw& law) {
    const auto parallel = convert(law.gains, PidForm::Parallel, GainUnit::PerRadian);
    HB_ASSERT(parallel.has_value());
    return frictionBand_rad(plant.breakawayCurrent_A, parallel->proportional, law.stictionCurrent_A,
                            law.stictionThreshold_rad);
}

} // namespace halbench::control
