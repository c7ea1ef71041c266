#include "app/procedures/identify/axis_fit.h"

#include "control/base/units.h"
#include "control/identify/least_squares.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace halbench::app {
namespace {

constexpr double Window_s = 0.25;
constexpr std::size_t DelayRows = 8; // that an effort may be late
constexpr std::size_t SpeedRows = 20;
constexpr int FewestWindows = 20;
constexpr int Harmonics = 2;
constexpr int Functions = 1 + 2 * Harmonics;

enum Unknown { Damping, Friction, Gain, Offset, Delay, Count };

/// A function of the window and its two derivatives, all zero at both ends.
struct Weight {
    double value = 0.0, first = 0.0, second = 0.0;
};

/// sin^4(pi s) times 1, cosine or sine of whole periods, s = 0 ... 1 over the window; zero outside.
Weight weightAt(int function, double s) {
    constexpr std::array Parts = {1.0 / 16.0, -0.25, 0.375, -0.25, 1.0 / 16.0};
    if (s <= 0.0 || s >= 1.0) {
        return {};
    }
    std::complex<double> value, first, second;
    const int harmonic = (function + 1) / 2;
    for (int i = 0; i < static_cast<int>(Parts.size()); ++i) {
        const std::complex<double> rate(0.0, 2.0 * Pi * (i - 2 + harmonic) / Window_s);
        const std::complex<double> part = Parts[static_cast<std::size_t>(i)] * std::exp(rate * Window_s * s);
        value += part;
        first += rate * part;
        second += rate * rate * part;
    }
    const bool isSine = harmonic > 0 && function % 2 == 0;
    return isSine ? Weight{value.imag(), first.imag(), second.imag()}
                  : Weight{value.real(), first.real(), second.real()};
}

struct Window {
    std::size_t begin = 0; ///< its first row
    double direction = 0.0;
};

struct Windows {
    std::vector<Window> all;
    double period_s = 0.0;
    std::size_t rows = 0; ///< from one end of a window to the other
    int leftOut = 0;
};

bool isEven(const AxisRows& rows, std::size_t from, std::size_t to, double period_s) {
    for (std::size_t i = from; i < to; ++i) {
        if (std::fabs(rows.time_s[i + 1] - rows.time_s[i] - period_s) > 0.1 * period_s) {
            return false;
        }
    }
    return true;
}

/// The way in which the axis moves all the time, 0: not one way, or too slowly.
double directionOf(const AxisRows& rows, std::size_t begin, std::size_t end, double slowest) {
    const double direction = rows.position[end] > rows.position[begin] ? 1.0 : -1.0;
    for (std::size_t i = begin; i + SpeedRows <= end; ++i) {
        const double speed =
            (rows.position[i + SpeedRows] - rows.position[i]) / (rows.time_s[i + SpeedRows] - rows.time_s[i]);
        if (!(direction * speed > slowest)) {
            return 0.0;
        }
    }
    return direction;
}

double periodOf(const AxisRows& rows) {
    std::vector<double> periods_s;
    for (std::size_t i = 1; i < rows.time_s.size(); ++i) {
        periods_s.push_back(rows.time_s[i] - rows.time_s[i - 1]);
    }
    if (periods_s.empty()) {
        return 0.0;
    }
    const auto middle = periods_s.begin() + static_cast<std::ptrdiff_t>(periods_s.size() / 2);
    std::nth_element(periods_s.begin(), middle, periods_s.end());
    return *middle;
}

/// One after the other, as many as the motion holds.
Windows windowsOf(const AxisRows& rows, double slowest) {
    constexpr std::size_t Search = 10; // rows further where the motion is not one way
    Windows found;
    found.period_s = periodOf(rows);
    if (!(found.period_s > 0.0)) {
        return found;
    }
    found.rows = static_cast<std::size_t>(std::lround(Window_s / found.period_s));
    std::size_t begin = DelayRows;
    while (begin + found.rows + 1 < rows.time_s.size()) {
        const std::size_t end = begin + found.rows;
        const double direction = directionOf(rows, begin, end, slowest);
        const bool isWhole = isEven(rows, begin - DelayRows, end + 1, found.period_s);
        if (direction != 0.0 && isWhole) {
            found.all.push_back({begin, direction});
        }
        found.leftOut += direction != 0.0 && !isWhole ? 1 : 0;
        begin = direction != 0.0 ? end : begin + Search;
    }
    return found;
}

/// Equations of all windows: Functions rows each, with the effort late by `delay_s`.
struct Equations {
    Eigen::MatrixXd design;
    Eigen::VectorXd observed;
};

void addPositions(Equations& equations, Eigen::Index row, int function, const Window& window,
                  const Windows& of, const AxisRows& rows) {
    const double middle = rows.position[window.begin + of.rows / 2];
    double moved = 0.0, damped = 0.0, one = 0.0;
    for (std::size_t i = 1; i < of.rows; ++i) {
        const Weight weight = weightAt(function, static_cast<double>(i) / static_cast<double>(of.rows));
        const double position = rows.position[window.begin + i] - middle;
        moved += position * weight.second;
        damped += position * weight.first;
        one += weight.value;
    }
    equations.observed(row) = moved * of.period_s;
    equations.design(row, Damping) = damped * of.period_s;
    equations.design(row, Friction) = -window.direction * one * of.period_s;
    equations.design(row, Offset) = one * of.period_s;
}

void addEfforts(Equations& equations, Eigen::Index row, int function, const Window& window, const Windows& of,
                const AxisRows& rows, double delay_s) {
    const double late = delay_s / of.period_s; // rows
    double driven = 0.0, rate = 0.0;
    for (std::size_t i = 0; i <= of.rows + DelayRows; ++i) {
        const double effort = rows.effort[window.begin + i - DelayRows];
        const auto at = [&](double part) {
            const double place = static_cast<double>(i) - static_cast<double>(DelayRows) + late + part;
            return weightAt(function, place / static_cast<double>(of.rows));
        };
        const Weight begin = at(0.0), end = at(1.0);
        driven += effort * (begin.value + 4.0 * at(0.5).value + end.value) / 6.0 * of.period_s; // Simpson
        rate += effort * (end.value - begin.value);
    }
    equations.design(row, Gain) = driven;
    equations.design(row, Delay) = rate; // u(t - d) = u - d u', and the integral of -u' w is that of u w'
}

Equations equationsOf(const AxisRows& rows, const Windows& windows, double delay_s) {
    const auto count = static_cast<Eigen::Index>(windows.all.size()) * Functions;
    Equations equations{Eigen::MatrixXd(count, static_cast<Eigen::Index>(Count)), Eigen::VectorXd(count)};
    Eigen::Index row = 0;
    for (const Window& window : windows.all) {
        for (int function = 0; function < Functions; ++function, ++row) {
            addPositions(equations, row, function, window, windows, rows);
            addEfforts(equations, row, function, window, windows, rows, delay_s);
        }
    }
    return equations;
}

/// Inverse variances of the equations, one for each function of the window.
Eigen::VectorXd weightsFrom(const Eigen::VectorXd& residuals, double scale) {
    std::array<double, Functions> squares{};
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
        squares[static_cast<std::size_t>(i % Functions)] += residuals(i) * residuals(i);
    }
    const double floor = 1e-18 * scale * scale * static_cast<double>(residuals.size());
    Eigen::VectorXd weights(residuals.size());
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
        weights(i) = 1.0 / (squares[static_cast<std::size_t>(i % Functions)] + floor);
    }
    return weights / weights.maxCoeff();
}

/// What happens between two rows is not seen: an effort that is held otherwise than from row to row has
/// another size at the frequencies of the windows, by (w T)^2/24 as the sine of half a row over the half.
double holdError_ratio(double period_s) {
    return std::pow(2.0 * Pi * Harmonics / Window_s * period_s, 2) / 24.0;
}

/// The unknowns that the model names: a, k, u_f.
Eigen::Vector3d namedOf(const Eigen::VectorXd& unknowns) {
    return {unknowns(Damping), unknowns(Gain), unknowns(Friction) / unknowns(Gain)};
}

/// Leaves one window after the other out.
Result<Eigen::Matrix3d> jackknife(const Equations& equations, const Eigen::VectorXd& weights,
                                  const Eigen::Vector3d& all) {
    const Eigen::Index windows = weights.size() / Functions;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (Eigen::Index window = 0; window < windows; ++window) {
        Eigen::VectorXd without = weights;
        without.segment(window * Functions, Functions).setZero();
        const auto fit = control::fitLinear(equations.design, equations.observed, without);
        if (!fit) {
            return failure(fit.error());
        }
        const Eigen::Vector3d change = namedOf(fit->coefficients) - all;
        sum += change * change.transpose();
    }
    const auto count = static_cast<double>(windows);
    return Eigen::Matrix3d(sum * (count - 1.0) / count);
}

/// The further column q'|q'| of every equation.
Eigen::VectorXd squaredSpeeds(const AxisRows& rows, const Windows& windows) {
    constexpr std::size_t Half = 5; // rows
    Eigen::VectorXd squares(static_cast<Eigen::Index>(windows.all.size()) * Functions);
    Eigen::Index row = 0;
    for (const Window& window : windows.all) {
        for (int function = 0; function < Functions; ++function, ++row) {
            double sum = 0.0;
            for (std::size_t i = 1; i < windows.rows; ++i) {
                const std::size_t at = window.begin + i;
                const std::size_t end = std::min(at + Half, rows.position.size() - 1);
                const double speed = (rows.position[end] - rows.position[at - Half]) /
                                     (static_cast<double>(end - at + Half) * windows.period_s);
                const double place = static_cast<double>(i) / static_cast<double>(windows.rows);
                sum += weightAt(function, place).value * speed * std::fabs(speed);
            }
            squares(row) = sum * windows.period_s;
        }
    }
    return squares;
}

/// Student's t of that column, by leaving one window after the other out.
Result<double> dragSignificance(const Equations& equations, const Eigen::VectorXd& weights,
                                const Eigen::VectorXd& squares) {
    Eigen::MatrixXd design(equations.design.rows(), equations.design.cols() + 1);
    design << equations.design, squares;
    const Eigen::Index last = design.cols() - 1;
    const auto all = control::fitLinear(design, equations.observed, weights);
    if (!all) {
        return failure(all.error());
    }
    const Eigen::Index windows = weights.size() / Functions;
    double sum = 0.0;
    for (Eigen::Index window = 0; window < windows; ++window) {
        Eigen::VectorXd without = weights;
        without.segment(window * Functions, Functions).setZero();
        const auto fit = control::fitLinear(design, equations.observed, without);
        if (!fit) {
            return failure(fit.error());
        }
        sum += std::pow(fit->coefficients(last) - all->coefficients(last), 2);
    }
    const auto count = static_cast<double>(windows);
    const double error = std::sqrt(sum * (count - 1.0) / count);
    return error > 0.0 ? all->coefficients(last) / error : 0.0;
}

tl::unexpected<Error> unexcited(std::string message) {
    return failure(ErrorCode::Refused, std::move(message),
                   "Check that nothing holds the axis, and that it follows its reference.");
}

Result<void> checkWindows(const Windows& windows) {
    const auto is = [](double direction) {
        return [direction](const Window& window) { return window.direction == direction; };
    };
    if (static_cast<int>(windows.all.size()) < FewestWindows) {
        return unexcited(fmt::format("only {} of {} stretches of {} s in steady motion", windows.all.size(),
                                     FewestWindows, Window_s));
    }
    if (std::none_of(windows.all.begin(), windows.all.end(), is(1.0)) ||
        std::none_of(windows.all.begin(), windows.all.end(), is(-1.0))) {
        return unexcited("the axis moved one way only");
    }
    return {};
}

struct Solution {
    Equations equations;
    Eigen::VectorXd weights;
    control::LinearFit fit;
    double delay_s = 0.0;
};

/// Linear in all but the delay, which converges in a few steps.
Result<Solution> solve(const AxisRows& rows, const Windows& windows) {
    constexpr int MostSteps = 12;
    constexpr double Small_s = 1e-9;
    Solution solution;
    for (int step = 0; step < MostSteps; ++step) {
        solution.equations = equationsOf(rows, windows, solution.delay_s);
        const Eigen::VectorXd& observed = solution.equations.observed;
        if (step == 0) {
            solution.weights = Eigen::VectorXd::Ones(observed.size());
        }
        auto fit = control::fitLinear(solution.equations.design, observed, solution.weights);
        if (!fit) {
            return failure(fit.error());
        }
        const double more_s = fit->coefficients(Delay) / fit->coefficients(Gain);
        solution.weights = weightsFrom(fit->residuals, observed.lpNorm<Eigen::Infinity>());
        solution.fit = *std::move(fit);
        if (std::fabs(more_s) < Small_s) {
            return solution;
        }
        solution.delay_s += more_s;
        const double most_s = static_cast<double>(DelayRows - 1) * windows.period_s;
        if (!(solution.delay_s > -windows.period_s && solution.delay_s < most_s)) {
            return unexcited("the effort shows no effect on the motion within 8 rows");
        }
    }
    return unexcited("the delay of the effort is not decided by the motion");
}

} // namespace

Result<AxisFit> fitAxis(const AxisRows& rows, double slowest) {
    const Windows windows = windowsOf(rows, slowest);
    if (const auto enough = checkWindows(windows); !enough) {
        return failure(enough.error());
    }
    const auto solution = solve(rows, windows);
    if (!solution) {
        return failure(solution.error());
    }
    const Eigen::VectorXd& unknowns = solution->fit.coefficients;
    const Eigen::Vector3d named = namedOf(unknowns);
    const auto covariance = jackknife(solution->equations, solution->weights, named);
    if (!covariance) {
        return failure(covariance.error());
    }
    const auto drag = dragSignificance(solution->equations, solution->weights, squaredSpeeds(rows, windows));
    if (!drag) {
        return failure(drag.error());
    }
    AxisFit result;
    result.drag_t = *drag;
    result.dampingRate_1_s = named(0);
    result.accelerationGain = named(1);
    result.breakawayEffort = named(2);
    result.covariance = *covariance;
    for (const int ratio : {0, 1}) {
        result.covariance(ratio, ratio) += std::pow(holdError_ratio(windows.period_s) * named(ratio), 2);
    }
    result.offset = unknowns(Offset);
    result.delay_s = solution->delay_s;
    result.windows = static_cast<int>(windows.all.size());
    result.freedom = static_cast<double>(result.windows - Count);
    result.unexplained_ratio = solution->fit.residuals.norm() / solution->equations.observed.norm();
    result.leftOut = windows.leftOut;
    return result;
}

} // namespace halbench::app
