#pragma once

#include "control/base/result.h"
#include "control/lti/frequency_response.h"
#include "control/lti/state_space.h"

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

namespace halbench::control {

/// One path of a state space system made ready for many values of s or z: A upper Hessenberg, so that
/// (s - A) x = B costs one elimination of O(n^2) with row exchanges (Laub 1981). Companion forms and chains
/// of sections (`toStateSpace`) have that shape already, or backwards, and stay as they are but for an exact
/// scaling: their value is right to about n roundings, however far apart their rates lie. Any other A is
/// prescaled and turned by orthogonal transformations: the value is exact for a system whose [A B C] differ
/// in the rounding of their norm, a relative error of up to 1e-15 |A| |(s - A)^-1|.
class StatePath {
public:
    /// Indices must exist.
    explicit StatePath(const StateSpace& system, Eigen::Index output = 0, Eigen::Index input = 0);

    std::complex<double> at(std::complex<double> point) const;
    std::complex<double> atFrequency(double frequency_rad_s) const;

private:
    TimeBase m_timeBase;
    std::size_t m_size = 0;
    std::vector<double> m_rows;   ///< A row by row, n each
    std::vector<double> m_input;  ///< B
    std::vector<double> m_output; ///< C
    double m_direct = 0.0;        ///< D
};

/// Errors: OutOfRange for a frequency that is not positive or lies above the Nyquist frequency, and for an
/// input or output that does not exist.
Result<FrequencyResponse> frequencyResponse(const StateSpace& system,
                                            const std::vector<double>& frequency_rad_s,
                                            Eigen::Index output = 0, Eigen::Index input = 0);

} // namespace halbench::control
