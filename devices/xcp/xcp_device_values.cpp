#include "devices/xcp/xcp_device_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>

namespace halbench::devices::xcp {

namespace {

constexpr const char* ListHint = "list the names with: halbench describe DEVICE";

/// Names that end so are commands: the board may clear them by itself (3.16).
bool isCommandName(const std::string& name) {
    constexpr std::string_view Ending = ".start";
    return name.size() >= Ending.size() &&
           name.compare(name.size() - Ending.size(), Ending.size(), Ending) == 0;
}

/// The board puts it back to 0 when it has done it: what is read back says nothing of what was written.
bool clearsItself(const std::string& name) {
    constexpr std::string_view HomeName = "hb.home";
    return isCommandName(name) || name == HomeName;
}

/// A command that is not given twice by mistake (3.15): our boards start once for each of these numbers.
constexpr double FirstOrder = 2.0;
constexpr double LastOrder = 255.0;
constexpr const char* ArmName = "hb.arm"; ///< every board of ours has it

bool takesOrders(const Catalogue& catalogue, const A2lCharacteristic& target) {
    return isCommandName(target.name) && target.type == DataType::UByte && target.lower == 0.0 &&
           target.upper == LastOrder && catalogue.findParameter(ArmName) != nullptr;
}

/// The number a user wrote: of a 4-octet float the shortest decimal that stands for it (0.1, not
/// 0.10000000149011612).
double shortestOf(double raw) {
    char text[32];
    const auto written = std::to_chars(text, text + sizeof text, static_cast<float>(raw));
    double shortest = raw;
    std::from_chars(text, written.ptr, shortest);
    return shortest;
}

double physicalOf(Octets octets, const A2lObject& object, ByteOrder order) {
    const double raw = decodeRaw(octets, object.type, order);
    return object.conversion.toPhysical(
        object.type == DataType::Float32 && std::isfinite(raw) ? shortestOf(raw) : raw);
}

bool follows(const A2lObject& object, const A2lObject& previous) {
    return object.address.extension == previous.address.extension &&
           object.address.offset == previous.address.offset + sizeOf(previous.type);
}

} // namespace

Result<std::vector<double>> XcpDevice::readObjects(const std::vector<const A2lObject*>& objects) {
    std::vector<std::size_t> sorted(objects.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
        const Address& left = objects[a]->address;
        const Address& right = objects[b]->address;
        return std::pair(left.extension, left.offset) < std::pair(right.extension, right.offset);
    });
    std::vector<double> values(objects.size());
    const ByteOrder order = m_master.session().order;
    // Values that lie next to each other come with one command.
    for (std::size_t begin = 0; begin < sorted.size();) {
        std::size_t end = begin + 1;
        std::size_t octets = sizeOf(objects[sorted[begin]]->type);
        while (end < sorted.size() && follows(*objects[sorted[end]], *objects[sorted[end - 1]]) &&
               octets + sizeOf(objects[sorted[end]]->type) < m_master.session().maxCto) {
            octets += sizeOf(objects[sorted[end]]->type);
            ++end;
        }
        const Result<Packet> data = m_master.read(objects[sorted[begin]]->address, octets);
        if (!data) {
            return failure(data.error());
        }
        std::size_t place = 0;
        for (; begin < end; ++begin) {
            const A2lObject& object = *objects[sorted[begin]];
            values[sorted[begin]] =
                physicalOf(Octets(*data).subspan(place, sizeOf(object.type)), object, order);
            place += sizeOf(object.type);
        }
    }
    return values;
}

Result<std::vector<double>> XcpDevice::readParameters(std::span<const std::string> names) {
    std::vector<const A2lObject*> objects;
    for (const std::string& name : names) {
        if (m_board.catalogue().findParameter(name) == nullptr) {
            return failure(ErrorCode::UnknownName, fmt::format("the device has no parameter '{}'", name),
                           ListHint);
        }
        objects.push_back(m_board.characteristic(name));
    }
    return readObjects(objects);
}

Result<std::vector<double>> XcpDevice::readSignals(std::span<const std::string> names) {
    std::vector<const A2lObject*> objects;
    for (const std::string& name : names) {
        if (m_board.catalogue().findSignal(name) == nullptr) {
            return failure(ErrorCode::UnknownName, fmt::format("the device has no signal '{}'", name),
                           ListHint);
        }
        objects.push_back(m_board.measurement(name));
    }
    return readObjects(objects);
}

Result<std::vector<XcpDevice::RawChange>> XcpDevice::checkedChanges(std::span<const ParameterValue> values) {
    std::vector<RawChange> changes;
    for (const ParameterValue& value : values) {
        const ParameterSpec* spec = m_board.catalogue().findParameter(value.name);
        if (spec == nullptr) {
            return failure(ErrorCode::UnknownName,
                           fmt::format("the device has no parameter '{}'", value.name), ListHint);
        }
        if (const Result<void> checked = checkParameterValue(*spec, value.value); !checked) {
            return failure(checked.error());
        }
        RawChange change;
        change.target = m_board.characteristic(value.name);
        const bool isOrder = takesOrders(m_board.catalogue(), *change.target);
        const double asked = isOrder && value.value == 1.0 ? nextOrder() : value.value;
        appendRaw(change.octets, change.target->conversion.toRaw(asked), change.target->type,
                  m_master.session().order);
        if (isCommandName(value.name) && value.value != 0.0 &&
            m_master.fitsOneDownload(change.octets.size())) {
            change.command = isOrder ? XcpMaster::Repetition::Known : XcpMaster::Repetition::Unknown;
        }
        changes.push_back(std::move(change));
    }
    return changes;
}

double XcpDevice::nextOrder() {
    m_lastOrder = m_lastOrder < LastOrder ? m_lastOrder + 1.0 : FirstOrder;
    return m_lastOrder;
}

Result<void> XcpDevice::writeParameters(std::span<const ParameterValue> values) {
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
        const A2lSegment* segment = m_board.switchableSegment(*change.target);
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

Result<void> XcpDevice::writeSegment(const A2lSegment& segment, const std::vector<RawChange>& changes) {
    std::vector<SegmentChange> places;
    places.reserve(changes.size());
    for (const RawChange& change : changes) {
        places.push_back({change.target->address.offset - segment.address.offset, change.octets});
    }
    std::optional<PageMismatch> mismatch;
    Result<void> done = switchPages(m_master, m_link, segment, places, m_board.marks(segment), mismatch);
    if (!done && mismatch) {
        return failure(ErrorCode::DeviceRefused,
                       fmt::format("the value of '{}' read back differs from the one sent",
                                   m_board.parameterAt(segment, mismatch->offset)),
                       "the old values are kept; use values within the device limits");
    }
    return done;
}

/// The methods of 3.10 for boards whose pages cannot be switched, best first.
Result<void> XcpDevice::writePlain(const std::vector<RawChange>& changes) {
    const bool hasPages =
        std::any_of(m_board.a2l().segments.begin(), m_board.a2l().segments.end(),
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
        if (Result<void> begun = m_master.userCommand(0x01); !begun) {
            return begun;
        }
        Result<void> written = writeOneByOne(changes);
        const Result<void> ended = m_master.userCommand(0x02);
        return written ? ended : written;
    }
    if (!m_hasWarnedOneByOne) {
        m_hasWarnedOneByOne = true;
        message("this device cannot change a set at once: values change one by one");
    }
    return writeOneByOne(changes);
}

/// True when all values lie next to each other and one command carried them.
Result<bool> XcpDevice::writeAdjacent(const std::vector<RawChange>& changes) {
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
    if (!m_master.fitsOneDownload(octets.size())) {
        return false;
    }
    const Result<void> written = m_master.writeInOneDownload(sorted.front()->target->address, octets);
    if (!written) {
        return failure(written.error());
    }
    return true;
}

/// When the answer is lost nobody knows whether the motion has begun, and the repetition would begin another:
/// it is ended instead, which may be repeated.
Result<void> XcpDevice::commandOnce(const RawChange& change) {
    const Result<std::optional<Error>> trouble =
        m_master.writeOnce(change.target->address, change.octets, *change.command);
    if (!trouble) {
        return failure(trouble.error());
    }
    if (!*trouble) {
        return {};
    }
    const Packet end(change.octets.size(), 0);
    if (const Result<void> ended = m_master.write(change.target->address, end); !ended) {
        return failure(ended.error());
    }
    return failure(
        (*trouble)->code == ErrorCode::Interrupted ? ErrorCode::Interrupted : ErrorCode::Protocol,
        fmt::format("{}; ended, because its start was not confirmed", (*trouble)->message),
        "check the position of the actuator, then start again; newer firmware tolerates a lost answer");
}

Result<void> XcpDevice::writeOneByOne(const std::vector<RawChange>& changes) {
    for (const RawChange& change : changes) {
        const Result<void> written =
            change.command ? commandOnce(change) : m_master.write(change.target->address, change.octets);
        if (!written) {
            Error error = written.error();
            error.message = fmt::format("parameter '{}': {}", change.target->name, error.message);
            return failure(std::move(error));
        }
    }
    return {};
}

Result<void> XcpDevice::readBack(const std::vector<RawChange>& changes) {
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
    const Result<std::vector<double>> values = readObjects(objects);
    if (!values) {
        return failure(values.error());
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const double sent = physicalOf(expected[i]->octets, *objects[i], m_master.session().order);
        if ((*values)[i] != sent) {
            return failure(ErrorCode::DeviceRefused,
                           fmt::format("value of '{}' after writing: {} {} instead of {}", objects[i]->name,
                                       (*values)[i], objects[i]->conversion.unit, sent),
                           "check the board's state and limits");
        }
    }
    return {};
}

Result<void> XcpDevice::saveParameters() {
    if (Result<void> admitted = checkFirmware(); !admitted) {
        return admitted;
    }
    return m_master.storeCalibration();
}

/// Names lead to addresses: those of another firmware may lead anywhere, so that nothing is written by them.
Result<void> XcpDevice::checkFirmware() const {
    return m_options.identity.otherFirmware.empty()
               ? Result<void>()
               : failure(ErrorCode::DeviceRefused,
                         "writing is blocked: the description does not match the firmware of the device",
                         "use the description of this firmware, or update the firmware completely");
}

} // namespace halbench::devices::xcp
