#include "control/signals/segment_transform.h"

#include "control/base/assert.h"

#include <algorithm>
#include <complex>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace halbench::control {
namespace {

bool isFastLength(std::size_t rows) {
    for (const std::size_t factor : {2U, 3U, 5U}) {
        while (rows % factor == 0) {
            rows /= factor;
        }
    }
    return rows == 1;
}

} // namespace

struct SegmentTransform::Work {
    Eigen::FFT<double> transform{Eigen::default_fft_impl<double>(), Eigen::FFT<double>::HalfSpectrum};
    std::vector<double> samples;
    std::vector<std::complex<double>> lines;
};

std::size_t fastLength(std::size_t rows, std::size_t most) {
    HB_ASSERT(rows >= 1 && most >= 1);
    std::size_t above = rows;
    while (above <= most && !isFastLength(above)) {
        ++above;
    }
    std::size_t below = std::min(rows, most);
    while (!isFastLength(below)) {
        --below;
    }
    return above <= most && above - rows < rows - below ? above : below;
}

SegmentTransform::SegmentTransform(WindowShape shape, std::size_t length, bool removesMean)
    : m_weights(window(shape, length)), m_removesMean(removesMean), m_work(std::make_unique<Work>()) {
    HB_ASSERT(length >= 2);
    m_powers.resize(lines());
}

SegmentTransform::~SegmentTransform() = default;

const std::vector<double>& SegmentTransform::powers(std::span<const double> samples) {
    HB_ASSERT(samples.size() == length());
    std::vector<double>& work = m_work->samples;
    work.assign(samples.begin(), samples.end());
    if (m_removesMean) {
        // From the first sample on, so that a constant leaves nothing, not even rounding.
        for (double& value : work) {
            value -= samples.front();
        }
        const double mean = std::accumulate(work.begin(), work.end(), 0.0) / static_cast<double>(length());
        for (double& value : work) {
            value -= mean;
        }
    }
    for (std::size_t i = 0; i < length(); ++i) {
        work[i] *= m_weights[i];
    }
    m_work->transform.fwd(m_work->lines, work);
    HB_ASSERT(m_work->lines.size() == lines());
    for (std::size_t line = 0; line < lines(); ++line) {
        m_powers[line] = std::norm(m_work->lines[line]);
    }
    return m_powers;
}

} // namespace halbench::control
