#pragma once

#include "app/window/project/project_file.h"
#include "app/window/project/project_lock.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Where a project without a name is autosaved, by one window alone.
struct UnnamedPlace {
    std::string path; ///< autosavePath() of it is the file
    ProjectLock lock;
};

/// `base`, else the same with "-2", "-3" ... before its ending: the first that no other window has. With
/// `isFresh` one that holds no work; otherwise one that an earlier window left with work goes first.
UnnamedPlace claimUnnamed(const std::string& base, bool isFresh);

/// Those that hold work and that no window has.
std::vector<std::string> waitingUnnamed(const std::string& base);

/// Results or notes; an arrangement of panels alone is none.
bool holdsWork(const Project& project);

} // namespace halbench::app
