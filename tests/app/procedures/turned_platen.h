#pragma once

#include "app/procedures/move/move_procedure.h"

#include <gtest/gtest.h>

namespace halbench::app {

/// A platen whose turn was commanded by a step; beyond 20 mrad it leans on its end stop
/// (resources/help/planar-theory.md section 3).
inline void turnPlaten(devices::Device& device, double angle_rad) {
    MoveConfig there;
    there.axis = "phi";
    there.reference.shape = MoveReference::Shape::Step;
    there.reference.amplitude = angle_rad;
    const auto moved = performMove(device, there, {});
    ASSERT_TRUE(moved) << moved.error().message;
}

} // namespace halbench::app
