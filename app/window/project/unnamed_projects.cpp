#include "app/window/project/unnamed_projects.h"

#include "app/documents/text/output_file.h"

#include <QFileInfo>

#include <fmt/format.h>

#include <optional>

namespace halbench::app {

namespace {

/// More windows than anybody opens; those beyond share the last place.
constexpr int MostPlaces = 50;

std::string placeNumber(const std::string& base, int number) {
    if (number == 1) {
        return base;
    }
    const std::size_t ending = base.rfind('.');
    return fmt::format("{}-{}{}", base.substr(0, ending), number, base.substr(ending));
}

/// A damaged one was somebody's work too.
bool isWaiting(const std::string& path) {
    const std::string file = autosavePath(path);
    if (!QFileInfo::exists(QString::fromStdString(file))) {
        return false;
    }
    const Result<Project> left = loadProject(file);
    return !left || holdsWork(*left);
}

bool isFree(const std::string& path) {
    return !isWaiting(path);
}

std::optional<UnnamedPlace> firstPlace(const std::string& base, bool (*isWanted)(const std::string&)) {
    for (int number = 1; number <= MostPlaces; ++number) {
        const std::string path = placeNumber(base, number);
        if (!isWanted(path)) {
            continue;
        }
        if (Result<ProjectLock> lock = ProjectLock::take(path)) {
            return UnnamedPlace{path, *std::move(lock)};
        }
    }
    return std::nullopt;
}

} // namespace

bool holdsWork(const Project& project) {
    return !project.notes.empty() || !project.models.empty() || !project.designs.empty() ||
           !project.calibrations.empty() || !project.given.empty() || !project.monitor.derived.empty();
}

UnnamedPlace claimUnnamed(const std::string& base, bool isFresh) {
    (void)createFolderOf(base); // without it nothing can be kept, which the autosave says
    std::optional<UnnamedPlace> place;
    if (!isFresh) {
        place = firstPlace(base, isWaiting);
    }
    if (!place) {
        place = firstPlace(base, isFree);
    }
    return place ? *std::move(place) : UnnamedPlace{placeNumber(base, MostPlaces), {}};
}

std::vector<std::string> waitingUnnamed(const std::string& base) {
    std::vector<std::string> paths;
    for (int number = 1; number <= MostPlaces; ++number) {
        const std::string path = placeNumber(base, number);
        if (isWaiting(path) && ProjectLock::take(path)) {
            paths.push_back(path);
        }
    }
    return paths;
}

} // namespace halbench::app
