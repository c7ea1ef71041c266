#include "control/lti/state_response.h"

#include "control/base/assert.h"
#include "control/lti/realization.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::control {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Householder vector that turns `x` onto its first axis; empty when it lies there already.
VectorXd mirrorOntoFirst(const VectorXd& x) {
    if (x.tail(x.size() - 1).cwiseAbs().maxCoeff() == 0.0) {
        return {};
    }
    VectorXd mirror = x;
    mirror(0) += (x(0) < 0.0 ? -1.0 : 1.0) * x.norm();
    return mirror.normalized();
}

/// A column by column to Hessenberg form.
void turnToHessenberg(StateSpace& system) {
    const Index n = system.states();
    for (Index k = 1; k + 1 < n; ++k) {
        const Index rest = n - k;
        const VectorXd mirror = mirrorOntoFirst(system.A.col(k - 1).tail(rest));
        if (mirror.size() == 0) {
            continue;
        }
        system.A.bottomRows(rest) -= 2.0 * mirror * (mirror.transpose() * system.A.bottomRows(rest)).eval();
        system.A.rightCols(rest) -= 2.0 * (system.A.rightCols(rest) * mirror).eval() * mirror.transpose();
        system.B.bottomRows(rest) -= 2.0 * mirror * (mirror.transpose() * system.B.bottomRows(rest)).eval();
        system.C.rightCols(rest) -= 2.0 * (system.C.rightCols(rest) * mirror).eval() * mirror.transpose();
    }
}

bool isHessenberg(const MatrixXd& A) {
    for (Index column = 0; column + 2 < A.cols(); ++column) {
        if (!A.col(column).tail(A.rows() - column - 2).isZero(0.0)) {
            return false;
        }
    }
    return true;
}

StateSpace backwards(const StateSpace& system) {
    return {system.A.reverse(), system.B.colwise().reverse(), system.C.rowwise().reverse(), system.D,
            system.timeBase};
}

/// Not set to zero: the room for a small system is larger than what most of them use, at each frequency.
struct Value {
    double re;
    double im;
};

// Written out: the compiler's complex product and quotient check every factor for infinities.
Value times(Value a, Value b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

Value inverse(Value a) {
    const double scale = 1.0 / (a.re * a.re + a.im * a.im);
    return {a.re * scale, -a.im * scale};
}

double size(Value a) {
    return std::abs(a.re) + std::abs(a.im);
}

/// The rows of [s - A, B], brought to a triangle in place, with the inverse of each pivot on its diagonal.
void eliminate(Value* rows, std::size_t n) {
    const std::size_t width = n + 1;
    for (std::size_t k = 0; k < n; ++k) {
        Value* upper = rows + k * width;
        Value* lower = upper + width;
        if (k + 1 == n || size(lower[k]) == 0.0) {
            upper[k] = inverse(upper[k]);
            continue;
        }
        if (size(lower[k]) > size(upper[k])) {
            std::swap_ranges(upper + k, upper + width, lower + k);
        }
        upper[k] = inverse(upper[k]);
        const Value factor = times(lower[k], upper[k]);
        for (std::size_t j = k + 1; j < width; ++j) {
            const Value product = times(factor, upper[j]);
            lower[j].re -= product.re;
            lower[j].im -= product.im;
        }
    }
}

/// x in the last column of the rows, from the last state up.
void substitute(Value* rows, std::size_t n) {
    const std::size_t width = n + 1;
    for (std::size_t k = n; k-- > 0;) {
        Value* row = rows + k * width;
        for (std::size_t j = k + 1; j < n; ++j) {
            const Value product = times(row[j], rows[j * width + n]);
            row[n].re -= product.re;
            row[n].im -= product.im;
        }
        row[n] = times(row[n], row[k]);
    }
}

} // namespace

StatePath::StatePath(const StateSpace& system, Index output, Index input)
    : m_timeBase(system.timeBase), m_size(static_cast<std::size_t>(system.states())),
      m_direct(system.D(output, input)) {
    StateSpace path = prescaled(
        {system.A, system.B.col(input), system.C.row(output), MatrixXd::Zero(1, 1), system.timeBase});
    if (!isHessenberg(path.A)) {
        path = backwards(path);
    }
    if (!isHessenberg(path.A)) {
        turnToHessenberg(path);
    }
    for (Index i = 0; i < path.A.rows(); ++i) {
        for (Index j = 0; j < path.A.cols(); ++j) {
            m_rows.push_back(j + 1 < i ? 0.0 : path.A(i, j));
        }
    }
    m_input.assign(path.B.data(), path.B.data() + m_size);
    m_output.assign(path.C.data(), path.C.data() + m_size);
}

std::complex<double> StatePath::at(std::complex<double> point) const {
    constexpr std::size_t SmallSize = 12;
    const std::size_t n = m_size;
    std::array<Value, SmallSize*(SmallSize + 1)> small;
    std::vector<Value> large(n > SmallSize ? n * (n + 1) : 0);
    Value* rows = n > SmallSize ? large.data() : small.data();
    for (std::size_t i = 0; i < n; ++i) {
        Value* row = rows + i * (n + 1);
        for (std::size_t j = i == 0 ? 0 : i - 1; j < n; ++j) {
            row[j] = {-m_rows[i * n + j], 0.0};
        }
        row[i].re += point.real();
        row[i].im += point.imag();
        row[n] = {m_input[i], 0.0};
    }
    eliminate(rows, n);
    substitute(rows, n);
    std::complex<double> value = m_direct;
    for (std::size_t i = 0; i < n; ++i) {
        const Value x = rows[i * (n + 1) + n];
        value += std::complex<double>(m_output[i] * x.re, m_output[i] * x.im);
    }
    return value;
}

std::complex<double> StatePath::atFrequency(double frequency_rad_s) const {
    return m_timeBase.isContinuous() ? at({0.0, frequency_rad_s})
                                     : at(std::polar(1.0, frequency_rad_s * m_timeBase.period_s()));
}

Result<FrequencyResponse> frequencyResponse(const StateSpace& system,
                                            const std::vector<double>& frequency_rad_s, Index output,
                                            Index input) {
    if (output < 0 || output >= system.outputs() || input < 0 || input >= system.inputs()) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("there is no path from input {} to output {}", input, output));
    }
    const StatePath path(system, output, input);
    return frequencyResponse([&path](double w) { return path.atFrequency(w); }, system.timeBase,
                             frequency_rad_s);
}

} // namespace halbench::control
