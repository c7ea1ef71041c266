#pragma once

#include "app/workbench/recording_choice.h"
#include "app/workspaces/monitor/monitor_view.h"
#include "control/base/result.h"

#include <map>
#include <string>
#include <vector>

namespace halbench::app {

/// A result kept in a project under a name: the JSON text of a halbench.identification/1, halbench.gains/1 or
/// halbench.calibration/1.
struct NamedDocument {
    std::string name;
    std::string document;

    bool operator==(const NamedDocument&) const = default;
};

/// `halbench.project/1`: what a user works on, as a text file that can be compared line by line.
struct Project {
    std::string device; ///< URI; empty: none
    std::string notes;
    std::string perspective;
    std::map<std::string, std::string> layouts; ///< arrangement by perspective
    std::vector<NamedDocument> models;
    std::vector<NamedDocument> designs;
    std::vector<NamedDocument> calibrations;
    std::map<std::string, double> given; ///< constants of the motor known beforehand: J, c, Kf, phi in SI
    MonitorView monitor;
    std::map<std::string, MonitorView> furtherMonitors; ///< by panel; those that have plots
    RecordingChoice recording;
    /// What of the file is no layout of plots, with its line: it is as usual instead. Not in a file.
    std::vector<std::string> resets = {};

    bool operator==(const Project&) const = default;
};

/// Whether they differ in the arrangement of the panels at most: that goes into a file with the rest, but is
/// no change to keep by itself.
bool isSameWork(const Project& one, const Project& other);

/// Equal projects give equal text, keys in a fixed order.
std::string projectText(const Project& project);

/// `place` names the text in messages, e.g. its file name.
/// Errors: InvalidInput with line and column for a text that is no project, has a wrong type, an unknown key
/// or comes from a newer version. Sizes, columns, units and rate of plots that are none are in `resets`.
Result<Project> parseProject(const std::string& text, const std::string& place);

/// Writes beside the file and renames: the old one stays whole until the new one is. Errors: FileSystem.
Result<void> saveProject(const Project& project, const std::string& path);
/// Errors: FileSystem, InvalidInput.
Result<Project> loadProject(const std::string& path);

/// Where an open project is kept between saves; it is removed when the project is saved or given up on
/// purpose, so that one that is there means work that was not saved.
std::string autosavePath(const std::string& projectPath);

} // namespace halbench::app
