#include "app/headless/command_outputs.h"

#include "devices/device_uri.h"
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

bool isSame(const std::string& path, const std::string& other) {
    std::error_code missing; // a file that is not there is no other's
    return fs::equivalent(path, other, missing);
}

/// Possible paths in the value of an option: all of it, the files of a device's address, what an assignment
/// sets, and a file of a reference, which ends at the next comma.
std::vector<std::string> pathsIn(const std::string& value) {
    std::vector<std::string> paths{value};
    if (const auto uri = devices::parseDeviceUri(value)) {
        paths.push_back(uri->address);
        if (const auto description = uri->option("a2l")) {
            paths.push_back(devices::fileOfOption(*description));
        }
    }
    for (std::size_t equals = value.find('='); equals != std::string::npos;
         equals = value.find('=', equals + 1)) {
        paths.push_back(value.substr(equals + 1));
        paths.push_back(value.substr(equals + 1, value.find('&', equals) - equals - 1));
        paths.push_back(value.substr(equals + 1, value.find(',', equals) - equals - 1));
    }
    return paths;
}

/// Removes the value of the option that names the output.
void removeValueOf(const std::string& output, std::vector<std::string>& values) {
    const auto own = std::find_if(values.begin(), values.end(), [&output](const std::string& value) {
        const std::vector<std::string> paths = pathsIn(value);
        return std::find(paths.begin(), paths.end(), output) != paths.end();
    });
    if (own != values.end()) {
        values.erase(own);
    }
}

Error wouldOverwrite(const std::string& file, const std::string& input) {
    return {ErrorCode::Usage, fmt::format("'{}' would overwrite '{}', which this command reads", file, input),
            "use another name for the result; --force does not overwrite an input"};
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

std::vector<std::string> namedInputs(const CommandOutputs& outputs, std::vector<std::string> values) {
    for (const std::vector<std::string>* own : {&outputs.files, &outputs.recordings}) {
        for (const std::string& output : *own) {
            removeValueOf(output, values);
        }
    }
    std::vector<std::string> inputs;
    for (const std::string& value : values) {
        for (const std::string& path : pathsIn(value)) {
            for (const std::string& file : {path, devices::metaPathOf(path)}) {
                if (isThere(path) && isThere(file)) {
                    inputs.push_back(file);
                }
            }
        }
    }
    return inputs;
}

Result<void> checkKeepsInputs(const CommandOutputs& outputs) {
    const std::vector<std::string> files = writtenFiles(outputs);
    for (const std::string& input : outputs.inputs) {
        for (const std::string& file : files) {
            if (isSame(file, input)) {
                return failure(wouldOverwrite(file, input));
            }
        }
        for (const std::string& file : outputs.files) { // a recording moves an older working file aside
            if (!file.empty() && isSame(file + ".partial", input)) {
                return failure(wouldOverwrite(file + ".partial", input));
            }
        }
        const fs::path place(input);
        const std::string folder = place.has_parent_path() ? place.parent_path().string() : ".";
        if (!outputs.folder.empty() && place.extension() != ".toml" && isSame(outputs.folder, folder)) {
            return failure(
                ErrorCode::Usage,
                fmt::format("the folder '{}' contains '{}', which this command reads", outputs.folder, input),
                "use another folder; --force does not overwrite an input");
        }
    }
    return {};
}

Result<void> checkOutputs(const CommandOutputs& outputs, bool mayOverwrite) {
    if (const Result<void> kept = checkKeepsInputs(outputs); !kept) {
        return kept;
    }
    const std::vector<std::string> files = writtenFiles(outputs);
    if (const Result<void> distinct = checkDistinct(files); !distinct) {
        return distinct;
    }
    for (const std::string& file : files) {
        if (!mayOverwrite && isThere(file)) {
            return failure(ErrorCode::Usage, fmt::format("'{}' exists already", file),
                           "use another name, or overwrite it with --force");
        }
    }
    return checkFolder(outputs.folder, mayOverwrite);
}

} // namespace halbench::app
