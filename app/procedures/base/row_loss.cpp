#include "app/procedures/base/row_loss.h"

#include <fmt/format.h>

namespace halbench::app {

RowLossCause causeOfRowLoss(const devices::LinkStatistics& before, const devices::LinkStatistics& after) {
    const auto received = static_cast<double>(after.packetsReceived - before.packetsReceived);
    const auto lost = static_cast<double>(after.packetsLost - before.packetsLost);
    const auto damaged = static_cast<double>(after.packetsDamaged - before.packetsDamaged);
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

void nameRowLoss(DataQuality& quality, const RowLossCause& cause) {
    for (Finding& finding : quality.findings) {
        if (finding.code == "rows_lost" && !cause.words.empty()) {
            finding.message += ": " + cause.words;
            finding.hint = cause.remedy;
        }
    }
}

} // namespace halbench::app
