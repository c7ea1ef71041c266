#pragma once

#include "app/documents/model_file.h"
#include "app/documents/text/json_value.h"
#include "app/procedures/tune/tune.h"

#include <string>
#include <vector>

namespace halbench::app {

/// The loop that gains of a file make with an identified motor.
struct ComparedLoop {
    std::string path; ///< of the gains
    GainsFile gains;
    AnalysisResult result;
    std::optional<Finding> timing = {}; ///< that the gains are for another one than `gains.timing`
};

/// `compared` of halbench.analysis/1: for each its file, its method and what analysisBody() tells.
JsonValue comparedLoops(const std::vector<ComparedLoop>& loops);

/// For reading: a row a figure, a column a file, in their order, headed by the file's name, or by its path
/// where names are the same.
std::string comparisonTable(const std::vector<ComparedLoop>& loops);

} // namespace halbench::app
