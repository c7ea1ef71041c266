#include "devices/transport/stream_codec.h"

namespace halbench::devices {

Result<std::optional<Frame>> StreamCodec::next() {
    const Result<std::optional<StreamMessage>> message = m_parser.next();
    if (!message) {
        ++m_damaged;
        return failure(message.error());
    }
    if (!*message) {
        return std::optional<Frame>{};
    }
    return std::optional<Frame>(Frame{(*message)->counter, (*message)->packet});
}

} // namespace halbench::devices
