#include "app/documents/filtered_gains.h"

#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"
#include "app/documents/text/output_file.h"
#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halbench::app {

namespace {

constexpr std::array ShapingKeys = {"filter_s", "setpoint_weights", "filters"};

tl::unexpected<Error> wrong(const std::string& origin, const std::string& key, const std::string& what) {
    return failure(ErrorCode::InvalidInput, fmt::format("{}: \"{}\" {}", origin, key, what),
                   "see the help of the command line, \"Results\", halbench.gains");
}

/// The members of an object: all known, all finite numbers but for `kind`.
Result<void> checkMembers(const JsonValue& object, const std::vector<std::string>& known,
                          const std::string& origin, const std::string& key) {
    if (!object.isObject()) {
        return wrong(origin, key, "must be an object");
    }
    for (const JsonMember& entry : object.members()) {
        const std::string path = key + "." + entry.key;
        if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
            return wrong(origin, path, "is not known");
        }
        if (!entry.value.isNumber()) {
            return wrong(origin, path, "must be a finite number");
        }
    }
    return {};
}

struct FilterKind {
    const char* name;
    std::vector<std::string> figures;
    control::LoopFilter (*make)(const std::vector<double>&);
};

const std::vector<FilterKind>& filterKinds() {
    using Figures = std::vector<double>;
    static const std::vector<FilterKind> kinds = {
        {"lead",
         {"frequency_rad_s", "phase_deg"},
         [](const Figures& f) -> control::LoopFilter {
             return control::LeadFilter{f[0], f[1]};
         }},
        {"lag",
         {"frequency_rad_s", "ratio"},
         [](const Figures& f) -> control::LoopFilter {
             return control::LagFilter{f[0], f[1]};
         }},
        {"notch",
         {"frequency_rad_s", "depth_ratio", "damping_ratio"},
         [](const Figures& f) -> control::LoopFilter {
             return control::NotchFilter{f[0], f[1], f[2]};
         }},
        {"low-pass",
         {"corner_rad_s", "order"},
         [](const Figures& f) -> control::LoopFilter {
             const bool isWhole = f[1] == 1.0 || f[1] == 2.0; // any other order is refused as order 0
             return control::LowPassFilter{f[0], isWhole ? static_cast<int>(f[1]) : 0};
         }},
        {"section",
         {"b0", "b1", "b2", "a1", "a2"},
         [](const Figures& f) -> control::LoopFilter {
             return control::SectionFilter{{f[0], f[1], f[2], f[3], f[4]}};
         }},
    };
    return kinds;
}

std::string figureWords(const control::LoopFilter& filter) {
    const FilterKind& kind = filterKinds()[filter.index()];
    const std::vector<double> figures = figuresOf(filter);
    std::string line;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        line += fmt::format("{}{} {:.4g}", i == 0 ? "" : ", ", kind.figures[i], figures[i]);
    }
    return line;
}

Result<control::LoopFilter> readFilter(const JsonValue& entry, const std::string& origin,
                                       const std::string& key) {
    const std::string name = textIn(&entry, "kind");
    for (const FilterKind& kind : filterKinds()) {
        if (name != kind.name) {
            continue;
        }
        JsonValue numbers = JsonValue::object();
        for (const JsonMember& figure : entry.members()) {
            if (figure.key != "kind") {
                numbers.set(figure.key, figure.value);
            }
        }
        if (const auto valid = checkMembers(numbers, kind.figures, origin, key); !valid) {
            return failure(valid.error());
        }
        std::vector<double> figures;
        for (const std::string& figure : kind.figures) {
            const auto value = numberIn(&entry, figure.c_str());
            if (!value) {
                return wrong(origin, key + "." + figure, "is missing");
            }
            figures.push_back(*value);
        }
        return kind.make(figures);
    }
    return wrong(origin, key + ".kind", "must be \"lead\", \"lag\", \"notch\", \"low-pass\" or \"section\"");
}

Result<void> readFilters(control::FilteredLaw& law, const JsonValue* list, const std::string& origin) {
    if (list == nullptr || list->isNull()) {
        return {};
    }
    if (!list->isArray()) {
        return wrong(origin, "gains.filters", "must be a list");
    }
    for (std::size_t i = 0; i < list->items().size(); ++i) {
        const auto filter = readFilter(list->items()[i], origin, fmt::format("gains.filters[{}]", i));
        if (!filter) {
            return failure(filter.error());
        }
        law.filters.push_back(*filter);
    }
    return {};
}

Result<void> readWeights(control::FilteredLaw& law, const JsonValue* weights, const std::string& origin) {
    if (weights == nullptr || weights->isNull()) {
        return {};
    }
    if (const auto valid = checkMembers(*weights, {"b", "c"}, origin, "gains.setpoint_weights"); !valid) {
        return valid;
    }
    law.proportionalWeight = numberIn(weights, "b").value_or(law.proportionalWeight);
    law.derivativeWeight = numberIn(weights, "c").value_or(law.derivativeWeight);
    return {};
}

/// In the form that the file is written in, which parseGains has judged.
control::PidGains gainsAsWritten(const JsonValue& root, const JsonValue& gains) {
    control::PidGains written;
    const std::string form = textIn(&root, "form");
    written.form = form == control::pidFormName(control::PidForm::Standard) ? control::PidForm::Standard
                   : form == control::pidFormName(control::PidForm::Series) ? control::PidForm::Series
                                                                            : control::PidForm::Parallel;
    const bool isParallel = written.form == control::PidForm::Parallel;
    const auto value = [&gains](const char* key) { return numberIn(gains.find(key), "value"); };
    written.proportional = value(isParallel ? "kp" : "k").value_or(0.0);
    written.integral = isParallel ? value("ki").value_or(0.0)
                                  : value("ti").value_or(std::numeric_limits<double>::infinity());
    written.derivative = value(isParallel ? "kd" : "td").value_or(0.0);
    return written;
}

Result<control::FilteredLaw> readShaping(const JsonValue& root, const std::string& origin) {
    const JsonValue& gains = *root.find("gains");
    control::FilteredLaw law;
    law.gains = gainsAsWritten(root, gains);
    if (const JsonValue* filter = gains.find("filter_s"); filter != nullptr && !filter->isNull()) {
        law.gains.filter_s = numberIn(filter, "value");
        if (!law.gains.filter_s) {
            return wrong(origin, "gains.filter_s.value", "must be a finite number");
        }
    }
    const auto weights = readWeights(law, gains.find("setpoint_weights"), origin);
    const auto filters = weights ? readFilters(law, gains.find("filters"), origin) : weights;
    return filters ? Result<control::FilteredLaw>(law) : failure(filters.error());
}

/// The same document without what the board's law has not.
JsonValue withoutShaping(JsonValue root) {
    JsonValue gains = *root.find("gains");
    for (const char* key : ShapingKeys) {
        gains.set(key, JsonValue());
    }
    return root.set("gains", gains);
}

} // namespace

Result<GainsFile> parseFilteredGains(const std::string& text, const std::string& origin) {
    if (const Result<void> single = refuseAxes(text, origin); !single) {
        return failure(single.error());
    }
    const Result<JsonValue> root = parseDocument(text, origin);
    if (!root) {
        return failure(root.error());
    }
    const JsonValue* gains = root->find("gains");
    if (gains == nullptr || !gains->isObject()) {
        return wrong(origin, "gains", "is missing");
    }
    const auto plain = toJsonText(withoutShaping(*root));
    auto board = plain ? parseGains(*plain, origin) : failure(plain.error());
    if (!board) {
        return failure(board.error());
    }
    auto filtered = readShaping(*root, origin);
    if (!filtered) {
        return failure(filtered.error());
    }
    const auto checked = control::checkedGains(*filtered, board->timing.period_s);
    if (!checked) {
        return failure(checked.error().code, fmt::format("{}: gains: {}", origin, checked.error().message),
                       checked.error().hint);
    }
    filtered->gains = *checked;
    board->law.gains = *checked; // a filter counts in the series form
    board->law.gains.filter_s.reset();
    if (!control::isBoardLaw(*filtered)) {
        board->filtered = *std::move(filtered);
    }
    return board;
}

Result<GainsFile> readFilteredGains(const std::string& path) {
    const Result<std::string> text = readFile(path);
    return text ? parseFilteredGains(*text, path) : failure(text.error());
}

void setShaping(JsonValue& document, const control::FilteredLaw& filtered) {
    JsonValue weights = JsonValue::object();
    weights.set("b", filtered.proportionalWeight).set("c", filtered.derivativeWeight);
    JsonValue filters = JsonValue::array();
    for (const control::LoopFilter& filter : filtered.filters) {
        const FilterKind& kind = filterKinds()[filter.index()];
        const std::vector<double> figures = figuresOf(filter);
        JsonValue entry = JsonValue::object();
        entry.set("kind", kind.name);
        for (std::size_t i = 0; i < figures.size(); ++i) {
            entry.set(kind.figures[i], figures[i]);
        }
        filters.push(entry);
    }
    JsonValue gains = *document.find("gains");
    if (filtered.gains.filter_s) {
        JsonValue filter = JsonValue::object();
        gains.set("filter_s", filter.set("value", *filtered.gains.filter_s).set("unit", "s"));
    }
    document.set("gains", gains.set("setpoint_weights", weights).set("filters", filters));
}

std::vector<double> figuresOf(const control::LoopFilter& filter) {
    struct Kinds {
        std::vector<double> operator()(const control::LeadFilter& f) const {
            return {f.frequency_rad_s, f.phase_deg};
        }
        std::vector<double> operator()(const control::LagFilter& f) const {
            return {f.frequency_rad_s, f.ratio};
        }
        std::vector<double> operator()(const control::NotchFilter& f) const {
            return {f.frequency_rad_s, f.depth_ratio, f.damping_ratio};
        }
        std::vector<double> operator()(const control::LowPassFilter& f) const {
            return {f.corner_rad_s, static_cast<double>(f.order)};
        }
        std::vector<double> operator()(const control::SectionFilter& f) const {
            return {f.section.b0, f.section.b1, f.section.b2, f.section.a1, f.section.a2};
        }
    };
    return std::visit(Kinds{}, filter);
}

control::LoopFilter filterOf(std::size_t kind, const std::vector<double>& figures) {
    HB_ASSERT(kind < filterKinds().size() && figures.size() == filterKinds()[kind].figures.size());
    return filterKinds()[kind].make(figures);
}

std::string filterWords(const control::LoopFilter& filter) {
    const FilterKind& kind = filterKinds()[filter.index()];
    return fmt::format("{}: {}", kind.name, figureWords(filter));
}

std::string shapingLines(const control::FilteredLaw& filtered) {
    std::string text = fmt::format("{:<26} b {:.4g}, c {:.4g}\n", "set-point weights",
                                   filtered.proportionalWeight, filtered.derivativeWeight);
    if (filtered.gains.filter_s.value_or(0.0) > 0.0) {
        text += fmt::format("{:<26} {:.4g} s\n", "derivative filter", *filtered.gains.filter_s);
    }
    for (const control::LoopFilter& filter : filtered.filters) {
        text += fmt::format("{:<26} {}\n", filterKinds()[filter.index()].name, figureWords(filter));
    }
    return text;
}

} // namespace halbench::app
