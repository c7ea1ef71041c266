#include "app/actuators/planar/platen_estimate.h"

#include "control/base/distributions.h"
#include "models/planar/windings_wrench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace halbench::app {
namespace {

using control::Estimate;
using control::EstimateSource;
using namespace platen;

using Quantity = std::function<double(const PlatenVector&)>;

void remark(DataQuality& quality, Verdict verdict, std::string code, std::string message, std::string hint) {
    quality.verdict = std::max(quality.verdict, verdict);
    quality.findings.push_back({std::move(code), std::move(message), std::move(hint)});
}

// Functions of the unknowns with their intervals, by the first derivatives.
class Derived {
public:
    explicit Derived(const PlatenFit& fit)
        : m_fit(fit), m_quantile(control::studentQuantile(0.975, fit.freedom)) {}

    PlatenVector gradient(const Quantity& quantity) const {
        PlatenVector slope;
        for (int i = 0; i < Count; ++i) {
            const double step = 0.01 * std::sqrt(std::max(m_fit.covariance(i, i), 1e-30));
            PlatenVector high = m_fit.value, low = m_fit.value;
            high(i) += step;
            low(i) -= step;
            slope(i) = (quantity(high) - quantity(low)) / (2.0 * step);
        }
        return slope;
    }

    double deviation(const Quantity& quantity) const {
        const PlatenVector slope = gradient(quantity);
        return std::sqrt(std::max(slope.dot(m_fit.covariance * slope), 0.0));
    }

    Estimate estimate(const Quantity& quantity, std::string unit) const {
        const double value = quantity(m_fit.value);
        const double half = m_quantile * deviation(quantity);
        return {value, std::pair(value - half, value + half), EstimateSource::Identified, std::move(unit)};
    }

    double value(const Quantity& quantity) const { return quantity(m_fit.value); }
    double covariance(const Quantity& a, const Quantity& b) const {
        return gradient(a).dot(m_fit.covariance * gradient(b));
    }

private:
    const PlatenFit& m_fit;
    double m_quantile;
};

double meanGain(const PlatenVector& p, int first, int last) {
    return p.segment(first - 1, last - first + 1).mean();
}

Estimate notIdentifiable(std::string unit) {
    return {std::nullopt, std::nullopt, EstimateSource::NotIdentifiable, std::move(unit)};
}

// What is never negative; an interval that reaches below ends at zero.
Estimate notNegative(Estimate estimate) {
    estimate.value = std::max(*estimate.value, 0.0);
    estimate.interval95 = {std::max(estimate.interval95->first, 0.0),
                           std::max(estimate.interval95->second, 0.0)};
    return estimate;
}

// The quantities of one axis, see AxisModel.
struct AxisQuantities {
    Quantity dampingRate, gain, breakaway, stiffnessRate, damping, stiffness, friction;
};

// b: force constant of the windings over that of the board's model, both of one nominal coil.
AxisQuantities quantitiesOf(const std::string& axis, double b) {
    if (axis == "phi") {
        const Quantity gain = [b](const PlatenVector& p) { return b * meanGain(p, 1, 4) / p(Inertia); };
        return {[](const PlatenVector& p) { return p(DampingPhi) / p(Inertia); },
                gain,
                [gain](const PlatenVector& p) { return p(FrictionPhi) / p(Inertia) / gain(p); },
                [](const PlatenVector& p) { return p(StiffnessPhi) / p(Inertia); },
                [](const PlatenVector& p) { return p(DampingPhi); },
                [](const PlatenVector& p) { return p(StiffnessPhi); },
                [](const PlatenVector& p) { return p(FrictionPhi); }};
    }
    const bool isX = axis == "x";
    const int first = isX ? 5 : 1, last = isX ? 6 : 4;
    const int damping = isX ? DampingX : DampingY;
    const int stiffness = isX ? StiffnessX : StiffnessY;
    const int friction = isX ? FrictionX : FrictionY;
    const Quantity gain = [b, first, last](const PlatenVector& p) { return b * meanGain(p, first, last); };
    const auto at = [](int i) { return Quantity([i](const PlatenVector& p) { return p(i); }); };
    return {
        at(damping),   gain,        [gain, friction](const PlatenVector& p) { return p(friction) / gain(p); },
        at(stiffness), at(damping), at(stiffness),
        at(friction)};
}

class Report {
public:
    Report(const PlatenFit& fit, const PlatenBoard& board, const GivenPlaten& given)
        : m_fit(fit), m_board(board), m_derived(fit),
          m_nominal(models::windingsForceConstant_N_per_A(board.geometry)) {
        if (given.mass_kg) {
            m_mass = [m = *given.mass_kg](const PlatenVector&) { return m; };
        } else if (given.inertia_kg_m2) {
            m_mass = [i = *given.inertia_kg_m2](const PlatenVector& p) { return i / p(Inertia); };
        }
        m_isMassGiven = given.mass_kg.has_value();
        m_isInertiaGiven = given.inertia_kg_m2.has_value();
    }

    AxesIdentifyResult make(const std::vector<devices::AxisSpec>& axes, const MeasuredTiming& timing) {
        for (const devices::AxisSpec& axis : axes) {
            addAxis(axis, timing);
        }
        setCovariance(axes);
        addConstants(axes);
        judge();
        return std::move(m_result);
    }

private:
    double boardRatio() const { return std::fabs(m_nominal / m_board.forceConstant_N_per_A); }

    void addAxis(const devices::AxisSpec& spec, const MeasuredTiming& timing) {
        const AxisQuantities q = quantitiesOf(spec.id, boardRatio());
        IdentifiedAxis axis;
        axis.axis = spec.id;
        axis.positionUnit = spec.positionUnit;
        axis.effortUnit = spec.effortUnit;
        axis.timing = timing;
        axis.dampingRate = notNegative(m_derived.estimate(q.dampingRate, "1/s"));
        axis.accelerationGain = m_derived.estimate(q.gain, accelerationGainUnit(axis));
        axis.breakawayEffort = notNegative(m_derived.estimate(q.breakaway, spec.effortUnit));
        m_result.ratios.push_back({"stiffness_rate_" + spec.id, "stiffness over inertia of " + spec.id,
                                   m_derived.estimate(q.stiffnessRate, "1/s^2")});
        judgeAxis(axis);
        m_result.model.axes.push_back(std::move(axis));
    }

    void judgeAxis(const IdentifiedAxis& axis) {
        const auto half = [](const Estimate& estimate) {
            return 0.5 * (estimate.interval95->second - estimate.interval95->first);
        };
        DataQuality& quality = m_result.quality;
        if (*axis.accelerationGain.value <= 0.0 ||
            half(axis.accelerationGain) > 0.1 * *axis.accelerationGain.value) {
            remark(quality, Verdict::Refused, "not_excited",
                   fmt::format("axis {}: the acceleration per effort is {:.3g} +- {:.2g} {}", axis.axis,
                               *axis.accelerationGain.value, half(axis.accelerationGain),
                               axis.accelerationGain.unit),
                   "The motion does not excite the axis enough: check that nothing holds the platen.");
        } else if (axis.dampingRate.interval95->first <= 0.0) {
            remark(quality, Verdict::Doubtful, "damping_not_seen",
                   fmt::format("axis {}: damping is below the resolution, at most {:.3g} 1/s", axis.axis,
                               axis.dampingRate.interval95->second),
                   "Design with the upper bound, or identify again with more room.");
        }
        if (axis.breakawayEffort.interval95->first <= 0.0) {
            remark(quality, Verdict::Good, "friction_bound",
                   fmt::format("axis {}: friction is below the resolution, at most {:.2g} {}", axis.axis,
                               axis.breakawayEffort.interval95->second, axis.effortUnit),
                   "Nothing to do: an air film has none.");
        }
    }

    // Of all that the model names, joint over the axes.
    void setCovariance(const std::vector<devices::AxisSpec>& axes) {
        std::vector<Quantity> quantities;
        for (const devices::AxisSpec& axis : axes) {
            const AxisQuantities q = quantitiesOf(axis.id, boardRatio());
            const std::array<std::pair<const char*, Quantity>, 3> named = {
                {{".damping_rate", q.dampingRate},
                 {".acceleration_gain", q.gain},
                 {".breakaway_effort", q.breakaway}}};
            for (const auto& [name, quantity] : named) {
                m_result.model.covarianceNames.push_back(axis.id + name);
                quantities.push_back(quantity);
            }
        }
        for (const Quantity& a : quantities) {
            std::vector<double> row;
            for (const Quantity& b : quantities) {
                row.push_back(m_derived.covariance(a, b));
            }
            m_result.model.covariance.push_back(std::move(row));
        }
        // Rounding leaves the two halves a last digit apart.
        for (std::size_t i = 0; i < quantities.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                m_result.model.covariance[i][k] = m_result.model.covariance[k][i];
            }
        }
    }

    // Needs a given constant: the ratio times the mass.
    void addAbsolute(const char* name, const char* title, const Quantity& perMass, const char* unit) {
        if (!m_mass) {
            m_result.constants.push_back({name, title, notIdentifiable(unit)});
            return;
        }
        const Quantity absolute = [this, perMass](const PlatenVector& p) { return m_mass(p) * perMass(p); };
        m_result.constants.push_back({name, title, m_derived.estimate(absolute, unit)});
    }

    void addConstants(const std::vector<devices::AxisSpec>& axes) {
        const Quantity inertia = [](const PlatenVector& p) { return p(Inertia); };
        m_result.ratios.push_back(
            {"inertia_over_mass", "inertia over mass", m_derived.estimate(inertia, "m^2")});
        addAbsolute(
            "mass", "moving mass", [](const PlatenVector&) { return 1.0; }, "kg");
        addAbsolute("inertia", "inertia about the vertical", inertia, "kg*m^2");
        for (NamedEstimate& each : m_result.constants) {
            if ((m_isMassGiven && each.name == "mass") || (m_isInertiaGiven && each.name == "inertia")) {
                each.estimate.source = EstimateSource::Given;
            }
        }
        const double nominal = std::fabs(m_nominal);
        const std::array<std::tuple<const char*, const char*, int, int>, 3> sets = {
            {{"force_constant_12", "force constant of coils 1 and 2", 1, 2},
             {"force_constant_34", "force constant of coils 3 and 4", 3, 4},
             {"force_constant_56", "force constant of coils 5 and 6", 5, 6}}};
        for (const auto& [name, title, first, last] : sets) {
            const Quantity perMass = [nominal, f = first, l = last](const PlatenVector& p) {
                return nominal * meanGain(p, f, l);
            };
            m_result.ratios.push_back({fmt::format("{}_over_mass", name), fmt::format("{}, over mass", title),
                                       m_derived.estimate(perMass, "N/(A*kg)")});
            addAbsolute(name, title, perMass, "N/A");
        }
        addAxisConstants(axes);
        addCentre();
    }

    void addAxisConstants(const std::vector<devices::AxisSpec>& axes) {
        for (const devices::AxisSpec& axis : axes) {
            const bool turns = axis.positionUnit == "rad";
            const AxisQuantities q = quantitiesOf(axis.id, boardRatio());
            addAbsolute(("damping_" + axis.id).c_str(), ("damping of " + axis.title).c_str(), q.damping,
                        turns ? "N*m*s/rad" : "N*s/m");
            addAbsolute(("stiffness_" + axis.id).c_str(), ("stiffness of the cable, " + axis.title).c_str(),
                        q.stiffness, turns ? "N*m/rad" : "N/m");
            addAbsolute(("friction_" + axis.id).c_str(), ("friction of " + axis.title).c_str(), q.friction,
                        turns ? "N*m" : "N");
        }
    }

    void addCentre() {
        const auto at = [](int i) { return Quantity([i](const PlatenVector& p) { return p(i); }); };
        m_result.constants.push_back(
            {"centre_x", "centre of mass along x'", m_derived.estimate(at(CentreX), "m")});
        m_result.constants.push_back(
            {"centre_y", "centre of mass along y'", m_derived.estimate(at(CentreY), "m")});
        m_result.constants.push_back(
            {"lag", "lag of the currents behind the board's outputs", m_derived.estimate(at(Delay), "s")});
    }

    const Estimate* find(const std::vector<NamedEstimate>& list, const std::string& name) const {
        const auto found =
            std::find_if(list.begin(), list.end(), [&](const auto& e) { return e.name == name; });
        return found == list.end() ? nullptr : &found->estimate;
    }

    static bool contradicts(const Estimate& measured, double believed, double relative) {
        return measured.interval95 &&
               (believed < measured.interval95->first || believed > measured.interval95->second) &&
               std::fabs(believed / *measured.value - 1.0) > relative;
    }

    void judge() {
        DataQuality& quality = m_result.quality;
        if (!m_mass) {
            remark(
                quality, Verdict::Good, "mass_not_given",
                "only ratios follow from the motion: mass, inertia, damping and force constants have no "
                "absolute value",
                "Weigh the platen and give its mass: --given m=0.64, in an experiment given = { m = 0.64 }.");
        }
        const Estimate& ratio = *find(m_result.ratios, "inertia_over_mass");
        const double believed = m_board.inertia_kg_m2 / m_board.mass_kg;
        if (contradicts(ratio, believed, 0.1)) {
            const double mass_kg = m_mass ? m_derived.value(m_mass) : m_board.mass_kg;
            remark(
                quality, Verdict::Good, "inertia_differs",
                fmt::format("the board's inertia of {:.3g} kg m^2 is contradicted: with {:.3g} kg the motion "
                            "shows {:.4g} kg m^2 ({:.4g} to {:.4g})",
                            m_board.inertia_kg_m2, mass_kg, mass_kg * *ratio.value,
                            mass_kg * ratio.interval95->first, mass_kg * ratio.interval95->second),
                "Set platen.inertia and feedforward.phi.inertia to it, and tune phi again: its loop gain is "
                "off by the same factor.");
        }
        judgeForces();
    }

    void judgeForces() {
        const Estimate* constant = find(m_result.constants, "force_constant_56");
        const double believed = std::fabs(m_board.forceConstant_N_per_A);
        if (constant != nullptr && constant->value && contradicts(*constant, believed, 0.03)) {
            remark(
                m_result.quality, Verdict::Good, "force_constant_differs",
                fmt::format("the board counts with {:.4g} N/A, the coils give {:.4g} N/A", believed,
                            *constant->value),
                fmt::format("Set coil.force_constant to {:.4g}; the published model leaves out the corners "
                            "of the windings.",
                            -*constant->value));
        }
        if (m_fit.leftOut > 0) {
            remark(m_result.quality, Verdict::Doubtful, "rows_lost",
                   fmt::format("{} of {} windows of the motion miss rows", m_fit.leftOut,
                               m_fit.leftOut + m_fit.windows),
                   "measure again");
        }
    }

    const PlatenFit& m_fit;
    const PlatenBoard& m_board;
    Derived m_derived;
    double m_nominal;
    Quantity m_mass; ///< empty: nothing was given
    bool m_isMassGiven = false, m_isInertiaGiven = false;
    AxesIdentifyResult m_result;
};

} // namespace

AxesIdentifyResult platenEstimate(const PlatenFit& fit, const PlatenBoard& board, const GivenPlaten& given,
                                  const std::vector<devices::AxisSpec>& axes, const MeasuredTiming& timing) {
    AxesIdentifyResult result = Report(fit, board, given).make(axes, timing);
    result.notes["windows"] = fit.windows;
    result.notes["residual_x_m_s2"] = fit.residualRms.x();
    result.notes["residual_y_m_s2"] = fit.residualRms.y();
    return result;
}

} // namespace halbench::app
