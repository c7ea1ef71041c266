#include "devices/xcp/parameter_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace halbench::devices::xcp {

namespace {

/// Names that end so are commands: the board may clear them by itself (3.16).
bool isCommandName(const std::string& name) {
    constexpr std::string_view Ending = ".start";
    return name.size() >= Ending.size() &&
           name.compare(name.size() - Ending.size(), Ending.size(), Ending) == 0;
}

/// The board puts it back to 0 when it has done it: what is read back says nothing of what was written.
bool clearsItself(const std::string& name) {
    constexpr std::string_view HomeName = "hb.home";
    constexpr std::string_view PathName = "path.shape"; // taken by the start that follows it
    return isCommandName(name) || name == HomeName || name == PathName;
}

/// A command that is not given twice by mistake (3.15): our boards start once for each of these numbers.
constexpr double FirstOrder = 2.0;
constexpr double LastOrder = 255.0;
constexpr const char* ArmName = "hb.arm"; ///< every board of ours has it

bool takesOrders(const Catalogue& catalogue, const A2lCharacteristic& target) {
    return isCommandName(target.name) && target.type == DataType::UByte && target.lower == 0.0 &&
           target.upper == LastOrder && catalogue.findParameter(ArmName) != nullptr;
}

} // namespace

ParameterWriter::ParameterWriter(XcpMaster& master, XcpLink& link, const BoardDescription& board,
                                 Options options)
    : m_master(&master), m_link(&link), m_board(&board), m_reader(master, board),
      m_options(std::move(options)) {}

Result<std::vector<ParameterWriter::RawChange>>
ParameterWriter::checkedChanges(std::span<const ParameterValue> values) {
    std::vector<RawChange> changes;
    for (const ParameterValue& value : values) {
        const ParameterSpec* spec = m_board->catalogue().findParameter(value.name);
        if (spec == nullptr) {
            return failure(unknownParameter(value.name));
        }
        if (const Result<void> checked = checkParameterValue(*spec, value.value); !checked) {
            return failure(checked.error());
        }
        RawChange change;
        change.target = m_board->characteristic(value.name);
        const bool isOrder = takesOrders(m_board->catalogue(), *change.target);
        const double asked = isOrder && value.value == 1.0 ? nextOrder() : value.value;
        appendRaw(change.octets, change.target->conversion.toRaw(asked), change.target->type,
                  m_master->session().order);
        if (isCommandName(value.name) && value.value != 0.0 &&
            m_master->fitsOneDownload(change.octets.size())) {
            change.command = isOrder ? XcpMaster::Repetition::Known : XcpMaster::Repetition::Unknown;
        }
        changes.push_back(std::move(change));
    }
    return changes;
}

double ParameterWriter::nextOrder() {
    m_lastOrder = m_lastOrder < LastOrder ? m_lastOrder + 1.0 : FirstOrder;
    return m_lastOrder;
}

Result<void> ParameterWriter::write(std::span<const ParameterValue> values) {
    if (Result<void> admitted = checkFirmware(); !admitted) {
        return admitted;
    }
    const Result<std::vector<RawChange>> changes = checkedChanges(values);
    if (!changes) {
        return failure(changes.error());
    }
    std::map<const A2lSegment*, std::vector<RawChange>> transactional;
    std::vector<RawChange> plain;
    for (const RawChange& change : *changes) {
        const A2lSegment* segment = m_board->switchableSegment(*change.target);
        (segment != nullptr ? transactional[segment] : plain).push_back(change);
    }
    for (const auto& [segment, set] : transactional) {
        if (Result<void> done = writeSegment(*segment, set); !done) {
            return done;
        }
    }
    if (Result<void> done = writePlain(plain); !done) {
        return done;
    }
    return readBack(*changes);
}

Result<void> ParameterWriter::writeSegment(const A2lSegment& segment, const std::vector<RawChange>& changes) {
    std::vector<SegmentChange> places;
    places.reserve(changes.size());
    for (const RawChange& change : changes) {
        places.push_back({change.target->address.offset - segment.address.offset, change.octets});
    }
    std::optional<PageMismatch> mismatch;
    Result<void> done = switchPages(*m_master, *m_link, segment, places, m_board->marks(segment), mismatch);
    if (!done && mismatch) {
        return failure(ErrorCode::DeviceRefused,
                       fmt::format("the value of '{}' read back differs from the one sent",
                                   m_board->parameterAt(segment, mismatch->offset)),
                       "the old values are kept; use values within the device limits");
    }
    return done;
}

/// The methods of 3.10 for boards whose pages cannot be switched, best first.
Result<void> ParameterWriter::writePlain(const std::vector<RawChange>& changes) {
    const bool hasPages =
        std::any_of(m_board->a2l().segments.begin(), m_board->a2l().segments.end(),
                    [](const A2lSegment& segment) { return segment.hasTwoWritablePages(); });
    const bool hasCommand = std::any_of(changes.begin(), changes.end(),
                                        [](const RawChange& change) { return change.command.has_value(); });
    if (changes.size() < 2 || hasPages || hasCommand) {
        return writeOneByOne(changes);
    }
    const Result<bool> isWritten = writeAdjacent(changes);
    if (!isWritten) {
        return failure(isWritten.error());
    }
    if (*isWritten) {
        return {};
    }
    if (m_options.useVendorBrackets) {
        if (Result<void> begun = m_master->userCommand(0x01); !begun) {
            return begun;
        }
        Result<void> written = writeOneByOne(changes);
        const Result<void> ended = m_master->userCommand(0x02);
        return written ? ended : written;
    }
    if (!m_hasWarnedOneByOne) {
        m_hasWarnedOneByOne = true;
        m_options.onMessage("this device cannot change a set at once: values change one by one");
    }
    return writeOneByOne(changes);
}

/// True when all values lie next to each other and one command carried them.
Result<bool> ParameterWriter::writeAdjacent(const std::vector<RawChange>& changes) {
    std::vector<const RawChange*> sorted;
    sorted.reserve(changes.size());
    for (const RawChange& change : changes) {
        sorted.push_back(&change);
    }
    std::sort(sorted.begin(), sorted.end(), [](const RawChange* a, const RawChange* b) {
        return a->target->address.offset < b->target->address.offset;
    });
    Packet octets = sorted.front()->octets;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (!follows(*sorted[i]->target, *sorted[i - 1]->target)) {
            return false;
        }
        octets.insert(octets.end(), sorted[i]->octets.begin(), sorted[i]->octets.end());
    }
    if (!m_master->fitsOneDownload(octets.size())) {
        return false;
    }
    const Result<void> written = m_master->writeInOneDownload(sorted.front()->target->address, octets);
    if (!written) {
        return failure(written.error());
    }
    return true;
}

/// When the answer is lost nobody knows whether the motion has begun, and the repetition would begin another:
/// it is ended instead, which may be repeated.
Result<void> ParameterWriter::commandOnce(const RawChange& change) {
    const Result<std::optional<Error>> trouble =
        m_master->writeOnce(change.target->address, change.octets, *change.command);
    if (!trouble) {
        return failure(trouble.error());
    }
    if (!*trouble) {
        return {};
    }
    const Packet end(change.octets.size(), 0);
    if (const Result<void> ended = m_master->write(change.target->address, end); !ended) {
        return failure(ended.error());
    }
    return failure(
        (*trouble)->code == ErrorCode::Interrupted ? ErrorCode::Interrupted : ErrorCode::Protocol,
        fmt::format("{}; ended, because its start was not confirmed", (*trouble)->message),
        "check the position of the actuator, then start again; newer firmware tolerates a lost answer");
}

Result<void> ParameterWriter::writeOneByOne(const std::vector<RawChange>& changes) {
    for (const RawChange& change : changes) {
        const Result<void> written =
            change.command ? commandOnce(change) : m_master->write(change.target->address, change.octets);
        if (!written) {
            Error error = written.error();
            error.message = fmt::format("parameter '{}': {}", change.target->name, error.message);
            return failure(std::move(error));
        }
    }
    return {};
}

Result<void> ParameterWriter::readBack(const std::vector<RawChange>& changes) const {
    std::map<const A2lCharacteristic*, const RawChange*> last; // of a name given twice the later value counts
    for (const RawChange& change : changes) {
        last[change.target] = &change;
    }
    std::vector<const A2lObject*> objects;
    std::vector<const RawChange*> expected;
    for (const auto& [target, change] : last) {
        if (!clearsItself(target->name)) {
            objects.push_back(target);
            expected.push_back(change);
        }
    }
    const Result<std::vector<double>> values = m_reader.readObjects(objects);
    if (!values) {
        return failure(values.error());
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const double sent = physicalOf(expected[i]->octets, *objects[i], m_master->session().order);
        if ((*values)[i] != sent) {
            return failure(ErrorCode::DeviceRefused,
                           fmt::format("value of '{}' after writing: {} {} instead of {}", objects[i]->name,
                                       (*values)[i], objects[i]->conversion.unit, sent),
                           "check the board's state and limits");
        }
    }
    return {};
}

Result<void> ParameterWriter::save() {
    if (Result<void> admitted = checkFirmware(); !admitted) {
        return admitted;
    }
    return m_master->storeCalibration();
}

/// Names lead to addresses: those of another firmware may lead anywhere, so that nothing is written by them.
Result<void> ParameterWriter::checkFirmware() const {
    return m_options.identity->otherFirmware.empty()
               ? Result<void>()
               : failure(ErrorCode::DeviceRefused,
                         "writing is blocked: the description does not match the firmware of the device",
                         "use the description of this firmware, or update the firmware completely");
}

} // namespace halbench::devices::xcp
