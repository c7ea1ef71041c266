#include "devices/xcp/value_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace halbench::devices::xcp {

namespace {

constexpr const char* ListHint = "list the names with: halbench describe DEVICE";

double shortestOf(double raw) {
    char text[32];
    const auto written = std::to_chars(text, text + sizeof text, static_cast<float>(raw));
    double shortest = raw;
    std::from_chars(text, written.ptr, shortest);
    return shortest;
}

} // namespace

double physicalOf(Octets octets, const A2lObject& object, ByteOrder order) {
    const double raw = decodeRaw(octets, object.type, order);
    return object.conversion.toPhysical(
        object.type == DataType::Float32 && std::isfinite(raw) ? shortestOf(raw) : raw);
}

bool follows(const A2lObject& object, const A2lObject& previous) {
    return object.address.extension == previous.address.extension &&
           object.address.offset == previous.address.offset + sizeOf(previous.type);
}

Error unknownParameter(const std::string& name) {
    return {ErrorCode::UnknownName, fmt::format("the device has no parameter '{}'", name), ListHint};
}

Result<std::vector<double>> ValueReader::readObjects(const std::vector<const A2lObject*>& objects) const {
    std::vector<std::size_t> sorted(objects.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
        const Address& left = objects[a]->address;
        const Address& right = objects[b]->address;
        return std::pair(left.extension, left.offset) < std::pair(right.extension, right.offset);
    });
    std::vector<double> values(objects.size());
    const ByteOrder order = m_master->session().order;
    // Values that lie next to each other come with one command.
    for (std::size_t begin = 0; begin < sorted.size();) {
        std::size_t end = begin + 1;
        std::size_t octets = sizeOf(objects[sorted[begin]]->type);
        while (end < sorted.size() && follows(*objects[sorted[end]], *objects[sorted[end - 1]]) &&
               octets + sizeOf(objects[sorted[end]]->type) < m_master->session().maxCto) {
            octets += sizeOf(objects[sorted[end]]->type);
            ++end;
        }
        const Result<Packet> data = m_master->read(objects[sorted[begin]]->address, octets);
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

Result<std::vector<double>> ValueReader::readParameters(std::span<const std::string> names) const {
    std::vector<const A2lObject*> objects;
    for (const std::string& name : names) {
        if (m_board->catalogue().findParameter(name) == nullptr) {
            return failure(unknownParameter(name));
        }
        objects.push_back(m_board->characteristic(name));
    }
    return readObjects(objects);
}

Result<std::vector<double>> ValueReader::readSignals(std::span<const std::string> names) const {
    std::vector<const A2lObject*> objects;
    for (const std::string& name : names) {
        if (m_board->catalogue().findSignal(name) == nullptr) {
            return failure(ErrorCode::UnknownName, fmt::format("the device has no signal '{}'", name),
                           ListHint);
        }
        objects.push_back(m_board->measurement(name));
    }
    return readObjects(objects);
}

} // namespace halbench::devices::xcp
