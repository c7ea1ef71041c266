// Interrupted recordings: the text of one, a zero, and the journal of its checksums. What comes back has
// times that increase, and what was left out was there.
#include "devices/recording/recording_salvage.h"

#include <cmath>

using namespace halbench;
using namespace halbench::devices;

namespace {

RecordingMeta metaOf(bool hasSignals) {
    RecordingMeta meta;
    if (hasSignals) {
        meta.signals.resize(1);
        meta.signals[0].name = "position";
        meta.signals[0].unit = "rad";
        meta.signals[0].column = "position_rad";
    }
    return meta;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    const std::size_t zero = all.find('\0');
    const std::string_view text = all.substr(0, zero);
    const std::string_view journal =
        zero == std::string_view::npos ? std::string_view() : all.substr(zero + 1);
    for (const bool hasSignals : {false, true}) {
        const RecordingMeta meta = metaOf(hasSignals);
        const auto salvaged = salvageRows(text, journal, meta, "fuzz.csv.partial");
        if (!salvaged) {
            continue;
        }
        const std::vector<double>& time_s = salvaged->recording.time_s;
        for (std::size_t row = 0; row < time_s.size(); ++row) {
            if (!std::isfinite(time_s[row]) || (row > 0 && !(time_s[row] > time_s[row - 1]))) {
                __builtin_trap();
            }
        }
        if (salvaged->cutOctets + salvaged->damagedOctets > text.size() ||
            salvaged->uncheckedRows > time_s.size() || (!time_s.empty() && !holdsRows(text, meta))) {
            __builtin_trap();
        }
    }
    return 0;
}
