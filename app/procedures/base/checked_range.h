#pragma once

#include "control/base/result.h"

namespace halbench::app {

/// A number that a procedure was asked to keep to, named in words with its unit. Errors: NotFinite,
/// OutOfRange, saying what is allowed.
Result<void> checkRange(const char* what, double value, double min, double max);

} // namespace halbench::app
