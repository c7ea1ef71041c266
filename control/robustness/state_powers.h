#pragma once

#include "control/robustness/batch_simulation.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace halbench::control {

/// Many samples of a linear loop at once: x[k + N] = A^N x[k] + (A^(N-1) + ... + 1) b, from the powers of two
/// of the map that one sample makes. Exact but for rounding, some 1e-16 of the
/// motion for each sample that is leapt over.
class StatePowers {
public:
    /// One sample of the loop, with so much reference and load.
    using Sample = std::function<void(BatchState& state, double reference_rad, double load_A)>;

    /// Of a loop whose currents come so many samples late, for leaps of up to `longest` samples; `run` has
    /// one point a sample.
    StatePowers(const Sample& sample, std::size_t delay_samples, const BatchRun& run, std::size_t longest);

    /// How many samples are worth a leap.
    static std::size_t shortest(std::size_t delay_samples);
    /// Of `longest` samples at most.
    void leap(BatchState& state, std::size_t samples) const;

private:
    using Lanes = BatchState::Lanes;
    using Vector = std::vector<Lanes>;
    /// Column after column; the last of the state is one, which brings in the reference and the load.
    using Matrix = std::vector<Lanes>;

    Vector product(const Matrix& matrix, const Vector& vector) const;
    Matrix square(const Matrix& matrix) const;

    std::size_t m_delay;
    std::size_t m_size;
    std::vector<Matrix> m_powers; ///< of 1, 2, 4, ... samples
};

} // namespace halbench::control
