#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/identify/identify_procedure.h"
#include "app/procedures/tune/tune.h"

#include <optional>

namespace halbench::app {

/// Source of a result: a run of this window, a file or the project.
enum class ResultOrigin { Measured, File, Project };

/// Header of a result (device, firmware, time, software version) and where it came from.
struct Provenance {
    ResultHeader header;
    ResultOrigin origin = ResultOrigin::Measured;
};

/// The identified motor and the gains for it, which all panels share; apart from the workbench, since few of
/// its users read them and their headers are long.
struct SharedResults {
    std::optional<IdentifyResult> identification;
    Provenance provenance; ///< of the identification; it stays beside it
    std::optional<TuneResult> design;
    bool isDesignFromProject = false; ///< and no other was chosen since
    ResultHeader designHeader;        ///< when it was made, for whose motor
};

} // namespace halbench::app
