#include "control/identify/joint_estimate.h"

#include "control/base/assert.h"
#include "control/base/distributions.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

// The board's crystal, 1 sigma of 50 in a million: c/J goes with time, K_f/J and phi/J with its square.
constexpr double ClockError_ratio = 2.9e-5;

constexpr double Infinite = std::numeric_limits<double>::infinity();

int index(MotorConstant constant) {
    return static_cast<int>(constant);
}

using ConstantValues = std::array<std::optional<double>, MotorConstants>;

ConstantValues valuesOf(const GivenConstants& given) {
    return {given.inertia_kg_m2, given.viscousDamping_Nm_s, given.coulombFriction_Nm,
            given.torqueConstant_Nm_per_A};
}

// 1 sigma and Student's factor of one quantity whose error is `gradient` times the ratios' errors; limits are
// added in full.
double halfWidth95(const Eigen::VectorXd& gradient, const std::vector<ErrorPart>& errors) {
    double total = 0.0;
    double uncertainty = 0.0;
    double limits = 0.0;
    for (const ErrorPart& part : errors) {
        const double variance = gradient.dot(part.covariance * gradient);
        if (part.isLimit) {
            limits += std::sqrt(3.0 * std::fmax(variance, 0.0));
            continue;
        }
        total += variance;
        uncertainty += std::isinf(part.freedom) ? 0.0 : variance * variance / part.freedom;
    }
    if (!(total > 0.0)) {
        return limits;
    }
    const double factor = uncertainty > 1e-9 * total * total
                              ? studentQuantile(0.975, std::fmax(total * total / uncertainty, 1.0))
                              : normalQuantile(0.975);
    return limits + factor * std::sqrt(total);
}

// The causes of one error of the torque's scale, which moves the ratios by `change` times itself.
void addScaleError(MotorRatios& data, const Eigen::VectorXd& change, const TorqueScaleError& error) {
    const Eigen::MatrixXd unit = change * change.transpose();
    data.errors.push_back({error.random_ratio * error.random_ratio * unit, Infinite});
    if (error.limit_ratio > 0.0) {
        data.errors.push_back({error.limit_ratio * error.limit_ratio / 3.0 * unit, Infinite, true});
    }
}

Estimate identified(double value, double half, std::string unit) {
    return {value, std::pair(value - half, value + half), EstimateSource::Identified, std::move(unit)};
}

Eigen::MatrixXd totalCovariance(const MotorRatios& data) {
    const auto count = static_cast<Eigen::Index>(data.ratios.size());
    Eigen::MatrixXd total = Eigen::MatrixXd::Zero(count, count);
    for (const ErrorPart& part : data.errors) {
        HB_ASSERT(part.covariance.rows() == count && part.covariance.cols() == count);
        total += part.covariance;
    }
    return total;
}

// Constants tied to a given one by measured ratios. Zero times any ratio is zero: a constant that is given as
// none gives the others no scale.
std::array<bool, MotorConstants> tiedToGiven(const MotorRatios& data, const ConstantValues& given) {
    std::array<bool, MotorConstants> tied{};
    for (int i = 0; i < MotorConstants; ++i) {
        tied[static_cast<std::size_t>(i)] = given[static_cast<std::size_t>(i)].value_or(0.0) != 0.0;
    }
    for (int pass = 0; pass < MotorConstants; ++pass) {
        for (const MotorRatio& ratio : data.ratios) {
            bool& numerator = tied[static_cast<std::size_t>(index(ratio.numerator))];
            bool& denominator = tied[static_cast<std::size_t>(index(ratio.denominator))];
            numerator = denominator = numerator || denominator;
        }
    }
    return tied;
}

// The unknown constants as linear functions of the ratios' errors.
struct Absolute {
    std::vector<int> unknowns;
    Eigen::VectorXd values;
    Eigen::MatrixXd gradient; // unknowns x all ratios
    double misfit = 0.0;      // chi-square of the over-determined equations
    int freedom = 0;
};

class AbsoluteProblem {
public:
    AbsoluteProblem(const MotorRatios& data, const ConstantValues& given) : m_data(data), m_given(given) {
        const auto tied = tiedToGiven(data, given);
        for (int i = 0; i < MotorConstants; ++i) {
            if (tied[static_cast<std::size_t>(i)] && !given[static_cast<std::size_t>(i)]) {
                m_unknowns.push_back(i);
            }
        }
        for (std::size_t row = 0; row < data.ratios.size(); ++row) {
            if (tied[static_cast<std::size_t>(index(data.ratios[row].numerator))]) {
                m_rows.push_back(static_cast<Eigen::Index>(row));
            }
        }
    }

    Absolute solve() const {
        Absolute result;
        result.unknowns = m_unknowns;
        if (m_unknowns.empty() && m_rows.empty()) {
            return result;
        }
        const auto rows = static_cast<Eigen::Index>(m_rows.size());
        Eigen::VectorXd scale = Eigen::VectorXd::Ones(rows); // of each denominator
        for (int pass = 0; pass < 4; ++pass) {
            solveScaled(scale, result);
            for (Eigen::Index row = 0; row < rows; ++row) {
                scale(row) = std::fmax(std::fabs(valueOf(ratio(row).denominator, result)), 1e-12);
            }
        }
        return result;
    }

private:
    const MotorRatio& ratio(Eigen::Index row) const {
        return m_data.ratios[static_cast<std::size_t>(m_rows[static_cast<std::size_t>(row)])];
    }

    int column(MotorConstant constant) const {
        for (std::size_t i = 0; i < m_unknowns.size(); ++i) {
            if (m_unknowns[i] == index(constant)) {
                return static_cast<int>(i);
            }
        }
        return -1;
    }

    double valueOf(MotorConstant constant, const Absolute& result) const {
        const int place = column(constant);
        return place < 0 ? *m_given[static_cast<std::size_t>(index(constant))] : result.values(place);
    }

    void addTerm(MotorConstant constant, double factor, Eigen::Index row, Eigen::MatrixXd& matrix,
                 Eigen::VectorXd& right) const {
        const int place = column(constant);
        if (place >= 0) {
            matrix(row, place) += factor;
        } else {
            right(row) -= factor * *m_given[static_cast<std::size_t>(index(constant))];
        }
    }

    void solveScaled(const Eigen::VectorXd& scale, Absolute& result) const {
        const auto rows = static_cast<Eigen::Index>(m_rows.size());
        const auto unknowns = static_cast<Eigen::Index>(m_unknowns.size());
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, unknowns);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(rows);
        const Eigen::MatrixXd all = totalCovariance(m_data);
        Eigen::MatrixXd covariance(rows, rows);
        for (Eigen::Index i = 0; i < rows; ++i) {
            addTerm(ratio(i).numerator, 1.0, i, matrix, right);
            addTerm(ratio(i).denominator, -ratio(i).value, i, matrix, right);
            for (Eigen::Index k = 0; k < rows; ++k) {
                covariance(i, k) =
                    scale(i) * scale(k) *
                    all(m_rows[static_cast<std::size_t>(i)], m_rows[static_cast<std::size_t>(k)]);
            }
            const double rounding = 1e-13 * scale(i) * (std::fabs(ratio(i).value) + 1e-6);
            covariance(i, i) += rounding * rounding;
        }
        const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
        const Eigen::MatrixXd whiteMatrix = factor.matrixL().solve(matrix);
        const Eigen::VectorXd whiteRight = factor.matrixL().solve(right);
        const Eigen::MatrixXd normal = whiteMatrix.transpose() * whiteMatrix;
        const Eigen::LDLT<Eigen::MatrixXd> inverse(normal);
        result.values = unknowns > 0 ? Eigen::VectorXd(inverse.solve(whiteMatrix.transpose() * whiteRight))
                                     : Eigen::VectorXd();
        result.misfit = (whiteRight - whiteMatrix * result.values).squaredNorm();
        result.freedom = static_cast<int>(rows - unknowns);
        result.gradient = Eigen::MatrixXd::Zero(unknowns, all.cols());
        if (unknowns > 0) {
            const Eigen::MatrixXd white = factor.matrixL().solve(Eigen::MatrixXd(scale.asDiagonal()));
            const Eigen::MatrixXd map = inverse.solve(whiteMatrix.transpose() * white);
            for (Eigen::Index i = 0; i < rows; ++i) {
                result.gradient.col(m_rows[static_cast<std::size_t>(i)]) = map.col(i);
            }
        }
    }

    const MotorRatios& m_data;
    const ConstantValues& m_given;
    std::vector<int> m_unknowns;
    std::vector<Eigen::Index> m_rows;
};

// A constant or ratio as value and gradient, for ratios of ratios.
using RatioGradient = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, MotorConstants, 1>;

struct Known {
    double value = 0.0;
    RatioGradient gradient;
};

std::optional<Known> measured(const MotorRatios& data, MotorConstant numerator, MotorConstant denominator) {
    for (std::size_t i = 0; i < data.ratios.size(); ++i) {
        const MotorRatio& ratio = data.ratios[i];
        if (ratio.numerator == numerator && ratio.denominator == denominator) {
            Known known{ratio.value, RatioGradient::Zero(static_cast<Eigen::Index>(data.ratios.size()))};
            known.gradient(static_cast<Eigen::Index>(i)) = 1.0;
            return known;
        }
    }
    return std::nullopt;
}

std::optional<Known> quotient(const std::optional<Known>& a, const std::optional<Known>& b) {
    if (!a || !b || b->value == 0.0) {
        return std::nullopt;
    }
    const double value = a->value / b->value;
    return Known{value, (a->gradient - value * b->gradient) / b->value};
}

std::optional<Known> absolute(const JointEstimate& joint, const Absolute& solution, MotorConstant constant,
                              Eigen::Index ratios) {
    const Estimate& estimate = joint.constants[static_cast<std::size_t>(index(constant))];
    if (!estimate.value) {
        return std::nullopt;
    }
    Known known{*estimate.value, RatioGradient::Zero(ratios)};
    for (std::size_t i = 0; i < solution.unknowns.size(); ++i) {
        if (solution.unknowns[i] == index(constant)) {
            known.gradient = solution.gradient.row(static_cast<Eigen::Index>(i)).transpose();
        }
    }
    return known;
}

void addConstants(JointEstimate& joint, const MotorRatios& data, const ConstantValues& given,
                  const Absolute& solution) {
    for (int i = 0; i < MotorConstants; ++i) {
        Estimate& estimate = joint.constants[static_cast<std::size_t>(i)];
        estimate.unit = motorConstantName(static_cast<MotorConstant>(i)).unit;
        if (const auto& value = given[static_cast<std::size_t>(i)]) {
            estimate = {*value, std::pair(*value, *value), EstimateSource::Given, estimate.unit};
        }
    }
    for (std::size_t i = 0; i < solution.unknowns.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const double value = solution.values(row);
        const double half = halfWidth95(solution.gradient.row(row).transpose(), data.errors);
        const auto constant = static_cast<MotorConstant>(solution.unknowns[i]);
        const bool mustBePositive = constant == MotorConstant::Inertia || constant == MotorConstant::Torque;
        constexpr double WorstError = 0.6; // half width: 30 % at one sigma
        if (!std::isfinite(value) || !std::isfinite(half) ||
            (mustBePositive && !(half < WorstError * value))) {
            continue;
        }
        Estimate& estimate = joint.constants[static_cast<std::size_t>(index(constant))];
        estimate = identified(value, half, estimate.unit);
    }
}

void addRatios(JointEstimate& joint, const MotorRatios& data, const Absolute& solution) {
    using enum MotorConstant;
    struct Wanted {
        const char* name;
        MotorConstant numerator;
        MotorConstant denominator;
        const char* unit;
    };
    constexpr Wanted All[] = {{"c_over_J", Damping, Inertia, "1/s"},
                              {"Kf_over_J", Friction, Inertia, "rad/s^2"},
                              {"phi_over_J", Torque, Inertia, "rad/s^2/A"},
                              {"c_over_phi", Damping, Torque, "A*s/rad"},
                              {"Kf_over_phi", Friction, Torque, "A"}};
    const auto count = static_cast<Eigen::Index>(data.ratios.size());
    for (const Wanted& wanted : All) {
        Estimate& estimate = joint.ratios[wanted.name];
        estimate.unit = wanted.unit;
        auto known = measured(data, wanted.numerator, wanted.denominator);
        if (!known) {
            known = quotient(measured(data, wanted.numerator, Inertia),
                             measured(data, wanted.denominator, Inertia));
        }
        if (!known) {
            known = quotient(absolute(joint, solution, wanted.numerator, count),
                             absolute(joint, solution, wanted.denominator, count));
        }
        if (known) {
            estimate = identified(known->value, halfWidth95(known->gradient, data.errors), wanted.unit);
        }
    }
}

void addCovariance(JointEstimate& joint, const MotorRatios& data, const Absolute& solution) {
    const Eigen::MatrixXd all = totalCovariance(data);
    Eigen::MatrixXd gradient = solution.gradient;
    for (const int unknown : solution.unknowns) {
        joint.covarianceNames.emplace_back(motorConstantName(static_cast<MotorConstant>(unknown)).name);
    }
    if (solution.unknowns.empty()) {
        gradient = Eigen::MatrixXd::Identity(all.rows(), all.cols());
        for (const MotorRatio& ratio : data.ratios) {
            joint.covarianceNames.push_back(std::string(motorConstantName(ratio.numerator).symbol) +
                                            "_over_" + motorConstantName(ratio.denominator).symbol);
        }
    }
    joint.covariance = gradient * all * gradient.transpose();
}

// The worst ratio of a constant that is given as none, in standard errors squared; those that another given
// constant ties are judged with it.
std::optional<double> misfitOfNone(const MotorRatios& data, const ConstantValues& given) {
    const auto tied = tiedToGiven(data, given);
    const Eigen::MatrixXd all = totalCovariance(data);
    std::optional<double> worst;
    for (std::size_t i = 0; i < data.ratios.size(); ++i) {
        const auto numerator = static_cast<std::size_t>(index(data.ratios[i].numerator));
        const auto row = static_cast<Eigen::Index>(i);
        if (given[numerator] == 0.0 && !tied[numerator] && all(row, row) > 0.0) {
            const double misfit = data.ratios[i].value * data.ratios[i].value / all(row, row);
            worst = std::fmax(worst.value_or(0.0), misfit);
        }
    }
    return worst;
}

Consistency consistencyOf(const MotorRatios& data, double misfit, int tests) {
    double freedom = Infinite;
    for (const ErrorPart& part : data.errors) {
        freedom = std::fmin(freedom, part.freedom);
    }
    return {std::isinf(freedom) ? chiSquareTail(misfit, tests) : fisherTail(misfit / tests, tests, freedom),
            tests};
}

} // namespace

const char* estimateSourceName(EstimateSource source) {
    switch (source) {
    case EstimateSource::Identified:
        return "identified";
    case EstimateSource::Given:
        return "given";
    case EstimateSource::NotIdentifiable:
        break;
    }
    return "not identifiable";
}

const MotorConstantName& motorConstantName(MotorConstant constant) {
    static constexpr MotorConstantName Names[] = {{"J", "inertia", "kg*m^2"},
                                                  {"c", "viscous_damping", "N*m*s/rad"},
                                                  {"Kf", "coulomb_friction", "N*m"},
                                                  {"phi", "torque_constant", "N*m/A"}};
    return Names[index(constant)];
}

MotorRatios motorRatios(const MotionFit& motion, const std::optional<BalanceFit>& balance,
                        const TorqueScaleError& error) {
    using enum MotorConstant;
    MotorRatios data;
    data.ratios.push_back({Damping, Inertia, motion.damping_per_s});
    std::vector<int> places{0}; // in (a, f, k)
    if (balance && balance->friction_rad_s2) {
        data.ratios.push_back({Friction, Inertia, *balance->friction_rad_s2});
        places.push_back(1);
    }
    if (balance && balance->torque_rad_s2_A) {
        data.ratios.push_back({Torque, Inertia, *balance->torque_rad_s2_A});
        places.push_back(2);
    }
    Eigen::MatrixXd chosen = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(places.size()), 3);
    for (std::size_t i = 0; i < places.size(); ++i) {
        chosen(static_cast<Eigen::Index>(i), places[i]) = 1.0;
    }
    Eigen::Matrix3d byDamping = Eigen::Matrix3d::Zero();
    byDamping(0, 0) = motion.dampingError_per_s * motion.dampingError_per_s;
    for (const SharedError& shared : motion.sharedErrors) {
        byDamping(0, 0) += shared.damping_per_s * shared.damping_per_s;
    }
    Eigen::Matrix3d byScatter = Eigen::Matrix3d::Zero();
    if (balance) {
        byDamping = balance->dampingCovariance;
        byScatter = balance->scatterCovariance;
    }
    data.errors.push_back({chosen * byDamping * chosen.transpose(), motion.dampingFreedom});
    const bool isScatterSeen = balance && !balance->isScatterAssumed;
    data.errors.push_back({chosen * byScatter * chosen.transpose(),
                           isScatterSeen ? std::fmax(balance->freedom, 1.0) : Infinite});
    const double friction = balance ? balance->friction_rad_s2.value_or(0.0) : 0.0;
    const double torque = balance ? balance->torque_rad_s2_A.value_or(0.0) : 0.0;
    addScaleError(data, chosen * Eigen::Vector3d(0.0, 0.0, torque), error);
    const Eigen::Vector3d clock(motion.damping_per_s, 2.0 * friction, 2.0 * torque);
    const Eigen::VectorXd byClock = chosen * (ClockError_ratio * clock);
    data.errors.push_back({byClock * byClock.transpose(), Infinite});
    return data;
}

MotorRatios motorRatios(const FrictionSweep& sweep, const TorqueScaleError& error) {
    using enum MotorConstant;
    MotorRatios data;
    data.ratios = {{Damping, Torque, sweep.damping_A_s}, {Friction, Torque, sweep.friction_A}};
    const Eigen::Vector2d values(sweep.damping_A_s, sweep.friction_A);
    data.errors.push_back({sweep.covariance, static_cast<double>(sweep.freedom)});
    addScaleError(data, values, error);
    return data;
}

JointEstimate resolveConstants(const MotorRatios& data, const GivenConstants& given) {
    const ConstantValues values = valuesOf(given);
    const Absolute solution = AbsoluteProblem(data, values).solve();
    JointEstimate joint;
    addConstants(joint, data, values, solution);
    addRatios(joint, data, solution);
    addCovariance(joint, data, solution);
    if (solution.freedom > 0) {
        joint.consistency = consistencyOf(data, solution.misfit, solution.freedom);
    } else if (const std::optional<double> misfit = misfitOfNone(data, values)) {
        joint.consistency = consistencyOf(data, *misfit, 1);
    }
    return joint;
}

} // namespace halbench::control
