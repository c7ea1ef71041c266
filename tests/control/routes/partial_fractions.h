#pragma once

#include "control/lti/transfer_function.h"

#include <cmath>
#include <complex>
#include <vector>

namespace halbench::control {

/// G = D + sum of residue/(x - pole): answers in time as sums of exponentials, without a matrix or a
/// recurrence. Of simple poles only (random ones are).
class PartialFractions {
public:
    explicit PartialFractions(const TransferFunction& system) : m_poles(control::poles(system)) {
        m_direct = degree(system.numerator()) == system.order()
                       ? system.numerator().front() / system.denominator().front()
                       : 0.0;
        for (const auto& pole : m_poles) {
            std::complex<double> others = system.denominator().front();
            for (const auto& other : m_poles) {
                others *= &other == &pole ? 1.0 : pole - other;
            }
            m_residues.push_back(evaluate(system.numerator(), pole) / others);
        }
    }

    /// sum of r p^power e^(p t), real: derivative of the impulse response of a continuous system.
    double impulse(double time_s, int power = 0) const {
        std::complex<double> sum = 0.0;
        for (std::size_t i = 0; i < m_poles.size(); ++i) {
            sum += m_residues[i] * std::pow(m_poles[i], power) * std::exp(m_poles[i] * time_s);
        }
        return sum.real();
    }
    /// D + sum of r (e^(p t) - 1)/p.
    double step(double time_s) const {
        std::complex<double> sum = m_direct;
        for (std::size_t i = 0; i < m_poles.size(); ++i) {
            sum += m_residues[i] * (std::exp(m_poles[i] * time_s) - 1.0) / m_poles[i];
        }
        return sum.real();
    }
    /// D t + sum of r (e^(p t) - 1 - p t)/p^2.
    double ramp(double time_s) const {
        std::complex<double> sum = m_direct * time_s;
        for (std::size_t i = 0; i < m_poles.size(); ++i) {
            const auto p = m_poles[i];
            sum += m_residues[i] * (std::exp(p * time_s) - 1.0 - p * time_s) / (p * p);
        }
        return sum.real();
    }
    /// Of a sampled system: D at 0, then sum of r p^(k - 1).
    double sample(int k) const {
        std::complex<double> sum = k == 0 ? m_direct : 0.0;
        for (std::size_t i = 0; k > 0 && i < m_poles.size(); ++i) {
            sum += m_residues[i] * std::pow(m_poles[i], k - 1);
        }
        return sum.real();
    }
    /// Sum of the magnitudes that are added: what the rounding of the sums is measured by.
    double size() const {
        double sum = std::abs(m_direct);
        for (std::size_t i = 0; i < m_poles.size(); ++i) {
            sum += std::abs(m_residues[i]) * (1.0 + 1.0 / std::norm(m_poles[i]));
        }
        return sum;
    }
    const std::vector<std::complex<double>>& poles() const { return m_poles; }

private:
    std::vector<std::complex<double>> m_poles;
    std::vector<std::complex<double>> m_residues;
    double m_direct = 0.0;
};

} // namespace halbench::control
