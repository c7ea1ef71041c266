#include "app/headless/recording_integrity.h"

#include "app/headless/console.h"
#include "devices/formats/recording_units.h"

#include <algorithm>

namespace halbench::app {

namespace {

Finding findingOf(const std::string& warning) {
    if (devices::isFirmwareWarning(warning)) {
        return {"other_firmware", warning, devices::OtherFirmwareHint};
    }
    return devices::isUnitWarning(warning)
               ? Finding{"unit_assumed", warning, "add the unit to the column name: position_rad"}
               : Finding{RecordingIntegrityCode, warning,
                         "compare it with a copy; rows may be missing or changed"};
}

} // namespace

void sayWarnings(const CommandContext& context, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {
        context.console.log(LogLevel::Warning, warning);
    }
}

void noteWarnings(DataQuality& quality, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {
        quality.verdict = std::max(quality.verdict, Verdict::Doubtful);
        quality.findings.push_back(findingOf(warning));
    }
}

void addQuality(DataQuality& known, const DataQuality& result) {
    known.verdict = std::max(known.verdict, result.verdict);
    known.findings.insert(known.findings.end(), result.findings.begin(), result.findings.end());
}

} // namespace halbench::app
