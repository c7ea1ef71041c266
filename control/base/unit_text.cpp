#include "control/base/unit_text.h"

#include <array>
#include <utility>

namespace halbench {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> Signs = {{{"sqrt(Hz)", "\u221aHz"},
                                                                                 {"*", "\u00b7"},
                                                                                 {"^2", "\u00b2"},
                                                                                 {"^3", "\u00b3"},
                                                                                 {"Ohm", "\u03a9"},
                                                                                 {"deg", "\u00b0"}}};

} // namespace

std::string unitText(std::string_view symbol) {
    std::string text(symbol);
    for (const auto& [plain, sign] : Signs) {
        for (std::size_t at = text.find(plain); at != std::string::npos;
             at = text.find(plain, at + sign.size())) {
            text.replace(at, plain.size(), sign);
        }
    }
    return text;
}

} // namespace halbench
