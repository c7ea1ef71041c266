#pragma once

#include "control/base/units.h"
#include "models/htm/htm_ideal_loop.h"

namespace halbench::models {

// References of the published motor on its ideal loop.

inline IdealLoopConfig loop(control::LoopReference reference, double duration_s, bool hasFriction = true) {
    IdealLoopConfig config;
    config.reference = reference;
    config.duration_s = duration_s;
    if (!hasFriction) {
        config.rotor.coulombFriction_Nm = 0.0;
    }
    return config;
}

inline control::LoopReference step(double amplitude_deg) {
    return {control::LoopReference::Shape::Step, degreesToRadians(amplitude_deg), 0, 0, 1, 1};
}

inline control::LoopReference sine(double amplitude_deg, double frequency_Hz) {
    return {control::LoopReference::Shape::Sine, degreesToRadians(amplitude_deg), 0, frequency_Hz, 1, 1};
}

inline control::LoopReference ramp(double rate_deg_s) {
    return {control::LoopReference::Shape::Ramp, 0, degreesToRadians(rate_deg_s), 0, 1, 1};
}

} // namespace halbench::models
