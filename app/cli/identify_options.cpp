#include "app/cli/identify_options.h"

#include "app/documents/model_file.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/procedure_choices.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

Result<CurrentSweep> sweepFrom(const std::string& text) {
    CurrentSweep sweep;
    if (text.empty()) {
        return sweep;
    }
    const std::vector<std::string> parts = splitList(text, ':');
    if (parts.size() != 3) {
        return failure(ErrorCode::Usage, "--currents: '" + text + "' is not FROM:TO:STEP",
                       "write it like 1.6:4:0.2");
    }
    std::vector<double> numbers;
    for (const std::string& part : parts) {
        const Result<double> number = numberOption("--currents", part);
        if (!number) {
            return failure(number.error());
        }
        numbers.push_back(*number);
    }
    return CurrentSweep{numbers[0], numbers[1], numbers[2]};
}

Result<void> takeGiven(const std::vector<std::string>& texts, const Actuator& actuator,
                       IdentifyConfig& config) {
    std::vector<std::string> seen;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos) {
            return failure(ErrorCode::Usage, "--given: '" + text + "' is not NAME=VALUE", "write J=5.5e-4");
        }
        const std::string symbol = text.substr(0, equals);
        if (std::find(seen.begin(), seen.end(), symbol) != seen.end()) {
            return failure(ErrorCode::Usage, "--given: '" + symbol + "' is given twice", "give it once");
        }
        seen.push_back(symbol);
        const Result<double> value = numberOption("--given " + text, text.substr(equals + 1));
        if (!value) {
            return failure(value.error());
        }
        if (const Result<void> set = actuator.identify.setGiven(config, symbol, *value); !set) {
            return set;
        }
    }
    return {};
}

Result<void> takeCurrentTolerance(const std::string& text, IdentifyConfig& config) {
    if (text.empty()) {
        return {};
    }
    const Result<double> number = numberOption("--current-tolerance-percent", text);
    return number ? setCurrentTolerance(config, *number) : failure(number.error());
}

Result<std::optional<AddedInertia>> addedFrom(const SweepOptions& options) {
    if (options.bare.empty() && options.addedInertia.empty()) {
        return std::optional<AddedInertia>{};
    }
    if (options.bare.empty() || options.addedInertia.empty()) {
        return failure(ErrorCode::Usage, "--bare and --added-inertia belong together",
                       "give the result of the bare motor and the inertia added since");
    }
    const Result<double> inertia = numberOption("--added-inertia", options.addedInertia);
    if (!inertia) {
        return failure(inertia.error());
    }
    Result<ModelFile> bare = readModelFile(options.bare);
    if (!bare) {
        return failure(bare.error());
    }
    return std::optional<AddedInertia>(AddedInertia{std::move(bare->estimate), *inertia});
}

} // namespace

Result<IdentifyConfig> identifyConfigFrom(const SweepOptions& options, const std::string& axis,
                                          const Actuator& actuator) {
    const Result<CurrentSweep> sweep = sweepFrom(options.currents);
    if (!sweep) {
        return failure(sweep.error());
    }
    const Result<SweepDirections> directions = sweepDirections(options.directions);
    if (!directions) {
        return failure(directions.error());
    }
    IdentifyConfig config;
    if (const Result<void> given = takeGiven(options.given, actuator, config); !given) {
        return failure(given.error());
    }
    if (const Result<void> taken = takeCurrentTolerance(options.currentTolerance, config); !taken) {
        return failure(taken.error());
    }
    Result<std::optional<AddedInertia>> added = addedFrom(options);
    if (!added) {
        return failure(added.error());
    }
    config.sweep = *sweep;
    config.directions = *directions;
    config.axis = axis;
    config.added = *std::move(added);
    return config;
}

} // namespace halbench::app
