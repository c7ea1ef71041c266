#include "devices/xcp/board_capture.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices::xcp {

namespace {

constexpr std::size_t Channels = 4;
constexpr std::uint32_t HandleStride = 8; // addresses of measurements, 3.13
constexpr double LoopPeriod_s = 1e-3;     // one tick of the fast loop
constexpr const char* StateName = "capture.state";
constexpr const char* DataName = "capture.data";

struct CaptureSettings {
    std::vector<std::pair<std::size_t, const A2lMeasurement*>> channels; ///< place in the data, signal
    double period_s = LoopPeriod_s;
    double pretrigger = 0.0;
};

const A2lMeasurement* measurementOf(const BoardDescription& board, double handle) {
    const Address address{static_cast<std::uint32_t>(handle) * HandleStride, 0};
    for (const A2lMeasurement& measurement : board.a2l().measurements) {
        if (measurement.address == address) {
            return &measurement;
        }
    }
    return nullptr;
}

Result<CaptureSettings> readSettings(Device& device, const BoardDescription& board) {
    std::vector<std::string> names = {"capture.prescaler", "capture.pretrigger"};
    for (std::size_t channel = 1; channel <= Channels; ++channel) {
        names.push_back(fmt::format("capture.signal_{}", channel));
    }
    const Result<std::vector<double>> values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    CaptureSettings settings;
    settings.period_s = (*values)[0] * LoopPeriod_s;
    settings.pretrigger = (*values)[1];
    for (std::size_t channel = 0; channel < Channels; ++channel) {
        if (const A2lMeasurement* signal = measurementOf(board, (*values)[2 + channel])) {
            settings.channels.emplace_back(channel, signal);
        }
    }
    return settings;
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

Result<Recording> readBoardCapture(Device& device, const BoardDescription& board, XcpMaster& master) {
    const A2lCharacteristic* data = board.characteristic(DataName);
    if (data == nullptr || board.measurement(StateName) == nullptr) {
        return failure(ErrorCode::DeviceRefused, "this board cannot capture by itself",
                       "record a stream instead");
    }
    const Result<bool> full = isFull(device, board);
    if (!full) {
        return failure(full.error());
    }
    if (!*full) {
        return Recording{};
    }
    const Result<CaptureSettings> settings = readSettings(device, board);
    if (!settings) {
        return failure(settings.error());
    }
    const std::size_t size = sizeOf(data->type);
    const std::size_t samples = data->count / Channels;
    const Result<Packet> octets = master.read(data->address, size * data->count);
    if (!octets) {
        return failure(octets.error());
    }
    StreamLayout layout;
    layout.period_s = settings->period_s;
    for (const auto& [channel, signal] : settings->channels) {
        layout.columns.push_back({signal->name, signal->conversion.unit});
    }
    Recording recording;
    for (std::size_t row = 0; row < samples; ++row) {
        recording.time_s.push_back((static_cast<double>(row) - settings->pretrigger) * settings->period_s);
        for (const auto& [channel, signal] : settings->channels) {
            const Octets raw = Octets(*octets).subspan((channel * samples + row) * size, size);
            recording.values.push_back(decodeRaw(raw, data->type, master.session().order));
        }
    }
    recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
    return recording;
}

} // namespace halbench::devices::xcp
