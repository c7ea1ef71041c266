#pragma once

#include "app/actuators/actuator.h"

namespace halbench::app {

/// Section 11 of resources/help/spherical-theory.md.
std::span<const Contradiction> sensingContradictions();

} // namespace halbench::app
