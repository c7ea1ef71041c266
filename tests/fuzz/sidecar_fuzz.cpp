// Sidecars of recordings: any text. What was read must come back the same after writing.
#include "devices/recording/recording_meta.h"

using namespace halbench;
using namespace halbench::devices;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto meta = parseMetaJson({reinterpret_cast<const char*>(data), size}, "fuzz.meta.json");
    if (!meta) {
        if (meta.error().message.find("fuzz.meta.json") == std::string::npos) {
            __builtin_trap();
        }
        return 0;
    }
    const std::string text = toMetaJson(*meta);
    const auto again = parseMetaJson(text, "again.meta.json");
    if (!again || toMetaJson(*again) != text) {
        __builtin_trap();
    }
    return 0;
}
