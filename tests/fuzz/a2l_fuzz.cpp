// Descriptions of a board: any text. What comes out must be usable without further checks.
#include "devices/xcp/board_description.h"

#include <cmath>

using namespace halbench::devices::xcp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    auto description = parseA2l({reinterpret_cast<const char*>(data), size});
    if (!description) {
        if (description.error().message.empty()) {
            __builtin_trap();
        }
        return 0;
    }
    const BoardDescription board(*std::move(description), std::nullopt);
    for (const auto& spec : board.catalogue().parameters) {
        const bool isUsable = spec.min <= spec.max && std::isfinite(spec.min) && std::isfinite(spec.max) &&
                              board.characteristic(spec.name) != nullptr;
        if (!isUsable) {
            __builtin_trap();
        }
    }
    return 0;
}
