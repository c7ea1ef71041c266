#pragma once

#include "control/base/result.h"
#include "control/identify/friction_sweep.h"
#include "control/identify/motion_fit.h"

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::control {

/// Constants that the user knows, SI; taken as exact.
struct GivenConstants {
    std::optional<double> inertia_kg_m2;
    std::optional<double> viscousDamping_Nm_s;
    std::optional<double> coulombFriction_Nm;
    std::optional<double> torqueConstant_Nm_per_A;

    bool isEmpty() const {
        return !inertia_kg_m2 && !viscousDamping_Nm_s && !coulombFriction_Nm && !torqueConstant_Nm_per_A;
    }
};

enum class EstimateSource { Identified, Given, NotIdentifiable };

/// "identified", "given", "not identifiable"
const char* estimateSourceName(EstimateSource source);

/// A number with its 95 % interval, or the statement that the data do not hold it.
struct Estimate {
    std::optional<double> value;
    std::optional<std::pair<double, double>> interval95;
    EstimateSource source = EstimateSource::NotIdentifiable;
    std::string unit;
};

/// The four constants of the motor, in the order of every table here.
enum class MotorConstant { Inertia, Damping, Friction, Torque };
inline constexpr int MotorConstants = 4;

/// A quotient of two constants that the data decided.
struct MotorRatio {
    MotorConstant numerator;
    MotorConstant denominator;
    double value = 0.0;
};

/// One cause of error: covariance of all ratios, and how well it is known itself (infinite: from a data
/// sheet, not from this data).
struct ErrorPart {
    Eigen::MatrixXd covariance;
    double freedom = 0.0;
    /// Of one quantity between limits instead: every value may be the true one, so the intervals reach both
    /// limits. The covariance is that of an even distribution between them, limit^2/3 (GUM 4.3.7).
    bool isLimit = false;
};

/// Ratios of the constants, which follow from the data alone.
struct MotorRatios {
    std::vector<MotorRatio> ratios;
    std::vector<ErrorPart> errors;
};

/// Relative error of the torque per commanded ampere, which no speed or angle can show.
struct TorqueScaleError {
    double random_ratio = 0.0; ///< 1 sigma of the current that really flows and of the magnets' strength
    double limit_ratio = 0.0;  ///< largest error of that current, where its user states one
};

/// c/J always, K_f/J and phi/J when the balances decide them.
MotorRatios motorRatios(const MotionFit& motion, const std::optional<BalanceFit>& balance,
                        const TorqueScaleError& error);
/// c/phi and K_f/phi of a steady sweep without transients.
MotorRatios motorRatios(const FrictionSweep& sweep, const TorqueScaleError& error);

/// Do several given constants contradict the data?
struct Consistency {
    double probability = 1.0; ///< of a larger disagreement if all given constants were right
    int freedom = 0;
};

struct JointEstimate {
    std::array<Estimate, MotorConstants> constants;
    std::map<std::string, Estimate> ratios; ///< c_over_J, Kf_over_J, phi_over_J, c_over_phi, Kf_over_phi
    std::vector<std::string> covarianceNames;
    Eigen::MatrixXd covariance;
    std::optional<Consistency> consistency; ///< when more was given than is needed, or none of one
};

/// Absolute values from ratios and given constants by generalised least squares on N - r D = 0. A constant
/// comes out only when measured ratios tie it to a given one that is not zero (help, htm-theory.md 7.1); the
/// intervals combine the causes of error with Welch and Satterthwaite's degrees of freedom. An inertia or
/// torque constant known worse than 30 % counts as not identifiable.
JointEstimate resolveConstants(const MotorRatios& data, const GivenConstants& given);

/// Short and long names and units by constant: "J", "inertia", "kg*m^2".
struct MotorConstantName {
    const char* symbol;
    const char* name;
    const char* unit;
};
const MotorConstantName& motorConstantName(MotorConstant constant);

} // namespace halbench::control
