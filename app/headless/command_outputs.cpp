#include "app/headless/command_outputs.h"

#include "devices/recording/recording_meta.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace halbench::app {

namespace {

namespace fs = std::filesystem;

constexpr std::array ResultEndings = {".json", ".xml",     ".html", ".csv", ".svg",  ".pdf",    ".png",
                                      ".c",    ".partial", ".mf4",  ".mat", ".toml", ".damaged"};

bool isThere(const std::string& path) {
    std::error_code problem; // what cannot be looked at is found out by writing
    return fs::is_regular_file(path, problem);
}

bool isInput(const CommandOutputs& outputs, const std::string& path) {
    return std::any_of(outputs.inputs.begin(), outputs.inputs.end(), [&](const auto& input) {
        std::error_code missing;
        return fs::equivalent(path, input, missing);
    });
}

/// Same file, also by another path; a device or pipe takes any number of results.
bool areSameFile(const std::string& one, const std::string& other) {
    std::error_code problem; // a path that cannot be followed is told apart by its text
    const auto placeOf = [&problem](const std::string& file) {
        const fs::path place = fs::weakly_canonical(fs::absolute(file), problem);
        return problem ? fs::path(file).lexically_normal() : place;
    };
    return placeOf(one) == placeOf(other) && (!fs::exists(one, problem) || fs::is_regular_file(one, problem));
}

/// The second of two results would replace the first, which --force does not ask for.
Result<void> checkDistinct(const std::vector<std::string>& files) {
    for (auto file = files.begin(); file != files.end(); ++file) {
        const auto other = std::find_if(
            files.begin(), file, [&](const std::string& before) { return areSameFile(before, *file); });
        if (other != file) {
            return failure(ErrorCode::Usage, fmt::format("two results would be written to '{}'", *file),
                           "give each result a file of its own");
        }
    }
    return {};
}

/// A folder with what a run writes, and nothing else.
bool holdsResults(const std::string& folder) {
    std::error_code problem;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, problem)) {
        const std::string ending = entry.path().extension().string();
        const bool isResult =
            std::find(ResultEndings.begin(), ResultEndings.end(), ending) != ResultEndings.end();
        if (entry.is_directory(problem) || !isResult) {
            return false;
        }
    }
    return !problem;
}

Result<void> checkFolder(const std::string& folder, bool mayOverwrite) {
    std::error_code missing;
    if (folder.empty() || !fs::is_directory(folder, missing) || fs::is_empty(folder, missing)) {
        return {};
    }
    if (!holdsResults(folder)) {
        return failure(ErrorCode::Usage,
                       fmt::format("the folder '{}' contains files that are not results", folder),
                       "use an empty or a new folder");
    }
    return mayOverwrite ? Result<void>()
                        : failure(ErrorCode::Usage, fmt::format("the folder '{}' is not empty", folder),
                                  "use another folder, or overwrite the results with --force");
}

} // namespace

std::vector<std::string> writtenFiles(const CommandOutputs& outputs) {
    std::vector<std::string> files = outputs.recordings;
    files.insert(files.end(), outputs.files.begin(), outputs.files.end());
    for (const std::string& recording : outputs.recordings) {
        if (fs::path(recording).extension() == ".csv") {
            files.push_back(devices::metaPathOf(recording));
        }
    }
    std::erase(files, "");
    return files;
}

Result<void> checkOutputs(const CommandOutputs& outputs, bool mayOverwrite) {
    const std::vector<std::string> files = writtenFiles(outputs);
    if (const Result<void> distinct = checkDistinct(files); !distinct) {
        return distinct;
    }
    for (const std::string& file : files) {
        if (!mayOverwrite && isThere(file) && !isInput(outputs, file)) {
            return failure(ErrorCode::Usage, fmt::format("'{}' exists already", file),
                           "use another name, or overwrite it with --force");
        }
    }
    return checkFolder(outputs.folder, mayOverwrite);
}

} // namespace halbench::app
