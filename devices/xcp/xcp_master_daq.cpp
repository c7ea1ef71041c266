#include "devices/xcp/xcp_master.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices::xcp {

namespace {

constexpr std::uint8_t TimestampMode = 0x10;
constexpr std::uint8_t Select = 2;
constexpr std::uint8_t StartSelected = 1;
constexpr std::uint8_t StopAll = 0;
constexpr std::uint16_t List = 0;
constexpr std::uint16_t MaxEvents = 64;

/// An answer a board may refuse to give without being useless: nothing then.
template <typename Value, typename Decoder>
Reply<std::optional<Value>> optionalAnswer(XcpLink& link, const Packet& command, Decoder decode) {
    const Reply<Packet> answer = link.exchange(command);
    if (!answer) {
        if (isRefused(answer.error())) {
            return std::optional<Value>{};
        }
        return tl::unexpected(answer.error());
    }
    const Result<Value> decoded = decode(*answer);
    if (!decoded) {
        return badAnswer(decoded.error());
    }
    return std::optional<Value>(*decoded);
}

} // namespace

Result<std::optional<DaqAbility>> XcpMaster::daqAbility() {
    if (!m_session.hasDaq()) {
        return std::optional<DaqAbility>{};
    }
    const ByteOrder order = m_session.order;
    const auto processor = m_link->recover([&] {
        return optionalAnswer<DaqProcessorResponse>(
            *m_link, m_encoder.plain(Command::GetDaqProcessorInfo),
            [order](Octets a) { return decodeDaqProcessor(a, order); });
    });
    if (!processor) {
        return failure(processor.error());
    }
    const auto resolution = m_link->recover([&] {
        return optionalAnswer<DaqResolutionResponse>(
            *m_link, m_encoder.plain(Command::GetDaqResolutionInfo),
            [order](Octets a) { return decodeDaqResolution(a, order); });
    });
    if (!resolution) {
        return failure(resolution.error());
    }
    if (!*processor || !*resolution || !(*processor)->isDynamic()) {
        return std::optional<DaqAbility>{};
    }
    const DaqProcessorResponse& info = **processor;
    const DaqResolutionResponse& grain = **resolution;
    DaqAbility ability;
    ability.hasTimestamp = grain.timestampSize != 0 && (info.hasTimestamp() || grain.isTimestampFixed);
    ability.format.idField = info.idField;
    ability.format.order = order;
    ability.format.timestampSize = ability.hasTimestamp ? grain.timestampSize : 0;
    ability.format.marksOverloadInPid = info.marksOverloadInPid();
    ability.format.maxDto = m_session.maxDto;
    ability.format.maxEntrySize = grain.maxEntrySize;
    ability.format.granularity = grain.granularity;
    ability.hasPrescaler = info.hasPrescaler();
    ability.tick_s = grain.tick_s;
    ability.ticksPerSecond = grain.ticksPerSecond;
    if (const Result<void> events = readEventCycles(info.maxEvent, ability); !events) {
        return failure(events.error());
    }
    return std::optional<DaqAbility>(std::move(ability));
}

Result<std::optional<std::uint32_t>> XcpMaster::clockTicks() {
    return m_link->recover([&] {
        return optionalAnswer<std::uint32_t>(
            *m_link, m_encoder.plain(Command::GetDaqClock),
            [order = m_session.order](Octets a) { return decodeDaqClock(a, order); });
    });
}

Result<void> XcpMaster::readEventCycles(std::uint16_t count, DaqAbility& ability) {
    for (std::uint16_t event = 0; event < std::min(count, MaxEvents); ++event) {
        const auto answer = m_link->recover([&] {
            return optionalAnswer<DaqEventResponse>(*m_link, m_encoder.getDaqEventInfo(event),
                                                    [](Octets a) { return decodeDaqEvent(a); });
        });
        m_mta.reset();
        if (!answer) {
            return failure(answer.error());
        }
        if (!*answer) {
            ability.eventCycles_s.clear();
            return {};
        }
        ability.eventCycles_s.push_back((*answer)->cycle_s);
    }
    return {};
}

Reply<void> XcpMaster::allocateList(const DaqPlan& plan) {
    std::vector<Packet> commands = {m_encoder.startStopSynch(StopAll), m_encoder.plain(Command::FreeDaq),
                                    m_encoder.allocDaq(1),
                                    m_encoder.allocOdt(List, static_cast<std::uint8_t>(plan.size()))};
    for (std::size_t odt = 0; odt < plan.size(); ++odt) {
        commands.push_back(m_encoder.allocOdtEntry(List, static_cast<std::uint8_t>(odt),
                                                   static_cast<std::uint8_t>(plan[odt].size())));
    }
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Reply<Packet> done = m_link->exchange(commands[i]);
        const bool isRefusedStop = i == 0 && !done && isRefused(done.error());
        if (!done && !isRefusedStop) { // a board without lists may refuse to stop them
            return tl::unexpected(done.error());
        }
    }
    return {};
}

/// The pointer moves with every entry; after a trouble its place is unknown and is set again (3.6).
Reply<void> XcpMaster::writeEntry(const DaqEntry& entry, std::uint8_t odt, std::uint8_t place) {
    const std::pair<std::uint8_t, std::uint8_t> here{odt, place};
    if (m_daqPtr != here) {
        m_daqPtr.reset();
        if (const Reply<Packet> moved = m_link->exchange(m_encoder.setDaqPtr(List, odt, place)); !moved) {
            return tl::unexpected(moved.error());
        }
    }
    m_daqPtr.reset();
    const auto size = static_cast<std::uint8_t>(sizeOf(entry.type));
    if (const Reply<Packet> done = m_link->exchange(m_encoder.writeDaq(entry.address, size)); !done) {
        return tl::unexpected(done.error());
    }
    m_daqPtr = {odt, static_cast<std::uint8_t>(place + 1)};
    return {};
}

Result<std::uint8_t> XcpMaster::configureList(const ListRequest& request) {
    if (const Result<void> done = m_link->recover([&] { return allocateList(*request.plan); }); !done) {
        return failure(done.error());
    }
    m_daqPtr.reset();
    for (std::size_t odt = 0; odt < request.plan->size(); ++odt) {
        const std::vector<std::size_t>& entries = (*request.plan)[odt];
        for (std::size_t place = 0; place < entries.size(); ++place) {
            const Result<void> done = m_link->recover([&] {
                return writeEntry((*request.entries)[entries[place]], static_cast<std::uint8_t>(odt),
                                  static_cast<std::uint8_t>(place));
            });
            if (!done) {
                return failure(done.error());
            }
        }
    }
    const std::uint8_t mode = request.hasTimestamp ? TimestampMode : 0;
    if (const Result<void> done =
            order(m_encoder.setDaqListMode(mode, List, request.event, request.prescaler));
        !done) {
        return failure(done.error());
    }
    return m_link->recover([&]() -> Reply<std::uint8_t> {
        const Reply<Packet> answer = exchangeSized(m_encoder.startStopDaqList(Select, List), 2);
        if (!answer) {
            return tl::unexpected(answer.error());
        }
        return (*answer)[1];
    });
}

Result<void> XcpMaster::startList() {
    bool isRepeat = false;
    return m_link->recover([&]() -> Reply<void> {
        if (isRepeat) {
            // The answer to the start may have been lost after it took effect.
            const Reply<Packet> answer = m_link->exchange(m_encoder.plain(Command::GetStatus));
            const Result<StatusResponse> now = answer ? decodeStatus(*answer) : Result<StatusResponse>();
            if (answer && now && now->isDaqRunning()) {
                return {};
            }
            if (const Reply<Packet> selected = m_link->exchange(m_encoder.startStopDaqList(Select, List));
                !selected) {
                return tl::unexpected(selected.error());
            }
        }
        isRepeat = true;
        const Reply<Packet> started = m_link->exchange(m_encoder.startStopSynch(StartSelected));
        if (!started) {
            return tl::unexpected(started.error());
        }
        return {};
    });
}

Result<void> XcpMaster::stopLists() {
    return order(m_encoder.startStopSynch(StopAll));
}

} // namespace halbench::devices::xcp
