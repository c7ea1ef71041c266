#pragma once

#include "app/documents/configuration_comparison.h"
#include "app/documents/result_header.h"

#include <string>
#include <vector>

namespace halbench::app {

/// A table for people: rows that are the same are only counted; `outcomes` is empty for a mere comparison.
std::string comparisonText(const ConfigurationComparison& comparison,
                           const std::vector<RowOutcome>& outcomes);

/// `halbench.comparison/1` (resources/help/command-line.md, "Configuration files").
JsonValue comparisonDocument(ResultHeader header, const Configuration& file,
                             const ConfigurationComparison& comparison,
                             const std::vector<RowOutcome>& outcomes);

} // namespace halbench::app
