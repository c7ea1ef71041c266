#include "devices/xcp/a2l.h"
#include "devices/xcp/xcp_master.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices::xcp {

namespace {

constexpr double MaxDescriptionTime_s = 60.0;
constexpr int DescriptionTries = 3;
constexpr std::uint8_t DescriptionExtension = 1;
constexpr std::uint32_t MaxIdentity = 1024;

} // namespace

Result<std::string> XcpMaster::identity(IdType type) {
    return m_link->recover([&] { return identityOnce(type); });
}

Reply<std::string> XcpMaster::identityOnce(IdType type) {
    m_mta.reset();
    const Reply<Packet> answer = m_link->exchange(m_encoder.getId(type));
    if (!answer) {
        if (isRefused(answer.error())) {
            return std::string();
        }
        return tl::unexpected(answer.error());
    }
    const Result<IdResponse> id = decodeId(*answer, m_session.order);
    if (!id) {
        return badAnswer(id.error());
    }
    if (id->isInline) {
        return id->text;
    }
    std::string text;
    while (text.size() < std::min(id->length, MaxIdentity)) {
        const std::size_t chunk =
            std::min<std::size_t>(id->length - text.size(), m_session.maxCto - std::size_t{1});
        const Reply<Packet> octets = uploadHere(chunk);
        if (!octets) {
            return tl::unexpected(octets.error());
        }
        text.append(octets->begin(), octets->end());
    }
    return text;
}

Result<std::string> XcpMaster::description(const KnownDescription& known) {
    m_mta.reset();
    for (int attempt = 0;; ++attempt) {
        const Result<IdResponse> id = m_link->recover([&]() -> Reply<IdResponse> {
            const Reply<Packet> answer = m_link->exchange(m_encoder.getId(IdType::Upload));
            if (!answer) {
                return tl::unexpected(answer.error());
            }
            const Result<IdResponse> decoded = decodeId(*answer, m_session.order);
            if (!decoded) {
                return badAnswer(decoded.error());
            }
            return *decoded;
        });
        const bool isRefusedText = !id && id.error().code == ErrorCode::DeviceRefused;
        if (isRefusedText || (id && id->length == 0)) {
            return failure(ErrorCode::Protocol, "the device has no built-in description",
                           "give the A2L file that belongs to it: DEVICE?a2l=FILE");
        }
        if (!id) {
            return failure(id.error());
        }
        if (id->length > MaxA2lSize) {
            return failure(ErrorCode::Protocol,
                           fmt::format("the device's description has {} bytes", id->length),
                           fmt::format("at most {} are read", MaxA2lSize));
        }
        if (std::optional<std::string> text = known(id->length); text && !id->isInline) {
            return *std::move(text);
        }
        Result<std::string> text = id->isInline ? id->text : uploadDescription(id->length);
        const bool isWorthAnother = attempt < DescriptionTries - 1 && !m_link->lost();
        if (text || !isWorthAnother) {
            return text;
        }
    }
}

/// UPLOAD from where GET_ID left the transfer pointer. A lost answer leaves it at an unknown place; boards
/// whose text also lies at extension 1 (3.13) are read on from there, others from GET_ID once more.
Result<std::string> XcpMaster::uploadDescription(std::size_t length) {
    const double end_s = m_link->transport().now_s() + MaxDescriptionTime_s;
    // In block mode several answers follow one command (3.5): a line that is slow to turn round, as USB
    // adapters are, waits once for 248 octets instead of once for 31.
    constexpr std::size_t LongestBlock = 255;
    const std::size_t single = m_session.maxCto - std::size_t{1};
    const std::size_t chunk = m_session.hasBlockMode() ? LongestBlock / single * single : single;
    std::string text;
    bool isAddressed = false;
    while (text.size() < length && m_link->transport().now_s() < end_s) {
        const std::size_t size = std::min(length - text.size(), chunk);
        const Address here{static_cast<std::uint32_t>(text.size()), DescriptionExtension};
        Result<Packet> octets;
        if (isAddressed) {
            octets = read(here, size);
        } else if (const Reply<Packet> next = uploadHere(size); next) {
            octets = *next;
        } else {
            octets = failure(next.error().error);
            const Result<bool> delivers = m_link->lost() ? Result<bool>(false) : deliversAt(text);
            isAddressed = delivers.value_or(false);
            if (isAddressed) {
                continue;
            }
        }
        if (!octets) {
            return failure(octets.error());
        }
        text.append(octets->begin(), octets->end());
    }
    if (text.size() < length) {
        return failure(
            ErrorCode::DeviceLost,
            fmt::format("the board needed more than {} s for its description", MaxDescriptionTime_s),
            "use a faster connection");
    }
    return text;
}

/// True when the description's extension begins with the text received so far.
Result<bool> XcpMaster::deliversAt(const std::string& text) {
    if (const Result<void> synchronised = m_link->synchronise(); !synchronised) {
        return failure(synchronised.error());
    }
    const std::size_t size = std::min<std::size_t>(text.size(), m_session.maxCto - std::size_t{1});
    if (size == 0) {
        return false;
    }
    const Result<Packet> octets = read({0, DescriptionExtension}, size);
    return octets && std::equal(octets->begin(), octets->end(), text.begin(),
                                [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
}

} // namespace halbench::devices::xcp
