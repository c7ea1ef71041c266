#pragma once

#include "control/base/random.h"
#include "control/design/optimal_designs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace halbench::control {

/// The least error after a load within a peak of sensitivity, found in another way than the design finds it:
/// the law and the motor written out sample by sample, the sensitivity from the books' formula, and many
/// descents of a search from random gains.
class LeastErrorSearch {
public:
    using Logarithms =
        std::array<double, 3>; ///< of K_P, K_I, K_D in units of 1/(k T_s^2), 1/(k T_s^3), 1/(k T_s)

    LeastErrorSearch(const PositionPlant& plant, const LoopTiming& timing, const LeastErrorTargets& targets)
        : m_a(plant.dampingRate_1_s), m_k(plant.accelerationGain_rad_s2_A), m_period_s(timing.period_s),
          m_delay(static_cast<std::size_t>(timing.delay_samples)), m_targets(targets) {
        m_decay = std::exp(-m_a * m_period_s);
    }

    /// Of gains that keep the bound to a thousandth; infinite for others.
    double errorOf(const PidGains& gains) const {
        return sensitivityOf(gains) <= 1.001 * m_targets.mostMs_ratio
                   ? measureOf(gains)
                   : std::numeric_limits<double>::infinity();
    }

    /// The least of `starts` descents.
    double least(int starts, std::uint64_t seed) const {
        Random random(seed);
        double best = std::numeric_limits<double>::infinity();
        for (int start = 0; start < starts;) {
            const Logarithms from = {drawn(random, 1e-4, 3.0), drawn(random, 1e-7, 1.0),
                                     drawn(random, 1e-3, 2.0)};
            if (!std::isfinite(costOf(from))) {
                continue;
            }
            best = std::min(best, descent(from));
            ++start;
        }
        return best;
    }

private:
    /// Between the ends, evenly in the logarithm.
    static double drawn(Random& random, double from, double to) {
        return std::lerp(std::log(from), std::log(to), random.uniform());
    }

    PidGains gainsOf(const Logarithms& at) const {
        const double scale = m_k * m_period_s;
        PidGains gains;
        gains.proportional = std::exp(at[0]) / (scale * m_period_s);
        gains.integral = std::exp(at[1]) / (scale * m_period_s * m_period_s);
        gains.derivative = std::exp(at[2]) / scale;
        return gains;
    }

    /// Ends when half a thousand samples add nothing; infinite for a loop that does not come to rest.
    double measureOf(const PidGains& gains) const {
        const bool isWeighed = m_targets.measure == ErrorMeasure::Itae;
        double angle = 0.0, speed = 0.0, last = 0.0, integral = 0.0, sum = 0.0, block = 0.0;
        std::array<double, 3> asked{}; // newest first
        for (int i = 0; i < 60000; ++i) {
            asked = {integral - gains.proportional * angle - gains.derivative * (angle - last) / m_period_s,
                     asked[0], asked[1]};
            integral -= m_period_s * gains.integral * angle;
            last = angle;
            block += m_period_s * std::abs(angle) * (isWeighed ? i * m_period_s : 1.0);
            const double final_rad_s = m_k / m_a * (asked[m_delay] + 1.0);
            angle += final_rad_s * m_period_s + (speed - final_rad_s) * (1.0 - m_decay) / m_a;
            speed = final_rad_s + (speed - final_rad_s) * m_decay;
            if (!(std::abs(angle) < 1e6)) {
                break;
            }
            if (i % 500 == 499) {
                sum += block;
                if (block < 1e-7 * sum) {
                    return sum;
                }
                block = 0.0;
            }
        }
        return std::numeric_limits<double>::infinity();
    }

    /// 1/min |1 + L| at 1000 frequencies up to Nyquist, 0.7 % apart: a coarser grid misses so much of a peak
    /// that this search would find gains beyond the bound.
    double sensitivityOf(const PidGains& gains) const {
        const double aT = m_a * m_period_s;
        const double b1 = m_k / (m_a * m_a) * (aT - 1.0 + m_decay);
        const double b2 = m_k / (m_a * m_a) * (1.0 - m_decay - aT * m_decay);
        constexpr int Points = 1000;
        double nearest = 1.0;
        for (int i = 0; i < Points; ++i) {
            const double angle = 3.14159265358979 * std::pow(1e-3, 1.0 - (i + 1.0) / Points);
            const std::complex<double> z = std::polar(1.0, angle);
            const std::complex<double> law = gains.proportional + m_period_s * gains.integral / (z - 1.0) +
                                             gains.derivative / m_period_s * (z - 1.0) / z;
            const std::complex<double> motor = (b1 * z + b2) / ((z - 1.0) * (z - m_decay));
            const std::complex<double> late = std::polar(1.0, -angle * static_cast<double>(m_delay));
            nearest = std::min(nearest, std::abs(1.0 + law * motor * late));
        }
        return 1.0 / nearest;
    }

    double costOf(const Logarithms& at) const {
        const PidGains gains = gainsOf(at);
        const double error = measureOf(gains);
        return std::isfinite(error)
                   ? error * (1.0 + 1e3 * std::max(0.0, sensitivityOf(gains) / m_targets.mostMs_ratio - 1.0))
                   : error;
    }

    /// Random steps that shrink while none is better: slow, and held up by no kink.
    double descent(Logarithms at) const {
        Random random(7);
        double best = costOf(at);
        double size = 0.7;
        int failures = 0;
        while (size > 1e-3) {
            Logarithms next = at;
            for (double& value : next) {
                value += size * (2.0 * random.uniform() - 1.0);
            }
            const double cost = costOf(next);
            if (cost < best) {
                best = cost;
                at = next;
                failures = 0;
                size *= 1.2;
            } else if (++failures == 25) {
                failures = 0;
                size *= 0.6;
            }
        }
        return best;
    }

    double m_a;
    double m_k;
    double m_period_s;
    std::size_t m_delay;
    LeastErrorTargets m_targets;
    double m_decay = 1.0;
};

} // namespace halbench::control
