#include "devices/device_uri.h"
#include "devices/simulated/registry/simulated_device.h"
#include "tests/devices/firmware/mps2/emulator/served_mps2_board.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>

// usage: mps2_serve sim:NAME?KEY=VALUE&... PROGRAM.elf
// Prints "listening serial:/dev/pts/N" and runs the program beside the physics of that simulated device until
// it is interrupted.

namespace {

using namespace halbench;

std::atomic<int> Ending{0};

void end(int) {
    Ending = 1;
}

/// The physics of a simulated device, whose own board rests.
class PhysicsOf : public devices::Plant {
public:
    explicit PhysicsOf(std::unique_ptr<devices::SimulatedBoard> board) : m_board(std::move(board)) {}
    void read(std::span<float> readings) override { m_board->plant().read(readings); }
    void drive(std::span<const float> outputs) override { m_board->plant().drive(outputs); }
    void advance(int subSteps) override { m_board->plant().advance(subSteps); }
    hb_signal_table truth() const override { return m_board->plant().truth(); }

private:
    std::unique_ptr<devices::SimulatedBoard> m_board;
};

/// As the board's port.c has them.
std::optional<mps2::PlantLine> plantLineOf(const std::string& name) {
    if (name == "planar") {
        return mps2::PlantLine{12, 0, 6, 4};
    }
    if (name == "spherical") {
        return mps2::PlantLine{9, 2, 0, 4};
    }
    return std::nullopt;
}

Result<std::unique_ptr<firmware::BoardLine>> serve(const std::string& address, const std::string& program) {
    const auto uri = devices::parseDeviceUri(address);
    if (!uri) {
        return failure(uri.error());
    }
    const auto line = plantLineOf(uri->address);
    if (!line) {
        return failure(ErrorCode::UnknownName, fmt::format("'{}' has no board for this processor", address),
                       "Use sim:planar or sim:spherical.");
    }
    auto physics = devices::makeSimulatedBoard(*uri, {});
    if (!physics) {
        return failure(physics.error());
    }
    auto board = mps2::Mps2Board::make(program, std::make_unique<PhysicsOf>(std::move(*physics)), *line);
    if (!board) {
        return failure(board.error());
    }
    return firmware::BoardLine::open(
        std::make_shared<mps2::ServedMps2Board>(std::shared_ptr<mps2::Mps2Board>(std::move(*board))));
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        fmt::print(stderr, "usage: mps2_serve sim:NAME PROGRAM.elf\n");
        return 2;
    }
    const auto line = serve(arguments[1], arguments[2]);
    if (!line) {
        fmt::print(stderr, "{} {}\n", line.error().message, line.error().hint);
        return 1;
    }
    std::signal(SIGINT, &end);
    std::signal(SIGTERM, &end);
    fmt::print("listening serial:{}\n", (*line)->path());
    std::fflush(stdout);
    (*line)->serve(Ending);
    return 0;
}
