#include "app/analyses/registry/analyses.h"

#include "app/analyses/planar/force_analysis.h"
#include "app/analyses/spherical/coverage_analysis.h"
#include "app/analyses/spherical/differences_analysis.h"
#include "app/analyses/spherical/estimator_analysis.h"
#include "app/analyses/spherical/field_analysis.h"
#include "app/analyses/spherical/orientation_analysis.h"
#include "app/analyses/spherical/placement_analysis.h"
#include "app/analyses/spherical/readings_analysis.h"
#include "app/analyses/spherical/swarm_analysis.h"

#include <algorithm>

namespace halbench::app {

const std::vector<Analysis>& analyses() {
    static const std::vector<Analysis> all = {
        orientationAnalysis(), coverageAnalysis(),  placementAnalysis(),
        readingsAnalysis(),    estimatorAnalysis(), differencesAnalysis(),
        swarmAnalysis(),       fieldAnalysis(),     forceAnalysis()};
    return all;
}

const Analysis* findAnalysis(std::string_view name) {
    const auto found = std::find_if(analyses().begin(), analyses().end(),
                                    [name](const Analysis& analysis) { return analysis.name == name; });
    return found == analyses().end() ? nullptr : &*found;
}

} // namespace halbench::app
