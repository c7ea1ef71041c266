#include "app/documents/text/names.h"
#include "app/experiments/run_outcome.h"
#include "control/base/units.h"

#include <array>
#include <cmath>

namespace halbench::app {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> Symbols = {
    std::pair("parameters.J.", "parameters.inertia."),
    std::pair("parameters.c.", "parameters.viscous_damping."),
    std::pair("parameters.Kf.", "parameters.coulomb_friction."),
    std::pair("parameters.phi.", "parameters.torque_constant.")};

std::string longPath(std::string path) {
    for (const auto& [shortForm, longForm] : Symbols) {
        if (path.rfind(shortForm, 0) == 0) {
            path.replace(0, shortForm.size(), longForm);
        }
    }
    for (const auto& [end, item] : {std::pair(".ci95_lo", ".ci95.0"), std::pair(".ci95_hi", ".ci95.1")}) {
        const std::string suffix = end;
        if (path.size() > suffix.size() &&
            path.compare(path.size() - suffix.size(), suffix.size(), suffix) == 0) {
            path.replace(path.size() - suffix.size(), suffix.size(), item);
        }
    }
    return path;
}

const JsonValue* findItem(const JsonValue& list, const std::string& path);

const JsonValue* findNode(const JsonValue& node, const std::string& path) {
    if (path.empty()) {
        return &node;
    }
    if (node.isArray()) {
        return findItem(node, path);
    }
    if (!node.isObject()) {
        return nullptr;
    }
    for (const JsonMember& member : node.members()) {
        if (path == member.key) {
            return &member.value;
        }
        if (path.rfind(member.key + ".", 0) == 0) {
            if (const JsonValue* found = findNode(member.value, path.substr(member.key.size() + 1))) {
                return found;
            }
        }
    }
    return nullptr;
}

const JsonValue* findItem(const JsonValue& list, const std::string& path) {
    const std::size_t dot = path.find('.');
    const std::string first = path.substr(0, dot);
    if (first.empty() || first.size() > 6 || first.find_first_not_of("0123456789") != std::string::npos) {
        return nullptr;
    }
    const std::size_t index = std::stoul(first);
    if (index >= list.items().size()) {
        return nullptr;
    }
    return findNode(list.items()[index], dot == std::string::npos ? "" : path.substr(dot + 1));
}

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string lowerCase(std::string text) {
    for (char& letter : text) {
        letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    }
    return text;
}

} // namespace

const Recording* StepOutcome::recording() const {
    const Recording* recording = nullptr;
    if (const auto* identified = std::get_if<IdentifyResult>(&detail)) {
        recording = &identified->recording;
    } else if (const auto* axes = std::get_if<AxesIdentifyResult>(&detail)) {
        recording = &axes->recording;
    } else if (const auto* response = std::get_if<FrequencyResult>(&detail)) {
        recording = &response->recording;
    } else if (const auto* matrix = std::get_if<AxesFrequencyResult>(&detail)) {
        recording = &matrix->recording;
    } else if (const auto* relay = std::get_if<RelayResult>(&detail)) {
        recording = &relay->recording;
    } else if (const auto* moved = std::get_if<MoveOutcome>(&detail)) {
        recording = &moved->result.recording;
    } else if (const auto* recorded = std::get_if<RecordResult>(&detail)) {
        recording = &recorded->recording;
    } else if (const auto* applied = std::get_if<ApplyResult>(&detail); applied && applied->verification) {
        recording = &applied->verification->recording;
    }
    return recording != nullptr && recording->rows() > 0 ? recording : nullptr;
}

std::optional<double> findQuantity(const JsonValue& body, const std::string& path) {
    const JsonValue* node = findNode(body, longPath(path));
    if (node != nullptr && node->isBoolean()) {
        return node->boolean() ? 1.0 : 0.0;
    }
    if (node == nullptr || !node->isNumber() || !std::isfinite(node->number())) {
        return std::nullopt;
    }
    return node->number();
}

std::string quantityUnit(const JsonValue& body, const std::string& path) {
    const std::string full = longPath(path);
    for (const char* end : {".value", ".ci95.0", ".ci95.1"}) {
        if (endsWith(full, end)) {
            const JsonValue* unit =
                findNode(body, full.substr(0, full.size() - std::string(end).size()) + ".unit");
            return unit != nullptr && unit->isText() ? unit->text() : std::string();
        }
    }
    std::string best;
    std::string symbol;
    for (const Unit& unit : units()) {
        // Keys in results are lower case (cutoff_hz); a single letter would match too much that way.
        const std::string suffix(unit.suffix);
        const bool isEnd =
            endsWith(full, "_" + suffix) || (suffix.size() > 1 && endsWith(full, "_" + lowerCase(suffix)));
        if (suffix.size() > best.size() && isEnd) {
            best = suffix;
            symbol = unit.symbol;
        }
    }
    return symbol;
}

std::vector<CheckOutcome> judgeChecks(const std::vector<ExperimentCheck>& checks,
                                      const std::vector<StepOutcome>& steps) {
    std::vector<CheckOutcome> outcomes;
    for (const ExperimentCheck& check : checks) {
        CheckOutcome outcome;
        outcome.quantity = check.step + "." + check.quantity;
        outcome.min = check.min;
        outcome.max = check.max;
        outcome.reason = check.reason;
        for (const StepOutcome& step : steps) {
            if (step.name == check.step) {
                outcome.value = findQuantity(step.body, check.quantity);
                outcome.unit = quantityUnit(step.body, check.quantity);
            }
        }
        outcome.passed = outcome.value && (!check.min || *outcome.value >= *check.min) &&
                         (!check.max || *outcome.value <= *check.max);
        outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

} // namespace halbench::app
