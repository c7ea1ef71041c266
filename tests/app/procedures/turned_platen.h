#pragma once

#include "app/procedures/base/procedure_steps.h"

#include <gtest/gtest.h>

namespace halbench::app {

/// A platen whose turn is commanded by a step of the board itself, without the check of the travel: beyond 20
/// mrad it leans on its end stop (resources/help/planar-theory.md section 3).
inline void turnPlaten(devices::Device& device, double angle_rad) {
    constexpr double Held_s = 0.3, Turned_s = 1.0, Braked_s = 0.35;
    const ParameterValue step[] = {{"window.phi", 0.04},
                                   {"reference.phi.shape", 1.0},
                                   {"reference.phi.amplitude", angle_rad},
                                   {"reference.phi.base", 0.0},
                                   {"reference.phi.duration", 2.0 * Turned_s},
                                   {"hb.mode", static_cast<double>(devices::BoardMode::Position)}};
    const ParameterValue start[] = {{"reference.start", 1.0}};
    ASSERT_TRUE(device.writeParameters(step));
    ASSERT_TRUE(device.arm());
    ASSERT_TRUE(waitObserved(device, {}, Held_s));
    ASSERT_TRUE(device.writeParameters(start));
    ASSERT_TRUE(waitObserved(device, {}, Turned_s));
    ASSERT_TRUE(device.disarm());
    ASSERT_TRUE(waitObserved(device, {}, Braked_s));
    const ParameterValue window[] = {{"window.phi", 0.03}, {"reference.phi.shape", 0.0}};
    ASSERT_TRUE(device.writeParameters(window));
}

} // namespace halbench::app
