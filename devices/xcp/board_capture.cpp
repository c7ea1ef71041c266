#include "devices/xcp/board_capture.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices::xcp {

namespace {

constexpr std::size_t Channels = 4;
constexpr std::uint32_t HandleStride = 8; // addresses of measurements, 3.13
constexpr double LoopPeriod_s = 1e-3;     // one tick of the fast loop
constexpr std::size_t PieceRows = 64;     // a tenth of a second at 115200 Bd
constexpr const char* StateName = "capture.state";
constexpr const char* TimeName = "capture.time";
constexpr const char* DataName = "capture.data";

const A2lMeasurement* measurementOf(const BoardDescription& board, double handle) {
    const Address address{static_cast<std::uint32_t>(handle) * HandleStride, 0};
    for (const A2lMeasurement& measurement : board.a2l().measurements) {
        if (measurement.address == address) {
            return &measurement;
        }
    }
    return nullptr;
}

Result<bool> isFull(Device& device, const BoardDescription& board) {
    const std::string name = StateName;
    const Result<std::vector<double>> state = device.readSignals({&name, 1});
    if (!state) {
        return failure(state.error());
    }
    const auto& words = board.measurement(name)->conversion.words;
    const auto word = words.find(static_cast<std::int64_t>((*state)[0]));
    return word != words.end() && word->second == "full";
}

} // namespace

Result<BoardCapture::Settings> BoardCapture::readSettings(Device& device, const BoardDescription& board) {
    std::vector<std::string> names = {"capture.prescaler", "capture.pretrigger"};
    for (std::size_t channel = 1; channel <= Channels; ++channel) {
        names.push_back(fmt::format("capture.signal_{}", channel));
    }
    const Result<std::vector<double>> values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    Settings settings;
    settings.period_s = (*values)[0] * LoopPeriod_s;
    settings.pretrigger = (*values)[1];
    for (std::size_t channel = 0; channel < Channels; ++channel) {
        if (const A2lMeasurement* signal = measurementOf(board, (*values)[2 + channel])) {
            settings.channels.emplace_back(channel, signal);
        }
    }
    if (board.measurement(TimeName) != nullptr) {
        const std::string name = TimeName;
        const Result<std::vector<double>> time = device.readSignals({&name, 1});
        if (!time) {
            return failure(time.error());
        }
        settings.time_s = time->front();
    }
    return settings;
}

void BoardCapture::begin(Settings settings) {
    m_settings = std::move(settings);
    StreamLayout layout;
    layout.period_s = m_settings.period_s;
    for (const auto& [channel, signal] : m_settings.channels) {
        layout.columns.push_back({signal->name, signal->conversion.unit});
    }
    m_recording = {};
    m_recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
}

/// The data lie signal after signal.
Result<void> BoardCapture::readRows(const A2lCharacteristic& data, XcpMaster& master) {
    const std::size_t size = sizeOf(data.type);
    const std::size_t samples = data.count / Channels;
    const std::size_t first = m_recording.rows();
    const std::size_t count = std::min(PieceRows, samples - first);
    const std::size_t width = m_settings.channels.size();
    std::vector<double> values(count * width);
    for (std::size_t column = 0; column < width; ++column) {
        const auto& [channel, signal] = m_settings.channels[column];
        const std::size_t place = (channel * samples + first) * size;
        const Result<Packet> octets = master.read(
            {data.address.offset + static_cast<std::uint32_t>(place), data.address.extension}, count * size);
        if (!octets) {
            return failure(octets.error());
        }
        for (std::size_t row = 0; row < count; ++row) {
            values[row * width + column] =
                decodeRaw(Octets(*octets).subspan(row * size, size), data.type, master.session().order);
        }
    }
    m_recording.values.insert(m_recording.values.end(), values.begin(), values.end());
    for (std::size_t row = first; row < first + count; ++row) {
        m_recording.time_s.push_back((static_cast<double>(row) - m_settings.pretrigger) *
                                     m_settings.period_s);
    }
    return {};
}

Result<Recording> BoardCapture::read(Device& device, const BoardDescription& board, XcpMaster& master) {
    const A2lCharacteristic* data = board.characteristic(DataName);
    if (data == nullptr || board.measurement(StateName) == nullptr) {
        return failure(ErrorCode::DeviceRefused, "this device has no capture function",
                       "record a stream instead");
    }
    const Result<bool> full = isFull(device, board);
    if (!full) {
        return failure(full.error());
    }
    if (!*full) {
        m_recording = {};
        return Recording{};
    }
    Result<Settings> settings = readSettings(device, board);
    if (!settings) {
        return failure(settings.error());
    }
    if (!m_recording.layout || !(m_settings == *settings)) {
        begin(*std::move(settings));
    }
    if (const Result<void> done = readRows(*data, master); !done) {
        return failure(done.error());
    }
    return m_recording.rows() < data->count / Channels ? Recording{} : std::exchange(m_recording, {});
}

} // namespace halbench::devices::xcp
