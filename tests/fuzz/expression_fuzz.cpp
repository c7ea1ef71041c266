// Definitions of derived signals, as --derive and projects have them: any text, computed for a row and in
// units.
#include "devices/acquisition/derived_signals.h"

#include <cmath>

using namespace halbench;
using namespace halbench::devices;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto derived = parseDerivedSignal(std::string(reinterpret_cast<const char*>(data), size));
    if (!derived) {
        return 0;
    }
    Recording recording;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"hall.a", "T"}, {"current.a", "A"}};
    recording.layout = layout;
    recording.time_s = {0.0, 0.001};
    recording.values = {0.157, -2.0, std::nan(""), 0.0};
    const auto longer = withDerived(recording, {*derived});
    if (!longer) {
        if (longer.error().message.empty() || longer.error().hint.empty()) {
            __builtin_trap();
        }
        return 0;
    }
    for (const double value : longer->column(derived->name)) {
        if (std::isinf(value)) {
            __builtin_trap(); // what is no number is missing
        }
    }
    return 0;
}
