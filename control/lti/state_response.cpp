#include "control/lti/state_response.h"

#include "control/base/assert.h"
#include "control/lti/realization.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::control {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

bool isHessenberg(const MatrixXd& A) {
    for (Index column = 0; column + 2 < A.cols(); ++column) {
        if (!A.col(column).tail(A.rows() - column - 2).isZero(0.0)) {
            return false;
        }
    }
    return true;
}

/// Blocks of one or two states on the diagonal, nothing below them.
bool isTriangle(const MatrixXd& A) {
    for (Index row = 2; row < A.rows(); ++row) {
        if (A(row, row - 1) != 0.0 && A(row - 1, row - 2) != 0.0) {
            return false;
        }
    }
    return isHessenberg(A);
}

/// Orthogonally, to a triangle of blocks; should the iteration not end, to Hessenberg form.
void turn(StateSpace& system) {
    MatrixXd Q;
    const Eigen::RealSchur<MatrixXd> schur(system.A);
    if (schur.info() == Eigen::Success) {
        system.A = schur.matrixT();
        Q = schur.matrixU();
    } else {
        const Eigen::HessenbergDecomposition<MatrixXd> hessenberg(system.A);
        system.A = hessenberg.matrixH();
        Q = hessenberg.matrixQ();
    }
    system.B = (Q.transpose() * system.B).eval();
    system.C = (system.C * Q).eval();
}

StateSpace backwards(const StateSpace& system) {
    return {system.A.reverse(), system.B.colwise().reverse(), system.C.rowwise().reverse(), system.D,
            system.timeBase};
}

/// States of a system whose room is on the stack.
constexpr std::size_t SmallSize = 12;

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
    const StateSpace turned = backwards(path);
    if (isTriangle(turned.A) || (!isTriangle(path.A) && !isHessenberg(path.A) && isHessenberg(turned.A))) {
        path = turned;
    } else if (!isHessenberg(path.A)) {
        turn(path);
    }
    m_isTriangle = isTriangle(path.A);
    m_matrix.resize(m_size * m_size);
    Eigen::Map<MatrixXd>(m_matrix.data(), path.A.rows(), path.A.cols()) =
        m_isTriangle ? path.A : path.A.transpose();
    m_input.assign(path.B.data(), path.B.data() + m_size);
    m_output.assign(path.C.data(), path.C.data() + m_size);
}

/// Of companion forms: the rows of [s - A, B] are copied and brought to a triangle.
void StatePath::eliminated(std::complex<double> point, double* re, double* im) const {
    const std::size_t n = m_size;
    std::array<Value, SmallSize*(SmallSize + 1)> small;
    std::vector<Value> large(n > SmallSize ? n * (n + 1) : 0);
    Value* rows = n > SmallSize ? large.data() : small.data();
    for (std::size_t i = 0; i < n; ++i) {
        Value* row = rows + i * (n + 1);
        for (std::size_t j = i == 0 ? 0 : i - 1; j < n; ++j) {
            row[j] = {-m_matrix[i * n + j], 0.0};
        }
        row[i].re += point.real();
        row[i].im += point.imag();
        row[n] = {m_input[i], 0.0};
    }
    eliminate(rows, n);
    substitute(rows, n);
    for (std::size_t i = 0; i < n; ++i) {
        re[i] = rows[i * (n + 1) + n].re;
        im[i] = rows[i * (n + 1) + n].im;
    }
}

/// Of a triangle: from the last block up, what is known of x goes to the right side of the rows above.
void StatePath::substituted(std::complex<double> point, double* re, double* im) const {
    const std::size_t n = m_size;
    const Value s{point.real(), point.imag()};
    std::copy(m_input.begin(), m_input.end(), re);
    std::fill(im, im + n, 0.0);
    const auto put = [&](std::size_t k, Value x, std::size_t above) {
        const double* column = m_matrix.data() + k * n;
        for (std::size_t i = 0; i < above; ++i) {
            re[i] += column[i] * x.re;
            im[i] += column[i] * x.im;
        }
        re[k] = x.re;
        im[k] = x.im;
    };
    for (std::size_t k = n; k-- > 0;) {
        const double* column = m_matrix.data() + k * n;
        const double* left = k > 0 ? column - n : column;
        const Value last{s.re - column[k], s.im};
        const double coupling = k > 0 ? left[k] : 0.0;
        if (coupling == 0.0) {
            put(k, times({re[k], im[k]}, inverse(last)), k);
            continue;
        }
        // [first, -up; -coupling, last] (x, y) = right side, by Cramer's rule
        const double up = column[k - 1];
        const Value first{s.re - left[k - 1], s.im};
        const Value product = times(first, last);
        const Value scale = inverse({product.re - up * coupling, product.im});
        const Value a{re[k - 1], im[k - 1]};
        const Value b{re[k], im[k]};
        const Value x = times(last, a);
        const Value y = times(first, b);
        put(k, times({y.re + coupling * a.re, y.im + coupling * a.im}, scale), k - 1);
        put(k - 1, times({x.re + up * b.re, x.im + up * b.im}, scale), k - 1);
        --k;
    }
}

std::complex<double> StatePath::at(std::complex<double> point) const {
    std::array<double, 2 * SmallSize> small;
    std::vector<double> large(m_size > SmallSize ? 2 * m_size : 0);
    double* re = m_size > SmallSize ? large.data() : small.data();
    double* im = re + m_size;
    m_isTriangle ? substituted(point, re, im) : eliminated(point, re, im);
    double real = m_direct;
    double imaginary = 0.0;
    for (std::size_t i = 0; i < m_size; ++i) {
        real += m_output[i] * re[i];
        imaginary += m_output[i] * im[i];
    }
    return {real, imaginary};
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
