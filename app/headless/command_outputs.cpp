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
    for (const std::string& file : writtenFiles(outputs)) {
        if (!mayOverwrite && isThere(file) && !isInput(outputs, file)) {
            return failure(ErrorCode::Usage, fmt::format("'{}' exists already", file),
                           "use another name, or overwrite it with --force");
        }
    }
    return checkFolder(outputs.folder, mayOverwrite);
}

} // namespace halbench::app
