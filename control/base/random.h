#pragma once

#include <cstdint>

namespace halbench {

/// Deterministic random numbers, the same on every machine and compiler (the standard library's distributions
/// are not). Generator: xoshiro256++ (Blackman and Vigna 2019) seeded by SplitMix64.
class Random {
public:
    explicit Random(std::uint64_t seed);

    std::uint64_t bits();
    /// Uniform in [0, 1) with 53 bits.
    double uniform();
    /// Standard normal, by the polar method of Marsaglia.
    double gaussian();
    /// Uniform integer in [0, bound); bound > 0.
    std::uint64_t below(std::uint64_t bound);
    /// An independent generator for one purpose, so that adding a draw elsewhere does not change this one.
    Random fork(std::uint64_t stream) const;

private:
    std::uint64_t m_state[4];
    std::uint64_t m_seed;
    double m_spare = 0.0;
    bool m_hasSpare = false;
};

} // namespace halbench
