// MODEL.json and GAINS.json: any text.
#include "app/documents/model_file.h"

using namespace halbench::app;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const halbench::Result<ModelFile> model = parseModel(text, "fuzz.json");
    const halbench::Result<GainsFile> gains = parseGains(text, "fuzz.json");
    if ((!model && model.error().message.empty()) || (!gains && gains.error().message.empty())) {
        __builtin_trap();
    }
    return 0;
}
