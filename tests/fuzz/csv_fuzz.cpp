// Recordings: any text. What was read must come back the same after writing.
#include "devices/recording/recording_csv.h"

#include <cmath>

using namespace halbench;
using namespace halbench::devices;

namespace {

/// Numbers with a fraction that are 4-octet floats are written in that precision.
bool isSame(double read, double written) {
    if (std::isnan(written)) {
        return std::isnan(read);
    }
    return read == written || static_cast<float>(read) == static_cast<float>(written);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto recording = parseRecordingCsv({reinterpret_cast<const char*>(data), size}, "fuzz.csv");
    if (!recording) {
        if (recording.error().message.empty()) {
            __builtin_trap();
        }
        return 0;
    }
    std::string text = csvHeader(*recording->layout);
    appendCsvRows(text, {recording->layout, recording->time_s, recording->values, 0.0, 0});
    const auto again = parseRecordingCsv(text, "again.csv");
    if (!again) {
        return 0; // times that differ by less than a float's precision, or column names that collide
    }
    if (again->rows() != recording->rows()) {
        __builtin_trap();
    }
    for (std::size_t i = 0; i < recording->values.size(); ++i) {
        if (!isSame(again->values[i], recording->values[i])) {
            __builtin_trap();
        }
    }
    return 0;
}
