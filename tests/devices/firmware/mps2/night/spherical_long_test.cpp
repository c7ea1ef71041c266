#include "tests/devices/firmware/mps2/spherical_bench.h"

#include <fmt/format.h>

namespace halbench::mps2 {
namespace {

// A quarter of a minute of tumbling, in which channels clip and come back, so that the least-squares problem
// is prepared anew again and again; the host's build at the same readings beside it.
TEST(Mps2SphericalNight, aLongTumbleStaysWithTheHostBuildAndWithinTheBudget) {
    constexpr double Duration_s = 15.0;
    constexpr double Budget_instructions = 20000.0;
    std::vector<RotorPlant::Clipping> clippings;
    for (std::uint64_t i = 0; i < 40; ++i) {
        clippings.push_back({i % 9, 300 * i + 100, 300 * i + 200});
        clippings.push_back({(i + 4) % 9, 300 * i + 150, 300 * i + 250});
    }
    const std::vector<std::string> quaternion = {"orientation.w", "orientation.x", "orientation.y",
                                                 "orientation.z"};
    const auto readings = std::make_shared<Readings>();
    const auto tumble = [&](Bench& bench, Recording& recording) {
        std::vector<std::string> names = quaternion;
        names.insert(names.end(), {"integrity", "channels_left_out", "status", "fault"});
        bench.record(names, recording);
        bench.wait(Duration_s);
        bench.device->stopStream();
    };
    Recording board;
    Bench emulated = emulatedBench("spherical", rotorPlant(clippings, readings), SphericalLine);
    ASSERT_TRUE(emulated.device);
    tumble(emulated, board);
    const TickCosts& costs = emulated.emulated->costs();
    fmt::print("{} ticks, longest {:.0f}, mean {:.0f} instructions\n", costs.count, costs.worst_instructions,
               costs.total_instructions / static_cast<double>(costs.count));
    EXPECT_LE(costs.worst_instructions, Budget_instructions);

    Recording host;
    Bench hostBoard = sphericalHostBench(readings);
    ASSERT_TRUE(hostBoard.device);
    tumble(hostBoard, host);
    ASSERT_EQ(board.rows(), host.rows());
    ASSERT_GT(board.rows(), 14900U);
    for (const char* name : {"integrity", "channels_left_out", "status", "fault"}) {
        EXPECT_EQ(board.column(name), host.column(name)) << name;
    }
    // 2e-4 degrees are 3.5e-6 rad, of which a quaternion holds half; the sign of one that turned by half a
    // turn is a rounding's choice.
    std::vector<std::vector<double>> a;
    std::vector<std::vector<double>> b;
    for (const std::string& name : quaternion) {
        a.push_back(board.column(name));
        b.push_back(host.column(name));
    }
    double largest = 0.0;
    for (std::size_t row = 0; row < board.rows(); ++row) {
        double product = 0.0;
        double square = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            product += a[i][row] * b[i][row];
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const double apart = a[i][row] - (product < 0.0 ? -b[i][row] : b[i][row]);
            square += apart * apart;
        }
        largest = std::max(largest, 2.0 * std::sqrt(square));
    }
    fmt::print("largest difference {:.2g} deg\n", largest * 57.29577951308232);
    EXPECT_LT(largest * 57.29577951308232, 2e-4);
}

} // namespace
} // namespace halbench::mps2
