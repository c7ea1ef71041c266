#include "control/law/shaped_controller.h"

namespace halbench::control {

Result<ShapedEquation> ShapedEquation::make(const ShapedLaw& law, double period_s) {
    const auto gains = checkedGains(law, period_s);
    auto sections = gains ? filterSections(law.filters, period_s) : failure(gains.error());
    return sections
               ? Result<ShapedEquation>(ShapedEquation{*gains, law.proportionalWeight, law.derivativeWeight,
                                                       period_s, *std::move(sections)})
               : failure(sections.error());
}

Result<ShapedController> ShapedController::make(const ShapedLaw& law, double period_s) {
    auto equation = ShapedEquation::make(law, period_s);
    return equation ? Result<ShapedController>(ShapedController(*std::move(equation)))
                    : failure(equation.error());
}

} // namespace halbench::control
