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

bool isInput(const CommandLine& line, const std::string& path) {
    std::vector<std::string> inputs = line.options.names;
    inputs.push_back(line.options.input);
    // These say themselves that they would replace what they read.
    const bool saysSo = line.command == "convert" || line.command == "overlay" || line.command == "import";
    return saysSo && std::any_of(inputs.begin(), inputs.end(), [&](const auto& input) {
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

std::vector<std::string> outputsOf(const CommandLine& line) {
    const CommandOptions& options = line.options;
    std::vector<std::string> files = {options.recordFile, options.bodeFile, options.stepFile,
                                      options.polesFile,  options.codeFile, options.whatIfFile};
    if (line.command != "run") {
        files.push_back(options.out);
    }
    if (line.command == "config" && options.what == "save") {
        files.push_back(options.input);
    }
    for (const std::string& picture : options.pictures) { // VIEW=FILE
        files.push_back(picture.substr(std::min(picture.find('='), picture.size() - 1) + 1));
    }
    std::erase(files, "");
    const std::size_t count = files.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool isRecording = files[i] == options.recordFile || line.command == "record" ||
                                 line.command == "move" || line.command == "convert" ||
                                 line.command == "import" || line.command == "overlay";
        if (isRecording && fs::path(files[i]).extension() == ".csv") {
            files.push_back(devices::metaPathOf(files[i]));
        }
    }
    return files;
}

Result<void> checkOutputs(const CommandLine& line) {
    if (line.command == "run") {
        return line.options.isDryRun ? Result<void>()
                                     : checkFolder(line.options.out, line.global.mayOverwrite);
    }
    for (const std::string& file : outputsOf(line)) {
        if (!line.global.mayOverwrite && isThere(file) && !isInput(line, file)) {
            return failure(ErrorCode::Usage, fmt::format("'{}' exists already", file),
                           "use another name, or overwrite it with --force");
        }
    }
    return {};
}

} // namespace halbench::app
