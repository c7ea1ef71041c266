#include "control/base/assert.h"
#include "devices/xcp/packets.h"

namespace halbench::devices::xcp {

namespace {

/// Collects the fields of one command in the slave's byte order.
class Fields {
public:
    Fields(Command command, ByteOrder order) : m_order(order) {
        m_packet.push_back(static_cast<std::uint8_t>(command));
    }
    Fields& octet(std::uint8_t value) {
        m_packet.push_back(value);
        return *this;
    }
    Fields& word(std::uint16_t value) {
        appendUnsigned(m_packet, value, 2, m_order);
        return *this;
    }
    Fields& dword(std::uint32_t value) {
        appendUnsigned(m_packet, value, 4, m_order);
        return *this;
    }
    Fields& octets(Octets values) {
        m_packet.insert(m_packet.end(), values.begin(), values.end());
        return *this;
    }
    Packet take() { return std::move(m_packet); }

private:
    ByteOrder m_order;
    Packet m_packet;
};

} // namespace

Packet CommandEncoder::connect() const {
    return Fields(Command::Connect, m_order).octet(0).take();
}

Packet CommandEncoder::plain(Command command) const {
    return Fields(command, m_order).take();
}

Packet CommandEncoder::getId(IdType type) const {
    return Fields(Command::GetId, m_order).octet(static_cast<std::uint8_t>(type)).take();
}

Packet CommandEncoder::setRequest(std::uint8_t mode) const {
    return Fields(Command::SetRequest, m_order).octet(mode).word(0).take();
}

Packet CommandEncoder::setMta(Address address) const {
    return Fields(Command::SetMta, m_order).word(0).octet(address.extension).dword(address.offset).take();
}

Packet CommandEncoder::upload(std::uint8_t count) const {
    return Fields(Command::Upload, m_order).octet(count).take();
}

Packet CommandEncoder::shortUpload(Address address, std::uint8_t count) const {
    return Fields(Command::ShortUpload, m_order)
        .octet(count)
        .octet(0)
        .octet(address.extension)
        .dword(address.offset)
        .take();
}

Packet CommandEncoder::buildChecksum(std::uint32_t size) const {
    return Fields(Command::BuildChecksum, m_order).octet(0).word(0).dword(size).take();
}

Packet CommandEncoder::userCommand(std::uint8_t sub) const {
    return Fields(Command::UserCommand, m_order).octet(sub).take();
}

Packet CommandEncoder::download(Octets data) const {
    HB_ASSERT(data.size() <= 255);
    return Fields(Command::Download, m_order)
        .octet(static_cast<std::uint8_t>(data.size()))
        .octets(data)
        .take();
}

Packet CommandEncoder::shortDownload(Address address, Octets data) const {
    HB_ASSERT(data.size() <= 247);
    return Fields(Command::ShortDownload, m_order)
        .octet(static_cast<std::uint8_t>(data.size()))
        .octet(0)
        .octet(address.extension)
        .dword(address.offset)
        .octets(data)
        .take();
}

Packet CommandEncoder::setCalPage(std::uint8_t access, std::uint8_t segment, std::uint8_t page) const {
    return Fields(Command::SetCalPage, m_order).octet(access).octet(segment).octet(page).take();
}

Packet CommandEncoder::getCalPage(PageAccess access, std::uint8_t segment) const {
    return Fields(Command::GetCalPage, m_order)
        .octet(static_cast<std::uint8_t>(access))
        .octet(segment)
        .take();
}

Packet CommandEncoder::copyCalPage(std::uint8_t segment, std::uint8_t from, std::uint8_t to) const {
    return Fields(Command::CopyCalPage, m_order).octet(segment).octet(from).octet(segment).octet(to).take();
}

Packet CommandEncoder::allocDaq(std::uint16_t count) const {
    return Fields(Command::AllocDaq, m_order).octet(0).word(count).take();
}

Packet CommandEncoder::allocOdt(std::uint16_t list, std::uint8_t count) const {
    return Fields(Command::AllocOdt, m_order).octet(0).word(list).octet(count).take();
}

Packet CommandEncoder::allocOdtEntry(std::uint16_t list, std::uint8_t odt, std::uint8_t count) const {
    return Fields(Command::AllocOdtEntry, m_order).octet(0).word(list).octet(odt).octet(count).take();
}

Packet CommandEncoder::setDaqPtr(std::uint16_t list, std::uint8_t odt, std::uint8_t entry) const {
    return Fields(Command::SetDaqPtr, m_order).octet(0).word(list).octet(odt).octet(entry).take();
}

Packet CommandEncoder::writeDaq(Address address, std::uint8_t size) const {
    return Fields(Command::WriteDaq, m_order)
        .octet(0xFF)
        .octet(size)
        .octet(address.extension)
        .dword(address.offset)
        .take();
}

Packet CommandEncoder::setDaqListMode(std::uint8_t mode, std::uint16_t list, std::uint16_t event,
                                      std::uint8_t prescaler) const {
    return Fields(Command::SetDaqListMode, m_order)
        .octet(mode)
        .word(list)
        .word(event)
        .octet(prescaler)
        .octet(0)
        .take();
}

Packet CommandEncoder::startStopDaqList(std::uint8_t mode, std::uint16_t list) const {
    return Fields(Command::StartStopDaqList, m_order).octet(mode).word(list).take();
}

Packet CommandEncoder::startStopSynch(std::uint8_t mode) const {
    return Fields(Command::StartStopSynch, m_order).octet(mode).take();
}

Packet CommandEncoder::getDaqEventInfo(std::uint16_t event) const {
    return Fields(Command::GetDaqEventInfo, m_order).octet(0).word(event).take();
}

} // namespace halbench::devices::xcp
