#include "devices/xcp/xcp_master.h"

#include "control/base/assert.h"
#include "devices/xcp/a2l.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices::xcp {

namespace {

constexpr double ConnectPeriod_s = 0.3;
constexpr double ConnectPause_s = 0.02;
constexpr double MaxStoreTime_s = 5.0;
constexpr double StorePoll_s = 0.02;
constexpr std::uint8_t ReleaseSubCommand = 0x52; // "R"

Error sizeError(const Packet& command, const Packet& answer, std::size_t size) {
    return {ErrorCode::Protocol,
            fmt::format("the answer to {} has {} bytes ({}), {} are required", commandName(command[0]),
                        answer.size(), hexText(answer), size),
            "update the board's firmware or check the line"};
}

bool isRefusedWith(const Reply<Packet>& reply, SlaveError error) {
    return !reply && reply.error().cause == TroubleCause::Slave &&
           reply.error().slaveError == static_cast<std::uint8_t>(error);
}

/// A CONNECT that was refused for a reason of the whole board.
Error connectError(const Trouble& trouble, const Transport& transport) {
    if (trouble.cause == TroubleCause::Slave && isBusy(trouble.slaveError)) {
        return {
            ErrorCode::DeviceRefused,
            fmt::format("{}: another program is connected to this device", transport.description()),
            "end the other connection, then connect again; an inactive connection ends after a few seconds"};
    }
    return trouble.error;
}

/// The board has said of this very command that it did nothing. SEQUENCE and SYNCH may answer an older one.
bool isDefinite(const Trouble& trouble) {
    const auto code = static_cast<SlaveError>(trouble.slaveError);
    return trouble.cause == TroubleCause::Slave && code != SlaveError::Sequence && code != SlaveError::Synch;
}

} // namespace

/// Sends a command whose answer `decode` understands, with recovery.
template <typename Decoder>
auto XcpMaster::query(const Packet& command, Decoder decode) {
    using Value = typename decltype(decode(Octets{}))::value_type;
    return m_link->recover([&]() -> Reply<Value> {
        const Reply<Packet> answer = m_link->exchange(command);
        if (!answer) {
            return tl::unexpected(answer.error());
        }
        auto decoded = decode(Octets(*answer));
        if (!decoded) {
            return badAnswer(decoded.error());
        }
        return *std::move(decoded);
    });
}

Result<void> XcpMaster::order(const Packet& command) {
    const auto done = query(command, [](Octets) -> Result<bool> { return true; });
    if (!done) {
        return failure(done.error());
    }
    return {};
}

Reply<Packet> XcpMaster::exchangeSized(const Packet& command, std::size_t size) {
    Reply<Packet> answer = m_link->exchange(command);
    if (answer && answer->size() < size) {
        return badAnswer(sizeError(command, *answer, size));
    }
    return answer;
}

Result<void> XcpMaster::connect(double patience_s) {
    const double end_s = m_link->transport().now_s() + patience_s;
    m_mta.reset();
    for (;;) {
        const Reply<ConnectResponse> session = connectOnce();
        if (session) {
            m_session = *session;
            m_hasConnected = true;
            m_encoder = CommandEncoder(session->order);
            return {};
        }
        const Trouble& trouble = session.error();
        const bool isHopeless = trouble.cause == TroubleCause::Lost ||
                                (trouble.cause == TroubleCause::Slave && !isBusy(trouble.slaveError));
        const double next_s = m_link->transport().now_s() + ConnectPause_s;
        if (isHopeless || next_s >= end_s) {
            return failure(connectError(trouble, m_link->transport()));
        }
        m_link->transport().noteUnansweredConnect();
        if (Result<void> waited = m_link->pumpUntil(next_s); !waited) {
            return waited;
        }
    }
}

Reply<ConnectResponse> XcpMaster::connectOnce() {
    const Reply<Packet> answer = m_link->exchange(CommandEncoder().connect(), ConnectPeriod_s);
    if (!answer) {
        return tl::unexpected(answer.error());
    }
    const Result<ConnectResponse> session = decodeConnect(*answer);
    if (!session) {
        return badAnswer(session.error());
    }
    return *session;
}

/// A session that is not ended keeps other masters out: an order that is lost is given once more.
void XcpMaster::disconnect() noexcept {
    const int tries = m_hasConnected ? 2 : 1;
    for (int attempt = 0; attempt < tries && !m_link->lost(); ++attempt) {
        const Reply<Packet> ended = m_link->exchange(m_encoder.plain(Command::Disconnect));
        if (ended || ended.error().cause != TroubleCause::Timeout) {
            break;
        }
    }
}

Result<StatusResponse> XcpMaster::status() {
    return query(m_encoder.plain(Command::GetStatus), decodeStatus);
}

Reply<void> XcpMaster::moveTo(Address address) {
    if (m_mta == address) {
        return {};
    }
    m_mta.reset();
    const Reply<Packet> moved = m_link->exchange(m_encoder.setMta(address));
    if (!moved) {
        return tl::unexpected(moved.error());
    }
    m_mta = address;
    return {};
}

/// UPLOAD from where the transfer pointer stands. After any trouble its place is unknown.
Reply<Packet> XcpMaster::uploadHere(std::size_t size) {
    const std::optional<Address> start = m_mta;
    m_mta.reset();
    const Packet command = m_encoder.upload(static_cast<std::uint8_t>(size));
    Reply<Packet> answer = m_link->exchange(command);
    Packet octets;
    while (answer && octets.size() < size) {
        const std::size_t expected = std::min<std::size_t>(size - octets.size(), m_session.maxCto - 1U);
        if (answer->size() < expected + 1) {
            return badAnswer(sizeError(command, *answer, expected + 1));
        }
        octets.insert(octets.end(), answer->begin() + 1,
                      answer->begin() + 1 + static_cast<std::ptrdiff_t>(expected));
        if (octets.size() < size) {
            answer = m_link->nextResponse(command[0]);
        }
    }
    if (!answer) {
        return tl::unexpected(answer.error());
    }
    if (start) {
        m_mta = Address{start->offset + static_cast<std::uint32_t>(size), start->extension};
    }
    return octets;
}

Result<Packet> XcpMaster::shortUpload(Address address, std::size_t size) {
    const Packet command = m_encoder.shortUpload(address, static_cast<std::uint8_t>(size));
    m_mta.reset();
    return m_link->recover([&]() -> Reply<Packet> {
        Reply<Packet> answer = exchangeSized(command, size + 1);
        if (answer) {
            return Packet(answer->begin() + 1, answer->begin() + 1 + static_cast<std::ptrdiff_t>(size));
        }
        return answer;
    });
}

Result<Packet> XcpMaster::read(Address address, std::size_t size) {
    // One answer carries MAX_CTO - 1 octets; in block mode the board sends several in a row (3.5).
    const std::size_t single = m_session.maxCto - std::size_t{1};
    if (size <= single) {
        return shortUpload(address, size);
    }
    const std::size_t chunk = m_session.hasBlockMode() ? 255 : single;
    Packet octets;
    while (octets.size() < size) {
        const Address here{address.offset + static_cast<std::uint32_t>(octets.size()), address.extension};
        Result<Packet> part = m_link->recover([&]() -> Reply<Packet> {
            if (const Reply<void> moved = moveTo(here); !moved) {
                return tl::unexpected(moved.error());
            }
            return uploadHere(std::min(size - octets.size(), chunk));
        });
        if (!part) {
            return part;
        }
        octets.insert(octets.end(), part->begin(), part->end());
    }
    return octets;
}

bool XcpMaster::fitsOneDownload(std::size_t size) const {
    return size + 2 <= m_session.maxCto;
}

Reply<void> XcpMaster::downloadAt(Address address, Octets data) {
    if (Reply<void> moved = moveTo(address); !moved) {
        return moved;
    }
    m_mta.reset();
    const Reply<Packet> done = m_link->exchange(m_encoder.download(data));
    if (!done) {
        return tl::unexpected(done.error());
    }
    m_mta = Address{address.offset + static_cast<std::uint32_t>(data.size()), address.extension};
    return {};
}

Result<void> XcpMaster::writeInOneDownload(Address address, Octets data) {
    HB_ASSERT(fitsOneDownload(data.size()));
    return m_link->recover([&] { return downloadAt(address, data); });
}

/// One try; the board's lack of SHORT_DOWNLOAD (3.6) is found out on the way.
Reply<void> XcpMaster::tryWrite(Address address, Octets data) {
    if (m_hasShortDownload && data.size() + 8 <= m_session.maxCto) {
        m_mta.reset();
        const Reply<Packet> answer = m_link->exchange(m_encoder.shortDownload(address, data));
        if (answer) {
            return {};
        }
        if (!isRefusedWith(answer, SlaveError::CommandUnknown)) {
            return tl::unexpected(answer.error());
        }
        m_hasShortDownload = false;
    }
    return downloadAt(address, data);
}

Result<std::optional<Error>> XcpMaster::writeOnce(Address address, Octets data, Repetition repetition) {
    HB_ASSERT(fitsOneDownload(data.size()));
    std::optional<Error> unknown; // why nobody knows whether the board took it
    const Result<void> tried = m_link->recover([&]() -> Reply<void> {
        const Reply<void> done = tryWrite(address, data);
        if (done) {
            return {};
        }
        const Trouble& trouble = done.error();
        const bool isHarmless = repetition == Repetition::Known && trouble.cause != TroubleCause::Overtaken;
        if (isHarmless || trouble.cause == TroubleCause::Lost || isDefinite(trouble)) {
            return tl::unexpected(trouble);
        }
        unknown = trouble.error;
        return {};
    });
    if (!tried) {
        return failure(tried.error());
    }
    if (unknown) {
        if (const Result<void> synchronised = m_link->synchronise(); !synchronised) {
            return failure(synchronised.error());
        }
    }
    return unknown;
}

Result<void> XcpMaster::write(Address address, Octets data) {
    if (m_hasShortDownload && data.size() + 8 <= m_session.maxCto) {
        m_mta.reset();
        const Packet command = m_encoder.shortDownload(address, data);
        const Result<bool> isDone = m_link->recover([&]() -> Reply<bool> {
            const Reply<Packet> answer = m_link->exchange(command);
            if (isRefusedWith(answer, SlaveError::CommandUnknown)) {
                return false; // some boards lack SHORT_DOWNLOAD (3.6)
            }
            if (!answer) {
                return tl::unexpected(answer.error());
            }
            return true;
        });
        if (!isDone) {
            return failure(isDone.error());
        }
        if (*isDone) {
            return {};
        }
        m_hasShortDownload = false;
    }
    const std::size_t chunk = m_session.maxCto - std::size_t{2};
    for (std::size_t done = 0; done < data.size(); done += chunk) {
        const Address here{address.offset + static_cast<std::uint32_t>(done), address.extension};
        const Octets part = data.subspan(done, std::min(chunk, data.size() - done));
        if (Result<void> written = writeInOneDownload(here, part); !written) {
            return written;
        }
    }
    return {};
}

Result<std::uint8_t> XcpMaster::page(PageAccess access, std::uint8_t segment) {
    return query(m_encoder.getCalPage(access, segment), decodeCalPage);
}

Result<void> XcpMaster::setPage(PageAccess access, std::uint8_t segment, std::uint8_t page) {
    return order(m_encoder.setCalPage(static_cast<std::uint8_t>(access), segment, page));
}

Result<bool> XcpMaster::copyPage(std::uint8_t segment, std::uint8_t from, std::uint8_t to) {
    return m_link->recover([&]() -> Reply<bool> {
        const Reply<Packet> answer = m_link->exchange(m_encoder.copyCalPage(segment, from, to));
        if (isRefusedWith(answer, SlaveError::WriteProtected)) {
            return false;
        }
        if (!answer) {
            return tl::unexpected(answer.error());
        }
        return true;
    });
}

Result<std::optional<ChecksumResponse>> XcpMaster::checksum(Address address, std::uint32_t size) {
    using Answer = std::optional<ChecksumResponse>;
    return m_link->recover([&]() -> Reply<Answer> {
        if (const Reply<void> moved = moveTo(address); !moved) {
            return tl::unexpected(moved.error());
        }
        m_mta.reset();
        const Reply<Packet> answer = m_link->exchange(m_encoder.buildChecksum(size));
        if (isRefusedWith(answer, SlaveError::CommandUnknown)) {
            return Answer{};
        }
        if (!answer) {
            return tl::unexpected(answer.error());
        }
        const Result<ChecksumResponse> checksum = decodeChecksum(*answer, m_session.order);
        if (!checksum) {
            return badAnswer(checksum.error());
        }
        return Answer(*checksum);
    });
}

Result<void> XcpMaster::storeCalibration() {
    if (Result<void> requested = order(m_encoder.setRequest(0x01)); !requested) {
        return requested;
    }
    const double end_s = m_link->transport().now_s() + MaxStoreTime_s;
    while (m_link->transport().now_s() < end_s) {
        const Result<StatusResponse> now = status();
        if (!now) {
            return failure(now.error());
        }
        if (!now->isStoring()) {
            return {};
        }
        const double next_s = m_link->transport().now_s() + StorePoll_s;
        if (Result<void> pumped = m_link->pumpUntil(next_s); !pumped) {
            return pumped;
        }
    }
    return failure(ErrorCode::DeviceRefused,
                   fmt::format("the board did not store its parameters within {} s", MaxStoreTime_s),
                   "try again, then read the values back");
}

Result<void> XcpMaster::userCommand(std::uint8_t sub) {
    return order(m_encoder.userCommand(sub));
}

Result<std::optional<Error>> XcpMaster::releaseStop() {
    const std::uint64_t stops = m_link->stopsSent();
    const Reply<Packet> answer = m_link->exchange(m_encoder.userCommand(ReleaseSubCommand));
    if (answer) {
        return std::optional<Error>();
    }
    const Trouble& trouble = answer.error();
    if (m_link->stopsSent() != stops) {
        return failure(ErrorCode::Interrupted, "interrupted by a stop",
                       "remove the cause, then release the stop again");
    }
    if (trouble.cause == TroubleCause::Lost || isDefinite(trouble)) {
        return failure(trouble.error);
    }
    if (const Result<void> synchronised = m_link->synchronise(); !synchronised) {
        return failure(synchronised.error());
    }
    return std::optional<Error>(trouble.error);
}

} // namespace halbench::devices::xcp
