#pragma once

#include "control/base/result.h"

#include <QLockFile>

#include <memory>
#include <string>
#include <utility>

namespace halbench::app {

/// Says to other windows that a project is open here: `<project>.lock` beside it, gone when this object and
/// its copies are. One that a dead program left is taken over; one of another machine never is. Thread: GUI.
class ProjectLock {
public:
    ProjectLock() = default; ///< of no project

    /// Where the folder cannot be written there is no lock and no error: nothing can be saved there either.
    /// Errors: Refused, naming the program that has the project.
    static Result<ProjectLock> take(const std::string& projectPath);

    /// Whether it is for this file, by whatever way that is named.
    bool isOf(const std::string& projectPath) const;

private:
    std::string m_path;
    std::shared_ptr<QLockFile> m_file; ///< of all copies
};

} // namespace halbench::app
