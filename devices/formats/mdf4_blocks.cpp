#include "devices/formats/mdf4_blocks.h"

namespace halbench::devices::mdf4 {

std::string makeBlock(std::string_view id, std::initializer_list<std::uint64_t> links,
                      std::string_view data) {
    const std::size_t size = HeaderSize + LinkSize * links.size() + data.size();
    const std::size_t filled = (size + 7) / 8 * 8;
    std::string block(id);
    put(block, std::uint32_t{0});
    put(block, std::uint64_t{filled});
    put(block, std::uint64_t{links.size()});
    for (const std::uint64_t link : links) {
        put(block, link);
    }
    block += data;
    block.resize(filled, '\0');
    return block;
}

} // namespace halbench::devices::mdf4
