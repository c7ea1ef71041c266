#pragma once

#include "app/documents/text/config_node.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// One step, validated against the table of keys of its kind.
struct ExperimentStep {
    std::string kind;
    std::string name;
    ConfigNode keys;

    /// Values under a dotted key; nothing when the key is absent.
    std::optional<double> number(std::string_view key) const;
    std::optional<std::string> text(std::string_view key) const;
    bool isTrue(std::string_view key) const;
    std::vector<std::string> texts(std::string_view key) const;
    /// A table of numbers, nested tables flattened to dotted names.
    std::vector<std::pair<std::string, double>> numbers(std::string_view key) const;
    const ConfigNode* find(std::string_view key) const;
};

/// `quantity` of a step must lie in [min, max]; a missing or non-finite one fails.
struct ExperimentCheck {
    std::string step;
    std::string quantity; ///< without the step
    std::optional<double> min;
    std::optional<double> max;
    std::string reason;
};

/// A whole experiment file (resources/help/command-line.md, "Experiment file").
struct Experiment {
    std::string title;
    std::string description;
    std::string device;
    std::vector<ExperimentStep> steps;
    std::vector<ExperimentCheck> checks;
};

/// Reads and judges a file's text with the `--set` assignments applied, before any device is touched.
/// Errors: InvalidInput with origin, line, column and the allowed values; Usage or UnknownName for a wrong
/// assignment.
Result<Experiment> parseExperiment(const std::string& text, const std::string& origin,
                                   const std::vector<std::string>& assignments);

} // namespace halbench::app
