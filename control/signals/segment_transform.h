#pragma once

#include "control/signals/window.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace halbench::control {

/// Length nearest to `rows` and not above `most` (both >= 1) that has no prime factor but 2, 3 and 5: others
/// make the transform slow, a prime length quadratic.
std::size_t fastLength(std::size_t rows, std::size_t most);

/// The discrete Fourier transform of segments of one length, windowed. Owns its tables and work space, so
/// that any number of them work beside each other; each belongs to one thread at a time.
///
/// Eigen's transform (kissfft) and not FFTW: nothing is shared between threads, no plan depends on what ran
/// before or on the processor, so that equal data give equal bytes on every machine; its speed is enough (see
/// fastLength()).
class SegmentTransform {
public:
    /// `length` >= 2.
    SegmentTransform(WindowShape shape, std::size_t length, bool removesMean);
    ~SegmentTransform();

    std::size_t length() const { return m_weights.size(); }
    /// Lines from zero to half the rate.
    std::size_t lines() const { return m_weights.size() / 2 + 1; }
    const std::vector<double>& weights() const { return m_weights; }

    /// |X_k|^2 of X_k = sum_n w_n x_n exp(-2 pi i k n / N), k = 0 ... N/2, of `samples` (N of them, finite);
    /// valid until the next call.
    const std::vector<double>& powers(std::span<const double> samples);

private:
    struct Work;

    std::vector<double> m_weights;
    bool m_removesMean;
    std::unique_ptr<Work> m_work;
    std::vector<double> m_powers;
};

} // namespace halbench::control
