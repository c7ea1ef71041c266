#include "app/procedures/tune/analyse.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace halbench::app {

namespace {

using Values = std::map<std::string, double>;

constexpr std::string_view Absolute[] = {"J", "c", "Kf", "phi"};

std::string symbolOf(const std::string& name) {
    static const std::map<std::string, std::string, std::less<>> symbols = {
        {"viscous_damping", "c"}, {"coulomb_friction", "Kf"}, {"torque_constant", "phi"}, {"inertia", "J"}};
    const auto found = symbols.find(name);
    return found == symbols.end() ? name : found->second;
}

std::optional<double> value(const Values& values, const std::string& key) {
    const auto found = values.find(key);
    return found == values.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> quotient(std::optional<double> numerator, std::optional<double> denominator) {
    return numerator && denominator && *denominator != 0.0 ? std::optional(*numerator / *denominator)
                                                           : std::nullopt;
}

/// A ratio as it stands, or from its two absolute values.
std::optional<double> ratio(const Values& values, const std::string& over, const std::string& under) {
    const auto direct = value(values, over + "_over_" + under);
    return direct ? direct : quotient(value(values, over), value(values, under));
}

/// The three ratios by every route the values allow.
struct PartialPlant {
    std::optional<double> dampingRate_1_s;
    std::optional<double> accelerationGain_rad_s2_A;
    std::optional<double> breakawayCurrent_A;

    bool isComplete() const { return dampingRate_1_s && accelerationGain_rad_s2_A && breakawayCurrent_A; }
};

PartialPlant resolve(const Values& values) {
    PartialPlant plant{ratio(values, "c", "J"), ratio(values, "phi", "J"), ratio(values, "Kf", "phi")};
    const auto dampingPerTorque = ratio(values, "c", "phi");
    if (!plant.dampingRate_1_s && plant.accelerationGain_rad_s2_A && dampingPerTorque) {
        plant.dampingRate_1_s = *dampingPerTorque * *plant.accelerationGain_rad_s2_A;
    }
    if (!plant.accelerationGain_rad_s2_A) {
        plant.accelerationGain_rad_s2_A = quotient(plant.dampingRate_1_s, dampingPerTorque);
    }
    if (!plant.breakawayCurrent_A) {
        plant.breakawayCurrent_A = quotient(ratio(values, "Kf", "J"), plant.accelerationGain_rad_s2_A);
    }
    return plant;
}

Result<control::PositionPlant> completed(const PartialPlant& plant) {
    if (!plant.isComplete()) {
        std::string missing;
        const auto add = [&missing](const std::optional<double>& known, std::string_view name) {
            missing += known ? "" : fmt::format("{}{}", missing.empty() ? "" : ", ", name);
        };
        add(plant.accelerationGain_rad_s2_A, "phi/J");
        add(plant.dampingRate_1_s, "c/J");
        add(plant.breakawayCurrent_A, "K_f/phi");
        return failure(
            ErrorCode::Refused, fmt::format("{} is missing in the model; it determines the loop", missing),
            "steady speeds alone do not show the inertia: identify with run-ups and coast-downs, or give "
            "the constant that is known (--given J=...)");
    }
    // Without friction its estimate comes out on either side of zero.
    constexpr double NoFriction_A = 1e-3;
    const double breakaway_A = *plant.breakawayCurrent_A < -NoFriction_A
                                   ? *plant.breakawayCurrent_A
                                   : std::max(*plant.breakawayCurrent_A, 0.0);
    control::PositionPlant result{*plant.dampingRate_1_s, *plant.accelerationGain_rad_s2_A, breakaway_A};
    if (const auto valid = control::checkPlant(result); !valid) {
        return failure(valid.error());
    }
    return result;
}

Result<void> checkValues(const MotorEstimate& estimate) {
    for (const auto& [name, number] : estimate.values) {
        if (!std::isfinite(number)) {
            return failure(ErrorCode::NotFinite, fmt::format("{} of the model is not a finite number", name));
        }
    }
    return {};
}

Values withSymbols(const Values& values) {
    Values result;
    for (const auto& [name, number] : values) {
        result.emplace(symbolOf(name), number);
    }
    return result;
}

/// The smallest set of values that holds the uncertain ones and still makes a plant: a ratio that is listed
/// beside its uncertain parts must not hide their uncertainty.
Values decisiveValues(const Values& all, const std::set<std::string>& uncertain) {
    Values chosen;
    for (const auto& [name, number] : all) {
        if (uncertain.contains(name)) {
            chosen.emplace(name, number);
        }
    }
    if (resolve(chosen).isComplete()) {
        return chosen;
    }
    for (const std::string_view name : Absolute) {
        if (const auto number = value(all, std::string(name))) {
            chosen.emplace(name, *number);
        }
    }
    return resolve(chosen).isComplete() ? chosen : all;
}

Result<Eigen::MatrixXd> covarianceMatrix(const MotorEstimate& estimate) {
    const std::size_t n = estimate.covarianceNames.size();
    const bool isSquare =
        estimate.covariance.size() == n && std::all_of(estimate.covariance.begin(), estimate.covariance.end(),
                                                       [n](const auto& row) { return row.size() == n; });
    if (!isSquare) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("the covariance of the model names {} values but is not {} x {}", n, n, n));
    }
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
            matrix(i, j) = estimate.covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        }
    }
    if (!matrix.allFinite()) {
        return failure(ErrorCode::NotFinite, "the covariance of the model holds a value that is not finite");
    }
    return matrix;
}

} // namespace

Result<control::PositionPlant> plantFromEstimate(const MotorEstimate& estimate) {
    if (const auto valid = checkValues(estimate); !valid) {
        return failure(valid.error());
    }
    return completed(resolve(withSymbols(estimate.values)));
}

Result<control::UncertainPlant> uncertainPlantFromEstimate(const MotorEstimate& estimate) {
    const auto plant = plantFromEstimate(estimate);
    if (!plant) {
        return failure(plant.error());
    }
    auto covariance = covarianceMatrix(estimate);
    if (!covariance) {
        return failure(covariance.error());
    }
    const Values all = withSymbols(estimate.values);
    std::vector<std::string> names;
    control::UncertainPlant result;
    result.mean.resize(covariance->rows());
    for (const std::string& name : estimate.covarianceNames) {
        const auto number = value(all, symbolOf(name));
        if (!number) {
            return failure(
                ErrorCode::InvalidInput,
                fmt::format("the covariance contains '{}', for which the model has no value", name));
        }
        result.mean(static_cast<Eigen::Index>(names.size())) = *number;
        names.push_back(symbolOf(name));
    }
    result.covariance = *covariance;
    const Values decisive = decisiveValues(all, {names.begin(), names.end()});
    result.toPlant = [decisive, names](const Eigen::VectorXd& draw) {
        Values values = decisive;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (const auto found = values.find(names[i]); found != values.end()) {
                found->second = draw(static_cast<Eigen::Index>(i));
            }
        }
        const PartialPlant drawn = resolve(values);
        return control::PositionPlant{drawn.dampingRate_1_s.value_or(0.0),
                                      drawn.accelerationGain_rad_s2_A.value_or(0.0),
                                      std::max(drawn.breakawayCurrent_A.value_or(0.0), 0.0)};
    };
    return result;
}

} // namespace halbench::app
