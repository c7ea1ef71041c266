// Answers of a board and the byte stream they come in: any octets, any split.
#include "devices/transport/message_stream.h"
#include "devices/xcp/packets.h"

#include <algorithm>

using namespace halbench::devices;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const xcp::Octets octets(data, size);
    for (const auto order : {xcp::ByteOrder::LittleEndian, xcp::ByteOrder::BigEndian}) {
        (void)xcp::decodeId(octets, order);
        (void)xcp::decodeChecksum(octets, order);
        (void)xcp::decodeDaqProcessor(octets, order);
        (void)xcp::decodeDaqResolution(octets, order);
        (void)xcp::decodeDaqClock(octets, order);
    }
    (void)xcp::decodeConnect(octets);
    (void)xcp::decodeStatus(octets);
    (void)xcp::decodeCalPage(octets);
    (void)xcp::decodeDaqEvent(octets);
    (void)xcp::kindOf(octets);
    (void)xcp::hexText(octets);

    MessageParser parser(255);
    const std::size_t step = size > 0 ? 1 + data[0] % 16 : 1;
    for (std::size_t begin = 0; begin < size; begin += step) {
        parser.feed(octets.subspan(begin, std::min(step, size - begin)));
        for (auto message = parser.next(); message && *message; message = parser.next()) {
            if ((*message)->packet.empty() || (*message)->packet.size() > 255) {
                __builtin_trap();
            }
        }
    }
    return 0;
}
