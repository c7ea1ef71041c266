// MDF4 recordings: any octets. What was read must come back the same after writing.
#include "devices/formats/mdf4_reader.h"
#include "devices/formats/mdf4_writer.h"

#include <QtCore/QBuffer>

#include <bit>
#include <cmath>

using namespace halbench;
using namespace halbench::devices;

namespace {

void require(bool isTrue) {
    if (!isTrue) {
        __builtin_trap();
    }
}

bool isSame(double read, double written) {
    return std::isnan(written) ? std::isnan(read)
                               : std::bit_cast<std::uint64_t>(read) == std::bit_cast<std::uint64_t>(written);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto file = parseMdf4({reinterpret_cast<const char*>(data), size}, "fuzz.mf4");
    if (!file) {
        require(file.error().message.find("block ") != std::string::npos && !file.error().hint.empty());
        return 0;
    }
    const Recording& recording = file->recording;
    QBuffer buffer;
    buffer.open(QIODevice::ReadWrite);
    Mdf4Writer writer(buffer, file->meta);
    require(writer.begin(*recording.layout) &&
            writer.append({recording.layout, recording.time_s, recording.values, 0.0, 0}) && writer.finish());
    const std::string octets = buffer.data().toStdString();
    const auto again = parseMdf4(octets, "again.mf4");
    require(again.has_value() && again->recording.time_s == recording.time_s);
    require(again->recording.values.size() == recording.values.size());
    for (std::size_t i = 0; i < recording.values.size(); ++i) {
        require(isSame(again->recording.values[i], recording.values[i]));
    }
    return 0;
}
