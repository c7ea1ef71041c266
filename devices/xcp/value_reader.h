#pragma once

#include "devices/xcp/board_description.h"
#include "devices/xcp/xcp_master.h"

#include <span>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

/// The physical value of a raw one. A 4-octet float stands for the shortest decimal that gives it (0.1, not
/// 0.10000000149011612).
double physicalOf(Octets octets, const A2lObject& object, ByteOrder order);
/// True when the object begins where the previous one ends.
bool follows(const A2lObject& object, const A2lObject& previous);
/// The error of a parameter that the board does not have.
Error unknownParameter(const std::string& name);

/// Reads of parameters and signals of a board, by name; values that lie next to each other come with one
/// command. Both arguments outlive it. Thread: the connection's.
class ValueReader {
public:
    ValueReader(XcpMaster& master, const BoardDescription& board) : m_master(&master), m_board(&board) {}

    /// Errors: UnknownName, those of the link.
    Result<std::vector<double>> readParameters(std::span<const std::string> names) const;
    Result<std::vector<double>> readSignals(std::span<const std::string> names) const;
    Result<std::vector<double>> readObjects(const std::vector<const A2lObject*>& objects) const;

private:
    XcpMaster* m_master;
    const BoardDescription* m_board;
};

} // namespace halbench::devices::xcp
