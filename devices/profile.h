#pragma once

#include "control/base/result.h"
#include "devices/device.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// What the workstation knows of a model beyond the board's own description:
/// `resources/devices/<model>.json`, compiled in as `:/devices/<model>.json`.
///
///     { "schema": "halbench.profile/1", "model": "htm", "title": "Halbach-cylinder motor",
///       "signal_roles":    { "<role>": "<signal name>", ... },
///       "parameter_roles": { "<role>": "<parameter name>", ... },
///       "procedures":      [ "identify", ... ],
///       "constants":       { "I_max": 4.0, ... },
///       "default_signals": [ "position", ... ],
///       "calibration":     [ "<parameter name>", ... ],
///       "defaults":        { "<parameter name>": 0.5, ... },
///       "axes":            [ { "id": "x", "title": "x", "position_unit": "m", "effort_unit": "N",
///                              "roles": { "position": "<signal role>", "speed": ..., "reference": ...,
///                                         "effort": ..., "true_position": ...,
///                                         "position_window": "<parameter role>", "speed_window": ... },
///                              "generator": "<first part of its parameters' names>",
///                              "turns_forever": false, "window_margin": 1e-3, "settle_s": 3,
///                              "reference_tolerance": 1e-6, "end_tolerance": 5e-5 }, ... ] }
///
/// Only `schema` and `model` are required; an unknown key is an error, so that a typing mistake is seen.
struct Profile {
    std::string model;
    std::string title;
    std::map<std::string, std::string> signalRoles;
    std::map<std::string, std::string> parameterRoles;
    std::vector<std::string> procedures;
    std::map<std::string, double> constants;
    std::vector<std::string> defaultSignals;
    std::vector<std::string> calibration; ///< parameters that were measured on one device
    std::map<std::string, double> defaults;
    std::vector<AxisSpec> axes;
};

/// Reads a profile from JSON text; `origin` names it in messages.
/// Errors: InvalidInput with the place (offset of a syntax error, or the key).
Result<Profile> parseProfile(const std::string& json, const std::string& origin);

/// The shipped profile of a model; nothing when there is none. Errors as parseProfile().
Result<std::optional<Profile>> findProfile(const std::string& model);

/// Puts roles, axes, procedures, constants, default signals and default values into a catalogue read from a
/// board. Names that the board does not have are left out.
void applyProfile(const Profile& profile, Catalogue& catalogue);

} // namespace halbench::devices
