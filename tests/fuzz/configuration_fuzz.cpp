// Configuration files: any text; what is accepted comes back as it was written.
#include "app/documents/configuration_file.h"

using namespace halbench::app;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const halbench::Result<Configuration> read = parseConfiguration(text, "fuzz.toml");
    if (!read) {
        if (read.error().message.empty() || read.error().hint.empty()) {
            __builtin_trap(); // every refusal says what to do
        }
        return 0;
    }
    const halbench::Result<Configuration> again = parseConfiguration(configurationText(*read), "again.toml");
    if (!again || again->values != read->values || again->device.overrides != read->device.overrides) {
        __builtin_trap();
    }
    return 0;
}
