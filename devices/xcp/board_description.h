#pragma once

#include "devices/device.h"
#include "devices/xcp/a2l.h"
#include "devices/xcp/page_transaction.h"
#include "devices/xcp/xcp_master.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

/// The description of a board in the words everything above uses, with the way back to its addresses.
class BoardDescription {
public:
    BoardDescription() = default;
    /// `ability` gives the event rates where the board tells them; the description's own count otherwise.
    BoardDescription(A2lDescription description, const std::optional<DaqAbility>& ability);

    Catalogue& catalogue() { return m_catalogue; }
    const Catalogue& catalogue() const { return m_catalogue; }
    const A2lDescription& a2l() const { return m_a2l; }

    /// Its running page takes no writes: what lies in it can only be read.
    void makeReadOnly(const A2lSegment& segment);

    const A2lMeasurement* measurement(const std::string& name) const;
    const A2lCharacteristic* characteristic(const std::string& name) const;

    /// The segment whose pages can be switched and that holds this parameter.
    const A2lSegment* switchableSegment(const A2lCharacteristic& characteristic) const;
    /// Marks of our boards in that segment (3.16).
    std::optional<TransactionMarks> marks(const A2lSegment& segment) const;
    /// Name of the parameter at a place of a segment; empty if none.
    std::string parameterAt(const A2lSegment& segment, std::uint32_t offset) const;

    /// Events a signal can be sampled on, with their rates in Hz (0 = sporadic).
    std::map<std::uint16_t, double> eventRates(const A2lMeasurement& measurement) const;

private:
    void addSignal(const A2lMeasurement& measurement);
    void addParameter(const A2lCharacteristic& characteristic);
    void nameGroups();

    A2lDescription m_a2l;
    Catalogue m_catalogue;
    std::map<std::uint16_t, double> m_eventRates_Hz;
    std::map<std::string, std::size_t> m_measurements;
    std::map<std::string, std::size_t> m_characteristics;
};

} // namespace halbench::devices::xcp
