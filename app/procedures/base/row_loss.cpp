#include "app/procedures/base/row_loss.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

/// A device that was lost and came back counts anew.
double counted(std::uint64_t before, std::uint64_t after) {
    return static_cast<double>(after >= before ? after - before : after);
}

} // namespace

RowLossCause causeOfRowLoss(const devices::LinkStatistics& before, const devices::LinkStatistics& after) {
    const double received = counted(before.packetsReceived, after.packetsReceived);
    const double lost = counted(before.packetsLost, after.packetsLost);
    const double damaged = counted(before.packetsDamaged, after.packetsDamaged);
    if (damaged > 0.0) { // what is damaged is missing in the counter too
        return {fmt::format("the line damaged {:.2g} % of the frames", 1e2 * damaged / (received + damaged)),
                "shorten or shield the cable, or lower the baud rate"};
    }
    if (lost > 0.0) {
        return {fmt::format("{:.2g} % of the packets were lost and none was damaged: a queue was full",
                            1e2 * lost / (received + lost)),
                "record fewer signals or at a lower rate, or connect by tcp: instead of udp:"};
    }
    if (received > 0.0) {
        return {"no packet was lost or damaged: the board left rows out or sent them late", ""};
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
            finding.hint = cause.remedy;
        }
    }
}

} // namespace halbench::app
