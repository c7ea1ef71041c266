#include "control/identify/ellipse_fit.h"

#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/identify/least_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace halbench::control {
namespace {

constexpr int Parts = 8;
constexpr std::size_t FewestSamples = 80;
constexpr double LargestGap_rad = Pi / 3.0;   ///< without readings; ten a turn leave 36 degrees
constexpr double LargestResidual_ratio = 0.2; ///< a cloud of noise about one point has about 0.5

struct Conic {
    HallEllipse ellipse;
    double residual_ratio = 0.0;
};

Result<Conic> refuse(const char* message) {
    return failure(ErrorCode::Refused, message, "turn the rotor by several full turns");
}

Result<Conic> fitConic(std::span<const double> a, std::span<const double> b) {
    const auto [lowest, highest] = std::minmax_element(a.begin(), a.end());
    const double scale = 0.5 * (*highest - *lowest);
    if (!(scale > 0.0)) {
        return refuse("the Hall readings do not change");
    }
    Eigen::MatrixXd design(static_cast<Eigen::Index>(a.size()), 5);
    Eigen::VectorXd right(design.rows());
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        const double x = a[static_cast<std::size_t>(i)] / scale;
        const double y = b[static_cast<std::size_t>(i)] / scale;
        design.row(i) << x * y, y * y, x, y, 1.0;
        right(i) = -x * x;
    }
    const auto fit = fitLinear(design, right);
    if (!fit) {
        return failure(fit.error());
    }
    const double p = fit->coefficients(0);
    const double q = fit->coefficients(1);
    const double determinant = 4.0 * q - p * p;
    if (!(q > 0.0) || !(determinant > 0.0)) {
        return refuse("the Hall readings do not lie on an ellipse");
    }
    const double x0 = (p * fit->coefficients(3) - 2.0 * q * fit->coefficients(2)) / determinant;
    const double y0 = (p * fit->coefficients(2) - 2.0 * fit->coefficients(3)) / determinant;
    Conic conic;
    HallEllipse& ellipse = conic.ellipse;
    ellipse.offsetA_T = x0 * scale;
    ellipse.offsetB_T = y0 * scale;
    ellipse.gain_ratio = 1.0 / std::sqrt(q);
    const double sine = -0.5 * p * ellipse.gain_ratio;
    ellipse.quadrature_rad = std::asin(std::clamp(sine, -1.0, 1.0));
    // at the centre the conic's value is -A^2 cos^2(quadrature)
    const double square = x0 * x0 + p * x0 * y0 + q * y0 * y0 - fit->coefficients(4);
    if (!(square > 0.0)) {
        return refuse("the Hall readings do not lie on an ellipse");
    }
    ellipse.amplitude_T = scale * std::sqrt(square) / std::cos(ellipse.quadrature_rad);
    // the conic's residual is twice the relative distance from the ellipse
    conic.residual_ratio = 0.5 * std::sqrt(fit->residualVariance) / square;
    return conic;
}

// The largest angle between neighbouring readings as seen from the centre: an arc fits many ellipses, of
// which the least squares find one that is far too small, with little scatter.
double largestGap_rad(const HallEllipse& ellipse, std::span<const double> a, std::span<const double> b) {
    std::vector<double> angles_rad;
    angles_rad.reserve(a.size() + 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        angles_rad.push_back(hallAngle_rad(ellipse, a[i], b[i]));
    }
    std::sort(angles_rad.begin(), angles_rad.end());
    double gap_rad = angles_rad.front() + 2.0 * Pi - angles_rad.back();
    for (std::size_t i = 1; i < angles_rad.size(); ++i) {
        gap_rad = std::max(gap_rad, angles_rad[i] - angles_rad[i - 1]);
    }
    return gap_rad;
}

bool goesRound(const Conic& conic, std::span<const double> a, std::span<const double> b) {
    return conic.residual_ratio <= LargestResidual_ratio &&
           largestGap_rad(conic.ellipse, a, b) <= LargestGap_rad;
}

// The five values in a fixed order, for statistics over the parts.
std::array<double HallEllipse::*, 5> members() {
    return {&HallEllipse::offsetA_T, &HallEllipse::offsetB_T, &HallEllipse::gain_ratio,
            &HallEllipse::quadrature_rad, &HallEllipse::amplitude_T};
}

} // namespace

Result<HallEllipseFit> fitHallEllipse(std::span<const double> a_T, std::span<const double> b_T) {
    HB_ASSERT(a_T.size() == b_T.size());
    if (a_T.size() < FewestSamples) {
        return failure(ErrorCode::Refused, "too few Hall readings for an ellipse", "record longer");
    }
    const auto all = fitConic(a_T, b_T);
    if (!all) {
        return failure(all.error());
    }
    HallEllipseFit result;
    result.ellipse = all->ellipse;
    result.residual_ratio = all->residual_ratio;
    std::vector<HallEllipse> parts;
    const std::size_t length = a_T.size() / Parts;
    for (int i = 0; i < Parts; ++i) {
        const std::size_t begin = static_cast<std::size_t>(i) * length;
        const auto a = a_T.subspan(begin, length);
        const auto b = b_T.subspan(begin, length);
        if (const auto part = fitConic(a, b); part && goesRound(*part, a, b)) {
            parts.push_back(part->ellipse);
        }
    }
    if (!goesRound(*all, a_T, b_T) || parts.size() < Parts / 2) {
        return failure(ErrorCode::Refused, "parts of the recording do not cover a full turn",
                       "turn the rotor by several full turns");
    }
    result.parts = static_cast<int>(parts.size());
    for (const auto member : members()) {
        double mean = 0.0;
        double squares = 0.0;
        for (const HallEllipse& part : parts) {
            mean += part.*member / static_cast<double>(parts.size());
        }
        for (const HallEllipse& part : parts) {
            squares += (part.*member - mean) * (part.*member - mean);
        }
        const auto count = static_cast<double>(parts.size());
        result.error.*member = std::sqrt(squares / (count - 1.0) / count);
    }
    return result;
}

double hallAngle_rad(const HallEllipse& calibration, double a_T, double b_T) {
    const double cosine = a_T - calibration.offsetA_T;
    const double skewed = (b_T - calibration.offsetB_T) / calibration.gain_ratio;
    const double sine =
        (skewed - cosine * std::sin(calibration.quadrature_rad)) / std::cos(calibration.quadrature_rad);
    return std::atan2(sine, cosine);
}

double hallAngleError_rad(const HallEllipse& calibration, const HallEllipse& truth) {
    constexpr int Steps = 360;
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < Steps; ++i) {
        const double angle = 2.0 * Pi * i / Steps;
        const double a = truth.offsetA_T + truth.amplitude_T * std::cos(angle);
        const double b =
            truth.offsetB_T + truth.amplitude_T * truth.gain_ratio * std::sin(angle + truth.quadrature_rad);
        const double error = std::remainder(hallAngle_rad(calibration, a, b) - angle, 2.0 * Pi);
        sum += error / Steps;
        squares += error * error / Steps;
    }
    return std::sqrt(std::max(squares - sum * sum, 0.0));
}

} // namespace halbench::control
