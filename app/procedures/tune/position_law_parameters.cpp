#include "app/procedures/tune/position_law_parameters.h"

#include "app/procedures/tune/tune.h"
#include "control/law/filtered_delta.h"
#include "control/law/named_filter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

struct Role {
    const char* role;
    double control::SampledPositionLaw::*member;
};

constexpr std::array Roles = {
    Role{"gain.kp", &control::SampledPositionLaw::kp_A_per_rad},
    Role{"gain.ki", &control::SampledPositionLaw::ki_A_per_rad_s},
    Role{"gain.kd", &control::SampledPositionLaw::kd_As_per_rad},
    Role{"gain.reference_weight", &control::SampledPositionLaw::referenceWeight},
    Role{"gain.derivative_reference_weight", &control::SampledPositionLaw::derivativeReferenceWeight},
    Role{"gain.derivative_filter", &control::SampledPositionLaw::derivativeFilter_s},
    Role{"feedforward.inertia", &control::SampledPositionLaw::inertia_As2_per_rad},
    Role{"feedforward.viscous", &control::SampledPositionLaw::viscous_As_per_rad},
    Role{"feedforward.coulomb", &control::SampledPositionLaw::coulomb_A},
    Role{"feedforward.coulomb_speed", &control::SampledPositionLaw::coulombSpeed_rad_s},
    Role{"stiction.current", &control::SampledPositionLaw::stiction_A},
    Role{"stiction.threshold", &control::SampledPositionLaw::stictionThreshold_rad},
    Role{"stiction.speed", &control::SampledPositionLaw::stictionSpeed_rad_s},
    Role{"limit.current", &control::SampledPositionLaw::limit_A},
};

/// The coefficients of a filter, as the board names them behind "filter.N.".
struct Coefficient {
    const char* name;
    double control::LawSection<double>::*member;
};
constexpr std::array Coefficients = {
    Coefficient{"b0", &control::LawSection<double>::b0}, Coefficient{"b1", &control::LawSection<double>::b1},
    Coefficient{"b2", &control::LawSection<double>::b2}, Coefficient{"a1", &control::LawSection<double>::a1},
    Coefficient{"a2", &control::LawSection<double>::a2}};

std::string filterRole(std::size_t filter, const Coefficient& coefficient) {
    return fmt::format("filter.{}.{}", filter + 1, coefficient.name);
}

/// How many filters in series the device's law has.
std::size_t filtersOf(const devices::Catalogue& catalogue) {
    std::size_t count = 0;
    while (count < control::MostFilters &&
           std::all_of(Coefficients.begin(), Coefficients.end(), [&](const Coefficient& coefficient) {
               return !catalogue.parameterForRole(filterRole(count, coefficient)).empty();
           })) {
        ++count;
    }
    return count;
}

/// A number of the law at its place on the device.
struct Place {
    std::string role;
    std::string parameter;
    double* number;
};

std::vector<Place> placesOf(const devices::Catalogue& catalogue, control::SampledPositionLaw& law) {
    std::vector<Place> places;
    const auto add = [&](const std::string& role, double& number) {
        const std::string name = catalogue.parameterForRole(role);
        if (!name.empty()) {
            places.push_back({role, name, &number});
        }
    };
    for (const Role& role : Roles) {
        add(role.role, law.*role.member);
    }
    law.sections.resize(filtersOf(catalogue));
    for (std::size_t i = 0; i < law.sections.size(); ++i) {
        for (const Coefficient& coefficient : Coefficients) {
            add(filterRole(i, coefficient), law.sections[i].*coefficient.member);
        }
    }
    return places;
}

/// What is beside the plain law.
bool isOfShaping(const std::string& role) {
    return role.starts_with("filter.") || role == "gain.reference_weight" ||
           role == "gain.derivative_reference_weight" || role == "gain.derivative_filter";
}

std::vector<ParameterValue> shapingValues(const devices::Catalogue& catalogue,
                                          control::SampledPositionLaw law) {
    std::vector<ParameterValue> values;
    for (const Place& place : placesOf(catalogue, law)) {
        if (isOfShaping(place.role)) {
            values.push_back({place.parameter, *place.number});
        }
    }
    return values;
}

} // namespace

BoardLawSpec boardLawSpec(const devices::Catalogue& catalogue) {
    const auto has = [&catalogue](const char* role) { return !catalogue.parameterForRole(role).empty(); };
    return {has("gain.reference_weight"), has("gain.derivative_reference_weight"),
            has("gain.derivative_filter"), filtersOf(catalogue)};
}

Result<void> checkOffered(const control::FilteredLaw& law, const BoardLawSpec& spec) {
    const bool isFiltered = law.gains.derivative != 0.0 && law.gains.filter_s.value_or(0.0) != 0.0;
    std::vector<std::string> missing;
    if (law.proportionalWeight != 1.0 && !spec.hasReferenceWeight) {
        missing.push_back("set-point weight b");
    }
    if (law.derivativeWeight != 0.0 && !spec.hasDerivativeReferenceWeight) {
        missing.push_back("set-point weight c");
    }
    if (isFiltered && !spec.hasDerivativeFilter) {
        missing.push_back("derivative filter");
    }
    if (law.filters.size() > spec.filters) {
        missing.push_back(spec.filters == 0 ? std::string("filters in series")
                                            : fmt::format("more than {} filters in series", spec.filters));
    }
    if (missing.empty()) {
        return {};
    }
    return failure(ErrorCode::InvalidInput,
                   fmt::format("the control law of this device has no {}", fmt::join(missing, ", no ")),
                   "remove it from the gains, or save the control law as C code for another controller");
}

Result<control::SampledPositionLaw> readPositionLaw(devices::Device& device) {
    return readPositionLaw(device, device.catalogue());
}

Result<control::SampledPositionLaw> readPositionLaw(devices::Device& device,
                                                    const devices::Catalogue& catalogue) {
    control::SampledPositionLaw law;
    const auto& known = catalogue.knownConstants;
    if (const auto period = known.find("T_s"); period != known.end()) {
        law.period_s = period->second;
    }
    const std::vector<Place> places = placesOf(catalogue, law);
    std::vector<std::string> names;
    for (const Place& place : places) {
        names.push_back(place.parameter);
    }
    const std::string delay = catalogue.parameterForRole("delay.samples");
    if (!delay.empty()) {
        names.push_back(delay);
    }
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        *places[i].number = (*values)[i];
    }
    if (!delay.empty()) {
        law.delaySamples = static_cast<int>(std::lround(values->back()));
    }
    return law;
}

std::vector<ParameterValue> positionLawValues(const devices::Catalogue& catalogue,
                                              const control::SampledPositionLaw& law) {
    control::SampledPositionLaw written = law;
    const std::string limit = catalogue.parameterForRole("limit.current");
    std::vector<ParameterValue> values;
    for (const Place& place : placesOf(catalogue, written)) {
        if (place.parameter != limit) {
            values.push_back({place.parameter, *place.number});
        }
    }
    return values;
}

Result<std::vector<ParameterValue>> lawForDevice(const LoopLaw& law, const devices::Catalogue& catalogue) {
    auto values = lawForDevice(law.law, catalogue);
    if (!values) {
        return values;
    }
    const control::FilteredLaw filtered = asFiltered(law);
    if (const auto offered = checkOffered(filtered, boardLawSpec(catalogue)); !offered) {
        return failure(offered.error());
    }
    const auto period = catalogue.knownConstants.find("T_s");
    const control::LoopTiming timing{
        period == catalogue.knownConstants.end() ? control::LoopTiming().period_s : period->second, 0};
    constexpr double AnyLimit_A = 1.0; // the limit is the board's own
    auto board = control::boardLaw(filtered, law.law, timing, AnyLimit_A);
    if (!board) {
        return failure(board.error());
    }
    for (const ParameterValue& value : shapingValues(catalogue, *board)) {
        if (const auto valid = checkParameterValue(*catalogue.findParameter(value.name), value.value);
            !valid) {
            return failure(valid.error());
        }
        values->push_back(value);
    }
    return values;
}

void addPlainShaping(std::vector<ParameterValue>& values, const devices::Catalogue& catalogue) {
    for (const ParameterValue& value : shapingValues(catalogue, {})) {
        const bool isNamed = std::any_of(values.begin(), values.end(), [&value](const ParameterValue& named) {
            return named.name == value.name;
        });
        if (!isNamed) {
            values.push_back(value);
        }
    }
}

bool isSameLaw(const LoopLaw& one, const LoopLaw& other, double period_s) {
    const control::FilteredLaw first = asFiltered(one);
    const control::FilteredLaw second = asFiltered(other);
    const auto firstSections = control::filterSections(first.filters, period_s);
    const auto secondSections = control::filterSections(second.filters, period_s);
    const auto isNear = [](double a, double b) { return std::fabs(a - b) <= 1e-6 * std::fabs(a) + 1e-12; };
    return isSameLaw(one.law, other.law) && isNear(first.proportionalWeight, second.proportionalWeight) &&
           isNear(first.derivativeWeight, second.derivativeWeight) &&
           isNear(first.gains.filter_s.value_or(0.0), second.gains.filter_s.value_or(0.0)) && firstSections &&
           secondSections &&
           std::equal(firstSections->begin(), firstSections->end(), secondSections->begin(),
                      secondSections->end(), control::isSameOnBoard);
}

Result<LoopLaw> loopLawFromParameters(const std::map<std::string, double>& values, double period_s) {
    const auto plain = lawFromParameters(values);
    if (!plain) {
        return failure(plain.error());
    }
    control::FilteredLaw filtered;
    filtered.gains = plain->gains;
    const auto number = [&values](const std::string& name, double otherwise) {
        const auto found = values.find(name);
        return found == values.end() ? otherwise : found->second;
    };
    filtered.proportionalWeight = number("gain.reference_weight", filtered.proportionalWeight);
    filtered.derivativeWeight = number("gain.derivative_reference_weight", filtered.derivativeWeight);
    const double filter_s = number("gain.derivative_filter", 0.0);
    if (filter_s != 0.0) {
        filtered.gains.filter_s = filter_s;
    }
    for (std::size_t i = 0; i < control::MostFilters; ++i) {
        control::LawSection<double> section;
        for (const Coefficient& coefficient : Coefficients) {
            section.*coefficient.member = number(filterRole(i, coefficient), section.*coefficient.member);
        }
        if (!(section == control::LawSection<double>())) {
            filtered.filters.push_back(control::namedFilter(section, period_s));
        }
    }
    if (control::isBoardLaw(filtered)) {
        return LoopLaw(*plain);
    }
    return checkedLaw(LoopLaw(*plain, std::move(filtered)), period_s);
}

} // namespace halbench::app
