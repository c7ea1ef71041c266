#pragma once

#include "app/analyses/analysis.h"

namespace halbench::app {

/// Settings of an analysis as a command line would write them, by its keys.
struct AnalysisTexts {
    std::map<std::string, std::string> values;
    std::map<std::string, bool> flags;
};

/// A file of settings: TOML with the keys that a step of this kind has in an experiment. Errors: FileSystem;
/// InvalidInput with line and column for what is no TOML, an unknown key, a value of the wrong kind or out of
/// range.
Result<AnalysisTexts> readAnalysisSettings(const Analysis& analysis, const std::string& path);

} // namespace halbench::app
