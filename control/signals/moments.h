#pragma once

#include <cmath>
#include <cstdint>

namespace halbench::control {

/// Count, mean and spread of some values, without those that are not finite. Adding keeps every digit that
/// counts: sums of squares of a large constant part would not (Welford 1962; Chan, Golub and LeVeque 1983).
class Moments {
public:
    std::uint64_t count() const { return m_count; }
    std::uint64_t missing() const { return m_missing; } ///< values that are not finite
    double mean() const { return m_mean; }
    /// Root of the mean square.
    double rms() const { return std::sqrt(m_mean * m_mean + variance(0)); }
    /// Standard deviation of the values as a sample; 0 of fewer than two.
    double deviation() const { return m_count > 1 ? std::sqrt(variance(1)) : 0.0; }

    void add(double value) {
        if (!std::isfinite(value)) {
            ++m_missing;
            return;
        }
        ++m_count;
        const double away = value - m_mean;
        m_mean += away / static_cast<double>(m_count);
        m_squares += away * (value - m_mean);
    }

    void add(const Moments& other) {
        m_missing += other.m_missing;
        if (other.m_count == 0) {
            return;
        }
        const auto own = static_cast<double>(m_count);
        const auto added = static_cast<double>(other.m_count);
        const double away = other.m_mean - m_mean;
        m_mean += away * added / (own + added);
        m_squares += other.m_squares + away * away * own * added / (own + added);
        m_count += other.m_count;
    }

private:
    double variance(std::uint64_t lostFreedom) const {
        return m_count > lostFreedom ? m_squares / static_cast<double>(m_count - lostFreedom) : 0.0;
    }

    std::uint64_t m_count = 0;
    std::uint64_t m_missing = 0;
    double m_mean = 0.0;
    double m_squares = 0.0; ///< sum of squared distances from the mean
};

} // namespace halbench::control
