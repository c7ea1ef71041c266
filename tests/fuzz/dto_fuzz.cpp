// Samples of a board: the first octets choose format and signals, the rest are packets with their length
// before.
#include "devices/xcp/daq_list.h"

#include <algorithm>
#include <cmath>

using namespace halbench::devices::xcp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 8) {
        return 0;
    }
    DaqFormat format;
    format.idField = static_cast<IdField>(data[0] & 3);
    format.order = (data[0] & 4) != 0 ? ByteOrder::BigEndian : ByteOrder::LittleEndian;
    constexpr std::size_t Sizes[] = {0, 1, 2, 4};
    format.timestampSize = Sizes[(data[0] >> 3) & 3];
    format.marksOverloadInPid = (data[0] & 32) != 0;
    format.maxDto = static_cast<std::uint16_t>(8 + data[1]);
    format.maxEntrySize = static_cast<std::uint8_t>(1 + data[2] % 8);
    format.granularity = static_cast<std::uint8_t>(1 + data[3] % 4);
    std::vector<DaqEntry> entries(1 + data[4] % 32);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        entries[i].type = static_cast<DataType>((data[5] + i * data[6]) % 10);
        entries[i].bitMask = (data[7] & 1) != 0 ? 0xF0 : ~std::uint64_t{0};
    }
    auto plan = planDaqList(entries, format);
    if (!plan) {
        return 0;
    }
    DtoDecoder decoder(format, entries, *plan, data[7], data[6]);
    TickUnwrapper unwrapper(std::max<std::size_t>(format.timestampSize, 1), 1e-6);
    double arrival_s = 0.0;
    for (std::size_t place = 8; place < size;) {
        const std::size_t length = std::min<std::size_t>(data[place], size - place - 1);
        if (decoder.feed({data + place + 1, length})) {
            arrival_s += 0.01 * data[place];
            (void)unwrapper.unwrap(decoder.timestamp(), arrival_s);
            if (decoder.row().size() != entries.size()) {
                __builtin_trap();
            }
        }
        place += length + 1;
    }
    return 0;
}
