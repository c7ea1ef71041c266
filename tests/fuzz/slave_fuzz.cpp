// The board's receive path: any packets, with control cycles between them. Records are length and octets; a
// length of 0 is a cycle.
#include "devices/firmware/htm/hb_htm.h"

#include <algorithm>
#include <cmath>
#include <memory>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto board = std::make_unique<hb_htm>();
    hb_htm_init(board.get(), nullptr);
    const std::uint8_t connect[] = {0xFF, 0x00};
    hb_board_receive(&board->board, connect, sizeof connect);
    const hb_htm_inputs inputs = {{800.0F, 511.5F}, {153.0F, 153.0F}};
    hb_htm_outputs outputs;
    std::uint8_t packet[HB_MAX_DTO];
    for (std::size_t place = 0; place < size;) {
        const std::size_t length = std::min<std::size_t>(data[place], size - place - 1);
        if (length == 0) {
            hb_htm_fast_tick(board.get(), &inputs, &outputs);
            if (!std::isfinite(outputs.phase_current_A[0]) || std::fabs(outputs.phase_current_A[0]) > 5.01F) {
                __builtin_trap();
            }
        } else {
            // A copy of its own, so that a read beyond the packet is seen.
            const std::unique_ptr<std::uint8_t[]> copy(new std::uint8_t[length]);
            std::copy_n(data + place + 1, length, copy.get());
            hb_board_receive(&board->board, copy.get(), static_cast<std::uint16_t>(length));
        }
        while (hb_board_transmit(&board->board, packet, sizeof packet) != 0) {
        }
        place += length + 1;
    }
    return 0;
}
