#include "app/workbench/piecewise_reading.h"

#include <algorithm>
#include <memory>

namespace halbench::app {

namespace {

/// Values read at once: a stop waits for no more than one job.
constexpr std::size_t PieceSize = 12;

Result<void> readPiece(devices::Device& device, const std::vector<std::string>& names, DeviceValues& all) {
    if (!all) {
        return {}; // a piece before has failed
    }
    const DeviceValues piece = device.readParameters(names);
    if (piece) {
        all->insert(all->end(), piece->begin(), piece->end());
    } else {
        all = piece;
    }
    return {};
}

} // namespace

void readInPieces(DeviceSession& session, const std::vector<std::string>& names,
                  const std::function<void(const DeviceValues&)>& then) {
    const auto all = std::make_shared<DeviceValues>(std::vector<double>());
    if (names.empty()) {
        then(*all);
    }
    for (std::size_t begin = 0; begin < names.size(); begin += PieceSize) {
        const std::size_t end = std::min(begin + PieceSize, names.size());
        const std::vector<std::string> piece(names.begin() + static_cast<std::ptrdiff_t>(begin),
                                             names.begin() + static_cast<std::ptrdiff_t>(end));
        const bool isLast = end == names.size();
        session.request([piece, all](devices::Device& device) { return readPiece(device, piece, *all); },
                        [all, then, isLast](const Result<void>& done) {
                            if (isLast) {
                                then(done ? *all : DeviceValues(failure(done.error())));
                            }
                        });
    }
}

} // namespace halbench::app
