#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/relay/relay_procedure.h"

#include <string>

namespace halbench::app {

/// halbench.relay/1
JsonValue relayDocument(ResultHeader header, const RelayResult& result);
/// The same without the header, for the steps of a run.
JsonValue relayBody(const RelayResult& result);

/// RELAY.json, as far as tuning needs it.
struct RelayFile {
    ResultHeader header;
    double ultimateGain_A_per_rad = 0.0;
    double ultimatePeriod_s = 0.0;
    control::LoopTiming timing;       ///< of the loop that swung
    std::vector<Finding> doubts = {}; ///< of the experiment (doubtsOfRelay)
};

/// Errors: FileSystem; InvalidInput with the place; Refused for a result that was refused.
Result<RelayFile> readRelayFile(const std::string& path);
/// The same from text; `origin` names it in messages.
Result<RelayFile> parseRelay(const std::string& text, const std::string& origin);

} // namespace halbench::app
