#include "models/spherical/calibration_fit.h"

#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/orientation_estimator.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr std::size_t LeastSamples = 20;
constexpr double LeastMotion_rad = 10.0 * Pi / 180.0;
constexpr double Normal95 = 1.959963984540054;
constexpr double Enough_ratio = 0.5;
/// Rows that hold a gauge: this small a part of the plausible size.
constexpr double GaugeDeviation_ratio = 1e-4;

struct Oriented {
    CalibrationSample sample;
    Eigen::Matrix3d rotation;
    std::size_t index;
};

/// Six degrees of freedom a sample, about: one of 10 million healthy ones lies beyond eight times the median.
double strangeLimit(std::vector<double> misfit) {
    constexpr double Strange_ratio = 8.0;
    const auto middle = misfit.begin() + static_cast<std::ptrdiff_t>(misfit.size() / 2);
    std::nth_element(misfit.begin(), middle, misfit.end());
    return Strange_ratio * *middle;
}

std::vector<std::size_t> strangeSamples(const std::vector<double>& misfit) {
    const double limit = strangeLimit(misfit);
    std::vector<std::size_t> strange;
    for (std::size_t i = 0; i < misfit.size(); ++i) {
        if (misfit[i] > limit) {
            strange.push_back(i);
        }
    }
    return strange;
}

/// Normal equations of the unknowns in units of their plausible size, orientations eliminated.
struct Reduced {
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
    double cost = 0.0;
    double readings = 0.0;      ///< number of used readings
    std::vector<double> misfit; ///< chi-square of each sample's readings
    /// Orientation of each sample: w = base - slope * step
    std::vector<Eigen::Vector3d> base_rad;
    std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> slope;
};

class Problem {
public:
    Problem(const SphericalCalibration& nominal, const CalibrationConfig& config)
        : m_nominal(nominal), m_config(config), m_unknowns(calibrationUnknowns(config.selection, nominal)),
          m_plausible(static_cast<Eigen::Index>(m_unknowns.size())) {
        for (std::size_t k = 0; k < m_unknowns.size(); ++k) {
            m_plausible[static_cast<Eigen::Index>(k)] = m_unknowns[k].plausible;
        }
    }

    const std::vector<CalibrationUnknown>& unknowns() const { return m_unknowns; }
    const Eigen::VectorXd& plausible() const { return m_plausible; }
    bool hasReference() const { return m_hasReference; }
    const std::vector<Oriented>& samples() const { return m_samples; }

    /// Orientations by the nominal calibration, or as given.
    Result<void> orient(std::span<const CalibrationSample> samples) {
        OrientationConfig method;
        method.method = OrientationMethod::LevenbergMarquardt;
        method.chiSquareLimit = 1e30; // the calibration is what is missing
        const auto estimator = OrientationEstimator::make(sensingOf(m_nominal, m_config.deviation_T), method);
        if (!estimator) {
            return failure(estimator.error());
        }
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const CalibrationSample& sample = samples[i];
            if (sample.reference) {
                m_hasReference = true;
                m_samples.push_back({sample, *sample.reference, i});
                continue;
            }
            const OrientationEstimate estimate = estimator->estimate(
                correctedReadings_T(m_nominal, sample.readings_T, sample.coilCurrent_A), sample.used);
            if (estimate.verdict == OrientationVerdict::Determined) {
                m_samples.push_back({sample, estimate.rotation, i});
            }
        }
        if (m_samples.size() < LeastSamples) {
            return failure(ErrorCode::Refused,
                           fmt::format("Only {} samples have a known orientation; the calibration needs {}.",
                                       m_samples.size(), LeastSamples),
                           "Use a longer recording, with the rotor moving and no channel clipped.");
        }
        return {};
    }

    double motion_rad() const {
        double largest_rad = 0.0;
        for (const Oriented& one : m_samples) {
            largest_rad = std::max(largest_rad, symmetricError_rad(one.rotation, m_samples.front().rotation));
        }
        return largest_rad;
    }

    /// `moved`: steps from the nominal calibration so far, in units of the plausible size.
    Reduced reduced(const SphericalCalibration& calibration, const Eigen::VectorXd& moved) const {
        const auto count = static_cast<Eigen::Index>(m_unknowns.size());
        const CalibrationModel model(calibration, m_unknowns);
        Reduced sum;
        sum.information.setZero(count, count);
        sum.gradient.setZero(count);
        for (const Oriented& one : m_samples) {
            CalibrationPrediction prediction = model.at(one.rotation, one.sample);
            const SphericalReadings weight = weights(one.sample);
            prediction.byUnknown *= m_plausible.asDiagonal();
            const SphericalReadings residual_T =
                (one.sample.readings_T - prediction.readings_T)
                    .cwiseProduct((weight.array() > 0.0).cast<double>().matrix());
            const Eigen::Matrix<double, 9, 3> weightedTurn = weight.asDiagonal() * prediction.byRotation;
            Eigen::Matrix3d own = weightedTurn.transpose() * prediction.byRotation;
            Eigen::Vector3d pull = weightedTurn.transpose() * residual_T;
            if (one.sample.reference) {
                const double certainty = std::pow(m_config.referenceDeviation_rad, -2);
                const Eigen::Vector3d off_rad =
                    vectorOfRotation(one.rotation * one.sample.reference->transpose());
                own += certainty * Eigen::Matrix3d::Identity();
                pull -= certainty * off_rad;
                sum.cost += certainty * off_rad.squaredNorm();
            }
            const Eigen::Matrix3d inverse = own.inverse();
            const Eigen::Matrix<double, 3, Eigen::Dynamic> cross =
                weightedTurn.transpose() * prediction.byUnknown;
            const Eigen::Matrix<double, 9, Eigen::Dynamic> weighted =
                weight.asDiagonal() * prediction.byUnknown;
            sum.base_rad.emplace_back(inverse * pull);
            sum.slope.emplace_back(inverse * cross);
            sum.information += prediction.byUnknown.transpose() * weighted;
            sum.information -= cross.transpose() * sum.slope.back();
            sum.gradient += weighted.transpose() * residual_T - cross.transpose() * sum.base_rad.back();
            sum.misfit.push_back(residual_T.dot(weight.cwiseProduct(residual_T)));
            sum.cost += sum.misfit.back();
            sum.readings += static_cast<double>((weight.array() > 0.0).count());
        }
        holdGauges(sum);
        holdPlaces(sum, moved);
        return sum;
    }

    /// Samples whose readings lie far beyond the scatter of the others have a wrong orientation: the nominal
    /// calibration, which knows no harmonics yet, put them on another branch. Orients them anew by what was
    /// found so far; how many now fit better.
    std::size_t reorient(const SphericalCalibration& calibration, const Reduced& reduced) {
        const std::vector<std::size_t> strange = strangeSamples(reduced.misfit);
        const double limit = strangeLimit(reduced.misfit);
        OrientationConfig method;
        method.method = OrientationMethod::LevenbergMarquardt;
        method.fit.isStrengthFree = false; // it is fitted already, by all samples
        method.chiSquareLimit = limit;
        const auto estimator =
            OrientationEstimator::make(sensingOf(calibration, m_config.deviation_T), method);
        const CalibrationModel model(calibration, m_unknowns);
        std::size_t better = 0;
        for (const std::size_t i : strange) {
            Oriented& one = m_samples[i];
            if (!estimator || one.sample.reference) {
                continue;
            }
            const OrientationEstimate estimate = estimator->estimate(
                correctedReadings_T(calibration, one.sample.readings_T, one.sample.coilCurrent_A),
                one.sample.used);
            const SphericalReadings off_T =
                one.sample.readings_T - model.at(estimate.rotation, one.sample).readings_T;
            if (off_T.dot(weights(one.sample).cwiseProduct(off_T)) < 0.5 * reduced.misfit[i]) {
                one.rotation = estimate.rotation;
                ++better;
            }
        }
        return better;
    }

    /// A few wrong orientations would bend what all others agree on. Not done where they are more than a few:
    /// then it is the model that is wrong.
    bool leaveOut(const std::vector<std::size_t>& strange) {
        constexpr std::size_t FewestTimes = 50;
        if (FewestTimes * strange.size() > m_samples.size()) {
            return false;
        }
        for (auto i = strange.rbegin(); i != strange.rend(); ++i) {
            m_samples.erase(m_samples.begin() + static_cast<std::ptrdiff_t>(*i));
        }
        return true;
    }

    void turn(const Reduced& reduced, const Eigen::VectorXd& step) {
        for (std::size_t i = 0; i < m_samples.size(); ++i) {
            const Eigen::Vector3d w = reduced.base_rad[i] - reduced.slope[i] * step;
            m_samples[i].rotation = rotationOfVector(w) * m_samples[i].rotation;
        }
    }

    int gauges() const { return (hasScaleGauge() ? 1 : 0) + (hasTurnGauge() ? 3 : 0); }
    bool hasScaleGauge() const { return m_config.selection.strength && m_config.selection.gains; }
    bool hasTurnGauge() const {
        return m_config.selection.directions && m_config.selection.turns && !m_hasReference &&
               !m_config.placeDeviation_rad;
    }

private:
    SphericalReadings weights(const CalibrationSample& sample) const {
        SphericalReadings weight;
        for (int i = 0; i < ChannelCount; ++i) {
            weight[i] = sample.used[static_cast<std::size_t>(i)] ? std::pow(m_config.deviation_T, -2) : 0.0;
        }
        return weight;
    }

    /// A row that keeps the sum of some unknowns where the nominal calibration has it; gauges are exact, so
    /// that the residual of the row is zero at every step.
    void holdGauges(Reduced& sum) const {
        const double certainty = std::pow(GaugeDeviation_ratio, -2);
        const auto hold = [&](CalibrationKind kind, int component) {
            Eigen::VectorXd row = Eigen::VectorXd::Zero(m_plausible.size());
            for (std::size_t k = 0; k < m_unknowns.size(); ++k) {
                const CalibrationUnknown& unknown = m_unknowns[k];
                if (unknown.kind == kind && (component < 0 || unknown.component == component)) {
                    row[static_cast<Eigen::Index>(k)] = 1.0;
                }
            }
            sum.information += certainty * row * row.transpose();
        };
        if (hasScaleGauge()) {
            hold(CalibrationKind::Gain, -1);
        }
        for (int c = 0; hasTurnGauge() && c < 3; ++c) {
            hold(CalibrationKind::Turn, c);
        }
    }

    void holdPlaces(Reduced& sum, const Eigen::VectorXd& moved) const {
        for (std::size_t k = 0; m_config.placeDeviation_rad && k < m_unknowns.size(); ++k) {
            if (m_unknowns[k].kind == CalibrationKind::Direction) {
                const auto row = static_cast<Eigen::Index>(k);
                const double certainty = std::pow(m_plausible[row] / *m_config.placeDeviation_rad, 2);
                sum.information(row, row) += certainty;
                sum.gradient[row] -= certainty * moved[row];
            }
        }
    }

    const SphericalCalibration& m_nominal;
    const CalibrationConfig& m_config;
    std::vector<CalibrationUnknown> m_unknowns;
    Eigen::VectorXd m_plausible;
    std::vector<Oriented> m_samples;
    bool m_hasReference = false;
};

CalibrationExcitation excitationOf(const Problem& problem, const Reduced& reduced) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(reduced.information);
    const double least = eigen.eigenvalues()[0];
    CalibrationExcitation excitation;
    excitation.weakest_ratio = least > 0.0 ? Normal95 / std::sqrt(least) : HUGE_VAL;
    const Eigen::VectorXd direction = eigen.eigenvectors().col(0);
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    excitation.weakest = direction.cwiseProduct(problem.plausible());
    excitation.name = problem.unknowns()[static_cast<std::size_t>(largest)].name;
    return excitation;
}

Result<void> checkConfig(const CalibrationConfig& config) {
    if (!(config.deviation_T > 0.0) || !(config.referenceDeviation_rad > 0.0) ||
        !(config.placeDeviation_rad.value_or(1.0) > 0.0) || config.iterations < 1) {
        return failure(ErrorCode::OutOfRange,
                       "A calibration needs positive deviations of readings, places and "
                       "known orientations and at least one iteration.");
    }
    const CalibrationSelection& s = config.selection;
    if (!(s.strength || s.harmonics || s.gains || s.skews || s.offsets || s.turns || s.directions ||
          s.drift || s.coil)) {
        return failure(ErrorCode::OutOfRange, "Nothing is selected to be calibrated.");
    }
    return {};
}

double valueOf(const SphericalCalibration& calibration, const CalibrationUnknown& unknown, double moved) {
    const SensorCalibration& sensor = calibration.sensors[static_cast<std::size_t>(unknown.sensor)];
    switch (unknown.kind) {
    case CalibrationKind::Strength:
        return calibration.field.strength_T;
    case CalibrationKind::Harmonic:
        return calibration.field.harmonics[static_cast<std::size_t>(unknown.component)].amplitude_T;
    case CalibrationKind::Gain:
        return sensor.gain_ratio[unknown.component];
    case CalibrationKind::Skew:
        return sensor.skew_ratio[unknown.component];
    case CalibrationKind::Offset:
        return sensor.offset_T[unknown.component];
    case CalibrationKind::Drift:
        return calibration.drift_per_K;
    case CalibrationKind::Coil:
        return calibration.coil_T_per_A[3 * unknown.sensor + unknown.component];
    case CalibrationKind::Turn:
    case CalibrationKind::Direction:
        break;
    }
    return moved;
}

} // namespace

Result<CalibrationExcitation> calibrationExcitation(const SphericalCalibration& nominal,
                                                    std::span<const CalibrationSample> samples,
                                                    const CalibrationConfig& config) {
    if (auto checked = checkConfig(config); !checked) {
        return failure(checked.error());
    }
    Problem problem(nominal, config);
    if (auto oriented = problem.orient(samples); !oriented) {
        return failure(oriented.error());
    }
    return excitationOf(problem, problem.reduced(nominal, Eigen::VectorXd::Zero(problem.plausible().size())));
}

double calibrationGain(const SphericalCalibration& nominal, const CalibrationExcitation& excitation,
                       const CalibrationConfig& config, const Eigen::Matrix3d& rotation) {
    const auto unknowns = calibrationUnknowns(config.selection, nominal);
    const CalibrationPrediction prediction = CalibrationModel(nominal, unknowns).at(rotation, {});
    const SphericalReadings change_T = prediction.byUnknown * excitation.weakest;
    const Eigen::Matrix3d own = prediction.byRotation.transpose() * prediction.byRotation;
    const Eigen::Vector3d pull = prediction.byRotation.transpose() * change_T;
    const double unexplained = change_T.squaredNorm() - pull.dot(own.inverse() * pull);
    return unexplained / (config.deviation_T * config.deviation_T);
}

namespace {

/// Gauss-Newton from where the fit is to where it stays.
Result<void> settle(Problem& problem, const CalibrationConfig& config, CalibrationFit& fit,
                    Eigen::VectorXd& moved, Reduced& reduced) {
    double size = 1.0;
    for (int i = 0; size > 1e-7 && i < config.iterations; ++i, ++fit.iterations) {
        if (config.isStopped && config.isStopped()) {
            return failure(ErrorCode::Interrupted, "The calibration was stopped.");
        }
        const CalibrationExcitation excitation = excitationOf(problem, reduced);
        if (excitation.weakest_ratio >= Enough_ratio) {
            return failure(ErrorCode::Refused,
                           fmt::format("The motion does not determine this value: {}.", excitation.name),
                           "Record orientations that differ more in tilt and spin, or keep it at its "
                           "nominal value.");
        }
        Eigen::VectorXd step = reduced.information.ldlt().solve(reduced.gradient);
        // Linear only near by: at most the plausible size at once.
        step *= std::min(1.0, 1.0 / std::max(1e-12, step.cwiseAbs().maxCoeff()));
        size = step.cwiseAbs().maxCoeff();
        problem.turn(reduced, step);
        const Eigen::VectorXd step_SI = step.cwiseProduct(problem.plausible());
        fit.calibration = steppedCalibration(fit.calibration, problem.unknowns(), step_SI);
        moved += step;
        reduced = problem.reduced(fit.calibration, moved);
    }
    return {};
}

} // namespace

Result<CalibrationFit> calibrate(const SphericalCalibration& nominal,
                                 std::span<const CalibrationSample> samples,
                                 const CalibrationConfig& config) {
    if (auto checked = checkConfig(config); !checked) {
        return failure(checked.error());
    }
    Problem problem(nominal, config);
    if (auto oriented = problem.orient(samples); !oriented) {
        return failure(oriented.error());
    }
    if (problem.motion_rad() < LeastMotion_rad) {
        return failure(ErrorCode::Refused,
                       fmt::format("The rotor moved by only {:.1f} degrees in the recording.",
                                   radiansToDegrees(problem.motion_rad())),
                       "Move it through the whole workspace, tilt and spin.");
    }
    CalibrationFit fit;
    fit.calibration = nominal;
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(problem.plausible().size());
    Reduced reduced = problem.reduced(nominal, moved);
    constexpr int Rounds = 4;
    for (int round = 0; round < Rounds; ++round) {
        if (auto settled = settle(problem, config, fit, moved, reduced); !settled) {
            return failure(settled.error());
        }
        if (round + 1 == Rounds || problem.reorient(fit.calibration, reduced) == 0) {
            break; // what was turned last is settled
        }
        reduced = problem.reduced(fit.calibration, moved);
    }
    const std::vector<std::size_t> strange = strangeSamples(reduced.misfit);
    fit.strange = strange.size();
    fit.isStrangeLeftOut = !strange.empty() && problem.leaveOut(strange);
    if (fit.isStrangeLeftOut) {
        reduced = problem.reduced(fit.calibration, moved);
        if (auto settled = settle(problem, config, fit, moved, reduced); !settled) {
            return failure(settled.error());
        }
    }
    const auto unknowns = static_cast<double>(problem.unknowns().size());
    const double orientations =
        problem.hasReference() ? 0.0 : 3.0 * static_cast<double>(problem.samples().size());
    fit.chiSquare = reduced.cost;
    fit.freedom = reduced.readings - orientations - unknowns + problem.gauges();
    fit.excess_ratio = std::sqrt(fit.chiSquare / std::max(1.0, fit.freedom));
    fit.deviation_T = config.deviation_T * fit.excess_ratio;
    const double widening = std::max(1.0, fit.excess_ratio);
    const auto size = problem.plausible().asDiagonal();
    fit.covariance = widening * widening * (size * reduced.information.inverse() * size);
    for (std::size_t k = 0; k < problem.unknowns().size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        const CalibrationUnknown& unknown = problem.unknowns()[k];
        fit.values.push_back({unknown, valueOf(fit.calibration, unknown, moved[row] * unknown.plausible),
                              Normal95 * std::sqrt(fit.covariance(row, row))});
    }
    for (const Oriented& one : problem.samples()) {
        fit.rotation.push_back(one.rotation);
        fit.sample.push_back(one.index);
    }
    if (problem.hasScaleGauge()) {
        fit.notes.emplace_back(
            "The common scale of all gains is not observable separately from the strength q: their mean is "
            "set to one. A known field is required; the orientation is not affected.");
    }
    if (problem.hasTurnGauge()) {
        fit.notes.emplace_back("A common rotation of all sensors is not observable: the mean rotation is set "
                               "to zero. A known orientation is required to determine it.");
    }
    return fit;
}

} // namespace halbench::models
