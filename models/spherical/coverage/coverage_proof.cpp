#include "models/spherical/coverage/coverage_proof.h"

#include <queue>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr std::uint64_t CellsBetweenQuestions = 4096;

struct Cell {
    double bound_T = 0.0;
    Eigen::Vector3d middle;
    Eigen::Vector3d half;
};

struct HigherBound {
    bool operator()(const Cell& a, const Cell& b) const { return a.bound_T > b.bound_T; }
};
using CellQueue = std::priority_queue<Cell, std::vector<Cell>, HigherBound>;

OrientationAngles anglesAt(const Eigen::Vector3d& point) {
    return {point[0], point[1], point[2]};
}

Eigen::Vector3d vectorOf(const OrientationAngles& angles) {
    return {angles.alpha_rad, angles.beta_rad, angles.gamma_rad};
}

/// Bounds of one component over boxes of poses.
class ComponentSearch {
public:
    ComponentSearch(const CoverageModel& model, const CoverageProofConfig& config, int component)
        : m_model(model), m_config(config), m_component(component) {
        for (int i = 0; i < 3; ++i) {
            m_slope = std::fmax(m_slope, model.slopeBound()[3 * i + component]);
        }
        m_proof.least_T = HUGE_VAL;
    }

    Result<ComponentProof> run(const WorkControl& control) {
        fill();
        while (!isDone()) {
            const Cell cell = m_cells.top();
            m_cells.pop();
            halve(cell);
            if (m_proof.cells % CellsBetweenQuestions == 0 && control.isStopped && control.isStopped()) {
                return failure(ErrorCode::Interrupted, "The coverage proof was stopped.");
            }
        }
        m_proof.bound_T = std::fmax(0.0, std::fmin(m_proof.least_T, m_cells.top().bound_T));
        if (m_proof.least_T <= m_config.threshold_T) {
            m_proof.verdict = CoverageVerdict::Refuted;
            descend();
        } else if (m_proof.bound_T > m_config.threshold_T) {
            m_proof.verdict = CoverageVerdict::Proven;
        }
        return m_proof;
    }

private:
    double largest_T(const Eigen::Vector3d& point) const {
        return largestOfComponent_T(m_model.readings_T(anglesAt(point)), m_component);
    }

    void add(const Eigen::Vector3d& middle, const Eigen::Vector3d& half) {
        const double value_T = largest_T(middle);
        ++m_proof.cells;
        if (value_T < m_proof.least_T) {
            m_proof.least_T = value_T;
            m_proof.leastAt = anglesAt(middle);
        }
        m_cells.push({value_T - m_slope * half.sum(), middle, half});
    }

    void fill() {
        const Eigen::Vector3d low = vectorOf(m_config.box.low);
        const Eigen::Vector3d size = vectorOf(m_config.box.high) - low;
        const Eigen::Vector3d parts = (size / m_config.firstStep_rad).array().ceil().max(1.0);
        const Eigen::Vector3d half = 0.5 * size.cwiseQuotient(parts);
        for (int a = 0; a < static_cast<int>(parts[0]); ++a) {
            for (int b = 0; b < static_cast<int>(parts[1]); ++b) {
                for (int g = 0; g < static_cast<int>(parts[2]); ++g) {
                    const Eigen::Vector3d index(2.0 * a + 1.0, 2.0 * b + 1.0, 2.0 * g + 1.0);
                    add(low + index.cwiseProduct(half), half);
                }
            }
        }
    }

    bool isDone() const {
        const bool isProven = m_cells.top().bound_T > m_config.threshold_T;
        const bool isNear =
            m_config.gap_T <= 0.0 || m_cells.top().bound_T >= m_proof.least_T - m_config.gap_T;
        return m_proof.least_T <= m_config.threshold_T || (isProven && isNear) ||
               m_proof.cells >= m_config.cellLimit;
    }

    void halve(const Cell& cell) {
        Eigen::Index longest = 0;
        cell.half.maxCoeff(&longest);
        Eigen::Vector3d half = cell.half;
        half[longest] *= 0.5;
        Eigen::Vector3d middle = cell.middle;
        middle[longest] -= half[longest];
        add(middle, half);
        middle[longest] += 2.0 * half[longest];
        add(middle, half);
    }

    /// Towards a common zero of the three sensors' readings, within the box.
    void descend() {
        constexpr int Steps = 40;
        for (int i = 0; i < Steps; ++i) {
            const OrientationAngles& here = m_proof.leastAt;
            const SphericalReadings readings_T = m_model.readings_T(here);
            const OrientationJacobian whole = m_model.jacobian(here) * rateMatrix(here);
            Eigen::Matrix3d jacobian;
            Eigen::Vector3d value_T;
            for (int k = 0; k < 3; ++k) {
                jacobian.row(k) = whole.row(3 * k + m_component);
                value_T[k] = readings_T[3 * k + m_component];
            }
            Eigen::Matrix3d normal = jacobian.transpose() * jacobian;
            normal.diagonal().array() += 1e-9 * normal.trace();
            Eigen::Vector3d step = -normal.ldlt().solve(jacobian.transpose() * value_T);
            bool isBetter = false;
            for (int halvings = 0; halvings < 20 && !isBetter; ++halvings, step *= 0.5) {
                const Eigen::Vector3d next = (vectorOf(here) + step)
                                                 .cwiseMax(vectorOf(m_config.box.low))
                                                 .cwiseMin(vectorOf(m_config.box.high));
                const double next_T = largest_T(next);
                if (next_T < m_proof.least_T) {
                    m_proof.least_T = next_T;
                    m_proof.leastAt = anglesAt(next);
                    isBetter = true;
                }
            }
            if (!isBetter) {
                return;
            }
        }
    }

    const CoverageModel& m_model;
    const CoverageProofConfig& m_config;
    int m_component;
    double m_slope = 0.0;
    CellQueue m_cells;
    ComponentProof m_proof;
};

} // namespace

Result<CoverageProof> proveCoverage(const CoverageModel& model, const CoverageProofConfig& config,
                                    const WorkControl& control) {
    const Eigen::Vector3d size = vectorOf(config.box.high) - vectorOf(config.box.low);
    if (!(size.minCoeff() >= 0.0) || !(config.firstStep_rad > 0.0) || !size.allFinite() ||
        !(size.cwiseMax(config.firstStep_rad).prod() <
          static_cast<double>(LargestGrid) * std::pow(config.firstStep_rad, 3))) {
        return failure(ErrorCode::OutOfRange,
                       "The box of the coverage proof is empty or its cells too small.");
    }
    CoverageProof proof;
    std::array<Error, ComponentCount> errors;
    std::array<bool, ComponentCount> hasFailed{};
    const auto worked = forEachInParallel(ComponentCount, control, [&](std::size_t c) {
        auto found = ComponentSearch(model, config, static_cast<int>(c)).run(control);
        if (found) {
            proof.component[c] = *found;
        } else {
            errors[c] = found.error();
            hasFailed[c] = true;
        }
    });
    if (!worked) {
        return failure(worked.error());
    }
    for (std::size_t c = 0; c < ComponentCount; ++c) {
        if (hasFailed[c]) {
            return failure(errors[c]);
        }
    }
    return proof;
}

} // namespace halbench::models
