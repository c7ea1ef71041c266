#include "tests/control/routes/state_routes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {

StateSpace sectionsOf(const TransferFunction& system) {
    return toStateSpace(toZeroPoleGain(system));
}

Eigen::VectorXcd realEigenvalues(const Eigen::MatrixXd& A) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(A, false).eigenvalues();
}

Eigen::VectorXcd closedPoles(const StateSpace& loop, std::complex<double> gain) {
    const std::complex<double> back = gain / (1.0 + gain * loop.D(0, 0));
    const Eigen::MatrixXcd A = loop.A.cast<std::complex<double>>() - back * (loop.B * loop.C);
    return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(A, false).eigenvalues();
}

double distanceTo(const Eigen::VectorXcd& values, std::complex<double> place) {
    return (values.array() - place).abs().minCoeff();
}

std::complex<double> boundaryPoint(const TimeBase& base, double frequency_rad_s) {
    return base.isSampled() ? std::polar(1.0, frequency_rad_s * base.period_s())
                            : std::complex<double>(0.0, frequency_rad_s);
}

int unstableCount(const StateSpace& loop, double gain) {
    int count = 0;
    for (const auto& pole : closedPoles(loop, gain)) {
        count += (loop.timeBase.isSampled() ? std::abs(pole) > 1.0 : pole.real() > 0.0) ? 1 : 0;
    }
    return count;
}

StateSpace sensitivityOf(const StateSpace& L) {
    const double q = 1.0 / (1.0 + L.D(0, 0));
    return {L.A - q * L.B * L.C, q * L.B, -q * L.C, Eigen::MatrixXd::Constant(1, 1, q), L.timeBase};
}
StateSpace complementOf(const StateSpace& L) {
    StateSpace T = sensitivityOf(L);
    T.C = -T.C;
    T.D(0, 0) = L.D(0, 0) * T.D(0, 0);
    return T;
}

/// z = (1 + s)/(1 - s): the unit circle becomes the imaginary axis, the largest magnitude stays.
static StateSpace onTheAxis(const StateSpace& system) {
    if (system.timeBase.isContinuous()) {
        return system;
    }
    const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(system.states(), system.states());
    const Eigen::MatrixXd inverse = (system.A + I).inverse();
    return {inverse * (system.A - I), std::sqrt(2.0) * inverse * system.B,
            std::sqrt(2.0) * system.C * inverse, system.D - system.C * inverse * system.B,
            TimeBase::continuous()};
}

std::complex<double> valueAt(const StateSpace& system, std::complex<double> x) {
    const Eigen::MatrixXcd inner =
        x * Eigen::MatrixXcd::Identity(system.states(), system.states()) - system.A;
    const Eigen::VectorXcd states = inner.fullPivLu().solve(system.B.col(0).cast<std::complex<double>>());
    return (system.C.cast<std::complex<double>>() * states).value() + system.D(0, 0);
}

static double magnitudeAt(const StateSpace& system, double frequency) {
    return std::abs(valueAt(system, {0.0, frequency}));
}

std::vector<double> levelFrequencies(const StateSpace& system, double level, double share) {
    const Eigen::Index n = system.states();
    const double D = system.D(0, 0);
    const double r = 1.0 / (level * level - D * D);
    const Eigen::MatrixXd inner = system.A + r * D * system.B * system.C;
    Eigen::MatrixXd H(2 * n, 2 * n);
    H << inner, r * system.B * system.B.transpose(), -(1.0 + r * D * D) * system.C.transpose() * system.C,
        -inner.transpose();
    std::vector<double> frequencies;
    const Eigen::VectorXcd values = realEigenvalues(H);
    for (const auto& value : values) {
        if (std::abs(value.real()) < share * std::abs(value) && value.imag() > 0.0) {
            frequencies.push_back(value.imag());
        }
    }
    std::sort(frequencies.begin(), frequencies.end());
    return frequencies;
}

double largestMagnitude(const StateSpace& anySystem) {
    const StateSpace system = onTheAxis(anySystem);
    double least = std::max(std::abs(system.D(0, 0)), magnitudeAt(system, 0.0));
    const Eigen::VectorXcd poles = realEigenvalues(system.A);
    for (const auto& pole : poles) {
        least = std::max(least, magnitudeAt(system, std::abs(pole)));
        least = std::max(least, magnitudeAt(system, std::abs(pole.imag())));
    }
    for (int round = 0; round < 50; ++round) {
        // Generous with what counts as imaginary: a wrong one costs a look, a missed one the peak.
        const auto edges = levelFrequencies(system, least * (1.0 + 1e-9), 1e-3);
        double better = least;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const double next = i + 1 < edges.size() ? edges[i + 1] : edges[i];
            better = std::max(
                {better, magnitudeAt(system, edges[i]), magnitudeAt(system, 0.5 * (edges[i] + next))});
        }
        if (better <= least * (1.0 + 1e-13)) {
            break;
        }
        least = better;
    }
    return least;
}

double roundingOf(const TransferFunction& system, double frequency_rad_s) {
    const std::complex<double> x = boundaryPoint(system.timeBase(), frequency_rad_s);
    const auto loss = [&x](const Polynomial& polynomial) {
        double terms = 0.0;
        for (const double coefficient : polynomial) {
            terms = terms * std::abs(x) + std::abs(coefficient);
        }
        return terms / std::abs(evaluate(polynomial, x));
    };
    return std::numeric_limits<double>::epsilon() * (loss(system.numerator()) + loss(system.denominator()));
}

} // namespace halbench::control
