#include "devices/xcp/sampling_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

namespace {

constexpr double RelativeRounding = 1e-9;
constexpr double MaxDivider = 1e6;
constexpr std::uint32_t MaxPrescaler = 255;

/// event rate / wanted rate as a whole number >= 1.
std::optional<std::uint32_t> dividerFor(double event_Hz, double wanted_Hz) {
    const double ratio = event_Hz / wanted_Hz;
    const double whole = std::round(ratio);
    if (whole < 1.0 || whole > MaxDivider || std::abs(ratio - whole) > RelativeRounding * whole) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(whole);
}

std::uint32_t largestPrescaler(std::uint32_t divider, bool hasPrescaler) {
    for (std::uint32_t prescaler = std::min(divider, MaxPrescaler); hasPrescaler && prescaler > 1;
         --prescaler) {
        if (divider % prescaler == 0) {
            return prescaler;
        }
    }
    return 1;
}

/// The rates next to the wanted one that some event divides down to.
std::string nearestRates(const std::map<std::uint16_t, double>& rates, double wanted_Hz) {
    double below = 0.0;
    double above = 0.0;
    for (const auto& [event, rate_Hz] : rates) {
        if (rate_Hz <= 0.0 || !(wanted_Hz > 0.0)) {
            continue;
        }
        const double divider = std::min(rate_Hz / wanted_Hz, MaxDivider);
        const double lower = rate_Hz / std::max(1.0, std::ceil(divider - RelativeRounding));
        const double upper = rate_Hz / std::max(1.0, std::floor(divider + RelativeRounding));
        below = lower <= wanted_Hz ? std::max(below, lower) : below;
        above = upper >= wanted_Hz && (above == 0.0 || upper < above) ? upper : above;
    }
    if (below > 0.0 && above > 0.0) {
        return fmt::format("the nearest possible rates: {} Hz and {} Hz", below, above);
    }
    const double only = std::max(below, above);
    return only > 0.0 ? fmt::format("the nearest possible rate: {} Hz", only)
                      : "these signals have no periodic event";
}

/// Events that carry both.
std::map<std::uint16_t, double> intersection(const std::map<std::uint16_t, double>& one,
                                             const std::map<std::uint16_t, double>& other) {
    std::map<std::uint16_t, double> common;
    for (const auto& entry : one) {
        if (other.count(entry.first) != 0) {
            common.insert(entry);
        }
    }
    return common;
}

std::string ratesText(const std::map<std::uint16_t, double>& rates_Hz) {
    std::vector<std::string> texts;
    for (const auto& [event, rate_Hz] : rates_Hz) {
        texts.push_back(rate_Hz > 0.0 ? fmt::format("{} Hz", rate_Hz) : "irregularly");
    }
    return texts.empty() ? "never" : fmt::format("{}", fmt::join(texts, " or "));
}

/// A row of a stream is one consistent sample of one event (3.8): values of two events are of two cycles, and
/// a row that mixed them would show a moment that never was. Boards of ours offer every signal at every
/// event.
tl::unexpected<Error> noCommonEvent(const StreamRequest& request, const std::string& name,
                                    const std::map<std::uint16_t, double>& own,
                                    const std::map<std::uint16_t, double>& others) {
    return failure(ErrorCode::OutOfRange,
                   fmt::format("the device samples '{}' ({}) at another event than '{}' ({})", name,
                               ratesText(own), request.signals.front(), ratesText(others)),
                   "stream only signals of the same event together");
}

Result<std::map<std::uint16_t, double>> addSignals(const BoardDescription& board,
                                                   const StreamRequest& request, SamplingPlan& plan,
                                                   StreamLayout& layout) {
    std::map<std::uint16_t, double> common;
    for (const std::string& name : request.signals) {
        const A2lMeasurement* signal = board.measurement(name);
        if (signal == nullptr || signal->count != 1) {
            return failure(ErrorCode::UnknownName, fmt::format("the device has no signal '{}'", name),
                           "list the signals with: halbench describe DEVICE");
        }
        const std::map<std::uint16_t, double> rates = board.eventRates(*signal);
        const auto shared = plan.entries.empty() ? rates : intersection(common, rates);
        if (shared.empty() && !rates.empty() && !common.empty()) {
            return noCommonEvent(request, name, rates, common);
        }
        common = shared;
        plan.entries.push_back({signal->address, signal->type, signal->bitMask, signal->conversion.factor,
                                signal->conversion.offset});
        layout.columns.push_back({name, signal->conversion.unit});
    }
    return common;
}

} // namespace

Result<SamplingPlan> planSampling(const BoardDescription& board, const DaqAbility& ability,
                                  const StreamRequest& request) {
    if (request.signals.empty()) {
        return failure(ErrorCode::Usage, "a stream needs at least one signal", "name a signal");
    }
    SamplingPlan plan;
    StreamLayout layout;
    const auto rates = addSignals(board, request, plan, layout);
    if (!rates) {
        return failure(rates.error());
    }
    double best_Hz = 0.0;
    for (const auto& [event, rate_Hz] : *rates) {
        const bool isFinite = std::isfinite(request.rate_Hz) && request.rate_Hz > 0.0 && rate_Hz > 0.0;
        const std::optional<std::uint32_t> divider =
            isFinite ? dividerFor(rate_Hz, request.rate_Hz) : std::nullopt;
        if (!divider || (best_Hz != 0.0 && rate_Hz >= best_Hz)) {
            continue;
        }
        best_Hz = rate_Hz;
        plan.event = event;
        plan.prescaler = static_cast<std::uint8_t>(largestPrescaler(*divider, ability.hasPrescaler));
        plan.hostDivider = *divider / plan.prescaler;
        plan.boardPeriod_s = plan.prescaler / rate_Hz;
    }
    if (best_Hz == 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("the device cannot send these signals at {} Hz", request.rate_Hz),
                       nearestRates(*rates, request.rate_Hz));
    }
    layout.period_s = plan.boardPeriod_s * plan.hostDivider;
    plan.layout = std::make_shared<const StreamLayout>(std::move(layout));
    return plan;
}

} // namespace halbench::devices::xcp
