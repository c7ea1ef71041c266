#pragma once

#include "control/base/parameter_spec.h"

#include <vector>

namespace halbench::widgets {

/// Five parameters of every kind: two gains, a limit that is read only, an enumeration, a switch.
inline std::vector<ParameterSpec> someSpecs() {
    ParameterSpec kp;
    kp.name = "gain.kp";
    kp.unit = "A/rad";
    kp.defaultValue = 10.0;
    kp.max = 1000.0;
    kp.group = "Gains";
    kp.help = "Proportional gain of the position loop";
    kp.isTransactional = true;
    ParameterSpec ki = kp;
    ki.name = "gain.ki";
    ki.unit = "A/(rad*s)";
    ki.defaultValue = 0.1;
    ki.help = "Integral gain of the position loop";
    ParameterSpec limit = kp;
    limit.name = "limit.current";
    limit.unit = "A";
    limit.defaultValue = 4.0;
    limit.max = 4.0;
    limit.group = "Limits";
    limit.help = "The board clips the current here";
    limit.access = ParameterAccess::ReadOnly;
    ParameterSpec decode = kp;
    decode.name = "decode.method";
    decode.unit = "";
    decode.defaultValue = 0.0;
    decode.max = 1.0;
    decode.isInteger = true;
    decode.group = "Sensing";
    decode.help = "How the angle is decoded";
    decode.choices = {"arctangent", "linear fit"};
    ParameterSpec stray = decode;
    stray.name = "stray.enabled";
    stray.choices = {};
    stray.help = "Whether the coil's own field is taken off";
    return {kp, ki, limit, decode, stray};
}

inline std::vector<ParameterValue> someValues() {
    return {{"gain.kp", 10.0},
            {"gain.ki", 0.1},
            {"limit.current", 4.0},
            {"decode.method", 0.0},
            {"stray.enabled", 1.0}};
}

} // namespace halbench::widgets
