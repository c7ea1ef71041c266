#pragma once

#include "control/law/filtered_law.h"
#include "control/law/law_run.h"

#include <utility>

namespace halbench::control {

/// A law as the difference equation that runs. Errors: of `checkedGains`.
Result<LawEquation<double>> lawEquation(const FilteredLaw& law, double period_s);

/// The linear part of a law on one motor, one call a sample.
class FilteredController : public LawRun<double> {
public:
    /// Errors: of `checkedGains`.
    static Result<FilteredController> make(const FilteredLaw& law, double period_s);

private:
    explicit FilteredController(LawEquation<double> equation) : LawRun(std::move(equation), 0.0) {}
};

} // namespace halbench::control
