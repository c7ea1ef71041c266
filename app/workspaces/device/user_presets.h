#pragma once

#include "app/documents/presets.h"
#include "devices/device.h"

#include <QString>

#include <vector>

namespace halbench::app {

/// A named set of parameters that can be loaded: shipped ones first, then the user's own.
struct PresetChoice {
    QString title;
    QString path; ///< of the user's file; empty for a shipped one
    std::string name;
};

/// Presets of a model that can be chosen. A user's file that cannot be read is listed too: loading it says
/// why.
std::vector<PresetChoice> presetChoices(const std::string& model, const QString& folder);

/// Errors: UnknownName; FileSystem; InvalidInput for a damaged file, one of a newer version or of another
/// model.
Result<Preset> loadPreset(const std::string& model, const PresetChoice& choice);

/// Writes `<folder>/<model>/<name>.json` ("halbench.preset/1", resources/help/monitor.md) through a temporary
/// file, so that an older one of this name stays whole until the new one is. Gives the path. Errors: Usage
/// (name), FileSystem.
Result<QString> saveUserPreset(const Preset& preset, const QString& folder);

/// Where user presets live.
QString userPresetFolder();

} // namespace halbench::app
