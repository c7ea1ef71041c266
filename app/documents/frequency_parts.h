#pragma once

#include "app/documents/text/json_value.h"
#include "app/procedures/frequency/frequency_procedure.h"

#include <complex>

namespace halbench::app {

/// A circle of confidence; the intervals are null when it holds zero or, of the phase, surrounds it.
JsonValue circleBody(std::complex<double> value, double radius);
/// {value, ci95, frequency_rad_s, withheld}
JsonValue marginBody(const control::MeasuredMargin& margin);

} // namespace halbench::app
