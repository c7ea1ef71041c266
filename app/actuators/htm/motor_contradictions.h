#pragma once

#include "app/actuators/actuator.h"

namespace halbench::app {

/// Sections 6 and 7 of resources/help/htm-theory.md.
std::span<const Contradiction> motorContradictions();

} // namespace halbench::app
