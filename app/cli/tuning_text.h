#pragma once

#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/tune/tune.h"

#include <string>

namespace halbench::app {

// What `tune` prints for those who read it in a terminal.

/// The gains, what they promise and what is found in them.
std::string gainsText(const TuneResult& result);
/// How the measured verification lies beside its prediction; empty without one.
std::string agreementLine(const ApplyResult& applied);

} // namespace halbench::app
