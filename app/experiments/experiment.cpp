#include "app/experiments/experiment.h"

#include "app/documents/text/names.h"
#include "app/experiments/experiment_validation.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

void flatten(const ConfigNode& table, const std::string& prefix,
             std::vector<std::pair<std::string, double>>& values) {
    for (const ConfigNode::Member& member : table.members) {
        const std::string name = prefix.empty() ? member.first : prefix + "." + member.first;
        if (member.second.kind == ConfigNode::Kind::Table) {
            flatten(member.second, name, values);
        } else {
            values.emplace_back(name, member.second.number);
        }
    }
}

ExperimentCheck checkFrom(const ConfigNode& node) {
    ExperimentCheck check;
    const std::string quantity = node.find("quantity")->text;
    const std::size_t dot = quantity.find('.');
    check.step = quantity.substr(0, dot);
    check.quantity = quantity.substr(dot + 1);
    if (const ConfigNode* min = node.find("min")) {
        check.min = min->number;
    }
    if (const ConfigNode* max = node.find("max")) {
        check.max = max->number;
    }
    if (const ConfigNode* reason = node.find("reason")) {
        check.reason = reason->text;
    }
    return check;
}

std::string textOr(const ConfigNode& root, std::string_view key) {
    const ConfigNode* node = root.find(key);
    return node == nullptr ? std::string() : node->text;
}

} // namespace

const ConfigNode* ExperimentStep::find(std::string_view key) const {
    const ConfigNode* node = &keys;
    for (const std::string& part : splitList(key, '.')) {
        node = node == nullptr ? nullptr : node->find(part);
    }
    return node;
}

std::optional<double> ExperimentStep::number(std::string_view key) const {
    const ConfigNode* node = find(key);
    return node == nullptr ? std::nullopt : std::optional<double>(node->number);
}

std::optional<std::string> ExperimentStep::text(std::string_view key) const {
    const ConfigNode* node = find(key);
    return node == nullptr ? std::nullopt : std::optional<std::string>(node->text);
}

bool ExperimentStep::isTrue(std::string_view key) const {
    const ConfigNode* node = find(key);
    return node != nullptr && node->boolean;
}

std::vector<std::string> ExperimentStep::texts(std::string_view key) const {
    std::vector<std::string> result;
    if (const ConfigNode* node = find(key)) {
        for (const ConfigNode& item : node->items) {
            result.push_back(item.text);
        }
    }
    return result;
}

std::vector<std::pair<std::string, double>> ExperimentStep::numbers(std::string_view key) const {
    std::vector<std::pair<std::string, double>> values;
    if (const ConfigNode* node = find(key)) {
        flatten(*node, "", values);
    }
    return values;
}

Result<Experiment> parseExperiment(const std::string& text, const std::string& origin,
                                   const std::vector<std::string>& assignments) {
    Result<ConfigNode> root = parseToml(text, origin);
    if (!root) {
        return failure(root.error());
    }
    for (const std::string& assignment : assignments) {
        if (const Result<void> assigned = assignPath(*root, assignment); !assigned) {
            return failure(assigned.error());
        }
    }
    if (const Result<void> valid = validateExperiment(*root); !valid) {
        return failure(valid.error());
    }
    Experiment experiment{
        textOr(*root, "title"), textOr(*root, "description"), textOr(*root, "device"), {}, {}};
    for (const ConfigNode& step : root->find("step")->items) {
        experiment.steps.push_back({step.find("kind")->text, step.find("name")->text, step});
    }
    if (const ConfigNode* checks = root->find("check")) {
        for (const ConfigNode& check : checks->items) {
            experiment.checks.push_back(checkFrom(check));
        }
    }
    return experiment;
}

} // namespace halbench::app
