#pragma once

#include "control/base/result.h"
#include "control/lti/frequency_response.h"
#include "control/lti/state_space.h"

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

namespace halbench::control {

/// One path of a state space system made ready for many values of s or z, so that (s - A) x = B costs O(n^2).
/// Chains of sections (`toStateSpace`), which are triangles of blocks of one or two states, and companion
/// forms, which are upper Hessenberg, stay as they are but for an exact scaling: the one is substituted, the
/// other eliminated with row exchanges (Laub 1981), and their value is right to about n roundings, however
/// far apart their rates lie. Any other A is prescaled and turned by orthogonal transformations into such a
/// triangle (its real Schur form): the value is exact for a system whose [A B C] differ in the rounding of
/// their norm, a relative error of up to 1e-15 |A| |(s - A)^-1|.
class StatePath {
public:
    /// Indices must exist.
    explicit StatePath(const StateSpace& system, Eigen::Index output = 0, Eigen::Index input = 0);

    std::complex<double> at(std::complex<double> point) const;
    std::complex<double> atFrequency(double frequency_rad_s) const;

private:
    void eliminated(std::complex<double> point, double* re, double* im) const;
    void substituted(std::complex<double> point, double* re, double* im) const;

    TimeBase m_timeBase;
    std::size_t m_size = 0;
    bool m_isTriangle = false;
    std::vector<double> m_matrix; ///< A, n each: a triangle column by column, else row by row
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
