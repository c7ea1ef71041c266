#include "control/law/filtered_controller.h"

#include "control/law/filtered_delta.h"

namespace halbench::control {

Result<LawEquation<double>> lawEquation(const FilteredLaw& law, double period_s) {
    const auto gains = checkedGains(law, period_s);
    auto sections = gains ? filterSections(law.filters, period_s) : failure(gains.error());
    if (!sections) {
        return failure(sections.error());
    }
    LawEquation<double> equation;
    equation.proportional = gains->proportional;
    equation.integral = gains->integral;
    equation.derivative = gains->derivative;
    equation.proportionalWeight = law.proportionalWeight;
    equation.derivativeWeight = law.derivativeWeight;
    equation.derivativeFilter_s = gains->filter_s.value_or(0.0);
    equation.period_s = period_s;
    equation.sections = *std::move(sections);
    return equation;
}

Result<FilteredController> FilteredController::make(const FilteredLaw& law, double period_s) {
    auto equation = lawEquation(law, period_s);
    return equation ? Result<FilteredController>(FilteredController(*std::move(equation)))
                    : failure(equation.error());
}

} // namespace halbench::control
