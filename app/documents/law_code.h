#pragma once

#include "app/procedures/tune/analyse.h"
#include "devices/device.h"

#include <optional>
#include <string>

namespace halbench::app {

/// Origin of a law, for the head of its file.
struct LawOrigin {
    std::string method; ///< empty: not said
    std::optional<devices::DeviceInfo> device;
};

/// A position law with these gains as one C99 file for another controller: a struct with the memory, a
/// function that starts it and one that is called once per sample. The board's law, or a filtered one as
/// `BoardLawRun` has it: each filter a section of its own, sampled as its loop was judged. The numbers
/// are written so that reading them gives the same bits. The dead time of the loop belongs to the board and
/// is not in it. Help: resources/help/tuning.md, "The law for another controller". Errors: of a filtered law.
Result<std::string> lawCode(const LoopLaw& law, const LoopConditions& conditions, const LawOrigin& origin);

/// The same into a file; without a path nothing is done. Error: FileSystem.
Result<void> writeLaw(const std::string& path, const LoopLaw& law, const LoopConditions& conditions,
                      const LawOrigin& origin);

} // namespace halbench::app
