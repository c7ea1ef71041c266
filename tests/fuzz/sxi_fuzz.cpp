// Both receivers of a serial line, the program's and the board's: any octets, any split. On the default
// profile they have to find the same packets. The first octet chooses the program's profile and the split.
#include "devices/firmware/xcp/hb_sxi.h"
#include "devices/transport/sxi_codec.h"

#include <algorithm>
#include <vector>

using namespace halbench::devices;

namespace {

using Packets = std::vector<std::vector<std::uint8_t>>;

Packets foundByTheProgram(const SxiProfile& profile, std::span<const std::uint8_t> octets, std::size_t step) {
    SxiCodec codec(profile);
    Packets packets;
    for (std::size_t begin = 0; begin < octets.size(); begin += step) {
        codec.feed(octets.subspan(begin, std::min(step, octets.size() - begin)));
        for (auto frame = codec.next(); frame && *frame; frame = codec.next()) {
            const std::span<const std::uint8_t> packet = (*frame)->packet;
            if (packet.empty() || packet.size() > SxiCodec::MaxPacket) {
                __builtin_trap();
            }
            packets.emplace_back(packet.begin(), packet.end());
        }
        if (begin % 3 == 0) {
            codec.noteSilence();
        }
    }
    return packets;
}

Packets foundByTheBoard(std::span<const std::uint8_t> octets) {
    hb_sxi_receiver receiver;
    hb_sxi_receiver_init(&receiver);
    Packets packets;
    for (const std::uint8_t octet : octets) {
        if (const std::uint16_t length = hb_sxi_receive(&receiver, octet); length > 0) {
            const std::uint8_t* packet = hb_sxi_packet(&receiver);
            packets.emplace_back(packet, packet + length);
        }
    }
    return packets;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) {
        return 0;
    }
    const std::span<const std::uint8_t> octets(data + 1, size - 1);
    const unsigned choice = data[0];
    const SxiProfile profile{static_cast<SxiHeader>(choice % 6), static_cast<SxiChecksum>(choice / 6 % 3),
                             choice / 18 % 2 == 0};
    const std::size_t step = 1 + choice % 13;
    (void)foundByTheProgram(profile, octets, step);
    Packets expected = foundByTheProgram({}, octets, step);
    std::erase_if(expected, [](const auto& packet) { return packet.size() > HB_MAX_CTO; });
    if (foundByTheBoard(octets) != expected) {
        __builtin_trap();
    }
    return 0;
}
