#pragma once

#include "tests/devices/firmware/mps2/planar_bench.h"

namespace halbench::mps2 {

inline constexpr double Travel_m = 0.02;

/// A run of the positioner as a master sees it.
struct Motion {
    Recording recording;
    std::size_t switchRow = 0; ///< the first with the new gains
    std::vector<double> parameters;
    std::string ending; ///< of the last wait
};

/// Fails while the platen travels, behind the change of gains.
inline std::vector<PlatenPlant::Failure> chipFailsInMotion() {
    return {{450, 1, models::ChipFault::Dead}};
}

/// Home, a travel along x, new gains in the middle of it as one transaction (later by some ticks), then the
/// tracking filter and currents by the windings, until a chip fails.
inline Motion moved(Bench& bench, int later_ticks) {
    Motion result;
    const double later_s = Mps2Board::Tick_s * later_ticks;
    bench.write({{"hb.home", 1.0}});
    bench.wait(0.01);
    bench.record({"position.x", "position.y", "position.phi", "speed.x", "reference.x", "current.coil1",
                  "current.coil4", "current.coil5", "current.coil6", "status", "fault", "chips_left_out",
                  "cell.x", "torn_count"},
                 result.recording);
    bench.write({{"hb.mode", static_cast<double>(HB_PLANAR_POSITION)}});
    EXPECT_TRUE(bench.device->arm());
    bench.write({{"reference.x.shape", static_cast<double>(HB_PLANAR_TRAPEZOID)},
                 {"reference.x.amplitude", Travel_m},
                 {"reference.x.rate", 0.1},
                 {"reference.x.acceleration", 2.0},
                 {"reference.start", 1.0}});
    bench.wait(0.1 + later_s);
    result.switchRow = result.recording.rows();
    bench.write({{"gain.x.kp", 300.0}, {"gain.x.kd", 20.0}, {"gain.phi.kp", 3.0}});
    bench.wait(0.15 - later_s);
    bench.write({{"coil.allocation", static_cast<double>(HB_ALLOCATION_FULL)}, {"speed.estimator", 1.0}});
    const auto ended = bench.device->clock().waitFor(0.3);
    result.ending = ended ? "" : ended.error().message;
    bench.device->stopStream();
    result.parameters = bench.parameters();
    return result;
}

} // namespace halbench::mps2
