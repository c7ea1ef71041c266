#include "app/procedures/base/row_loss.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

/// Of the packets that were missing, so that their order is the cause and not a loss.
constexpr double MostOfThem_ratio = 0.5;

/// A device that was lost and came back counts anew.
double counted(std::uint64_t before, std::uint64_t after) {
    return static_cast<double>(after >= before ? after - before : after);
}

} // namespace

RowLossCause causeOfRowLoss(const devices::LinkStatistics& before, const devices::LinkStatistics& after) {
    const double received = counted(before.packetsReceived, after.packetsReceived);
    const double lost = counted(before.packetsLost, after.packetsLost);
    const double damaged = counted(before.packetsDamaged, after.packetsDamaged);
    if (after.returns > before.returns) { // the rows of the outage are most of those that are missing
        return {after.returns - before.returns == 1
                    ? "the connection was lost once and came back"
                    : fmt::format("the connection was lost {} times and came back",
                                  after.returns - before.returns),
                "check the cable, the plug and the power of the device"};
    }
    if (damaged > 0.0) { // what is damaged is missing in the counter too
        return {fmt::format("{:.2g} % of the frames were damaged on the line",
                            1e2 * damaged / (received + damaged)),
                "shorten or shield the cable, or lower the baud rate"};
    }
    const double late = counted(before.packetsLate, after.packetsLate);
    if (late > 0.0 && late >= MostOfThem_ratio * lost) {
        return {fmt::format("{:.2g} % of the packets arrived out of order", 1e2 * late / (received + lost)),
                "connect by tcp: instead of udp:; tcp keeps the order"};
    }
    if (lost > 0.0) {
        return {fmt::format("{:.2g} % of the packets were lost, none was damaged",
                            1e2 * lost / (received + lost)),
                "use fewer signals or a lower rate; with udp:, connect by tcp: instead"};
    }
    if (received > 0.0) {
        return {"no packet was lost or damaged: the device skipped or delayed rows", ""};
    }
    return {};
}

Error withCause(Error error, const RowLossCause& cause) {
    error.message += cause.words.empty() ? "" : ": " + cause.words;
    error.hint = cause.remedy.empty() ? error.hint : cause.remedy;
    return error;
}

void nameRowLoss(DataQuality& quality, const RowLossCause& cause) {
    for (Finding& finding : quality.findings) {
        if (finding.code == "rows_lost" && !cause.words.empty()) {
            finding.message += ": " + cause.words;
            finding.hint = cause.remedy.empty() ? finding.hint : cause.remedy;
        }
    }
}

} // namespace halbench::app
