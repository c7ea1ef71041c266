#pragma once

#include "devices/transport/frame_codec.h"
#include "devices/transport/message_stream.h"

namespace halbench::devices {

/// The TCP byte stream on another line: USB bulk, HID (resources/help/protocol.md 3.4). Nothing is lost there
/// without the line being lost, so that nonsense ends it.
class StreamCodec : public FrameCodec {
public:
    StreamCodec() : m_parser(MaxPacket) {}

    void restart() override { m_parser = MessageParser(MaxPacket); }
    void feed(std::span<const std::uint8_t> octets) override { m_parser.feed(octets); }
    Result<std::optional<Frame>> next() override;
    void noteSilence() override {}
    void append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                std::span<const std::uint8_t> packet) override {
        appendMessage(line, counter, packet);
    }
    std::uint64_t damaged() const override { return m_damaged; }
    std::uint16_t counterMask() const override { return 0xFFFF; }

private:
    static constexpr std::size_t MaxPacket = 0xFFFF;

    MessageParser m_parser;
    std::uint64_t m_damaged = 0;
};

} // namespace halbench::devices
