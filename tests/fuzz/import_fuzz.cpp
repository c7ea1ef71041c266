// Tables of other programs: any text. What is read must be read the same once it is our own recording.
#include "devices/formats/csv_import.h"
#include "devices/recording/recording_csv.h"

#include <cmath>
#include <cstdint>

using namespace halbench;
using namespace halbench::devices;

namespace {

/// The first two octets are answers to the questions, so that more than the sure dialects is reached.
CsvImportRequest requestFrom(const std::uint8_t* data) {
    constexpr char Separators[] = {',', ';', '\t', ' ', '\0'};
    CsvImportRequest request;
    if ((data[0] & 1) != 0) {
        request.hints.separator = Separators[(data[0] >> 1) % 5];
    }
    if ((data[1] & 1) != 0) {
        request.hints.decimal = (data[1] & 2) != 0 ? ',' : '.';
    }
    if ((data[1] & 4) != 0) {
        request.hints.header = static_cast<CsvHeader>((data[1] >> 3) % 3);
    }
    if ((data[1] & 32) != 0) {
        request.rate_Hz = 100.0;
    }
    if ((data[1] & 64) != 0) {
        request.timeColumn = "1";
        request.units = {{"1", "ms"}};
    }
    return request;
}

bool isSame(double one, double other) {
    return one == other || (std::isnan(one) && std::isnan(other));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) {
        return 0;
    }
    const std::string_view text(reinterpret_cast<const char*>(data) + 2, size - 2);
    const auto plan = planCsvImport(text, "fuzz.csv", requestFrom(data));
    if (!plan || !plan->questions.empty()) {
        return 0;
    }
    const auto import = importCsv(text, "fuzz.csv", *plan);
    if (!import) {
        if (import.error().message.empty() || import.error().hint.empty()) {
            __builtin_trap();
        }
        return 0;
    }
    const Recording& recording = import->recording;
    std::string own = csvHeader(*recording.layout);
    appendCsvRows(own, {recording.layout, recording.time_s, recording.values, 0.0, 0}, CsvNumbers::Exact);
    const auto again = parseRecordingCsv(own, "again.csv");
    if (!again || again->time_s != recording.time_s || again->values.size() != recording.values.size()) {
        __builtin_trap();
    }
    for (std::size_t i = 0; i < recording.values.size(); ++i) {
        if (!isSame(again->values[i], recording.values[i])) {
            __builtin_trap();
        }
    }
    return 0;
}
