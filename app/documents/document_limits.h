#pragma once

#include "app/documents/text/json_value.h"

#include <string>

namespace halbench::app {

/// Limits of values that physics or arithmetic sets, for every key of a document that has some: a period
/// above zero, a coherence from 0 to 1, a whole number of cycles. Other keys, null and texts are passed.
/// Values must be in the unit that the program takes them in (parseDocument). Error: InvalidInput naming the
/// key, its value and what is possible.
Result<void> checkLimits(const JsonValue& document, const std::string& origin);

/// The covariance of `covariance.{names, matrix}`: no negative variance, symmetric, no correlation beyond 1.
/// Nothing where there is none or where it is no square of numbers. Error: InvalidInput naming row and
/// column.
Result<void> checkCovarianceLimits(const JsonValue& document, const std::string& origin);

} // namespace halbench::app
