#pragma once

#include "control/law/law_run.h"
#include "control/law/shaped_law.h"

#include <utility>

namespace halbench::control {

/// A law as the difference equation that runs. Errors: of `checkedGains`.
Result<LawEquation<double>> lawEquation(const ShapedLaw& law, double period_s);

/// The linear part of a law on one motor, one call a sample.
class ShapedController : public LawRun<double> {
public:
    /// Errors: of `checkedGains`.
    static Result<ShapedController> make(const ShapedLaw& law, double period_s);

private:
    explicit ShapedController(LawEquation<double> equation) : LawRun(std::move(equation), 0.0) {}
};

} // namespace halbench::control
