#pragma once

#include "control/base/random.h"
#include "control/base/units.h"
#include "control/history/sample_history.h"
#include "tests/control/history/history_blocks.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <cmath>

namespace halbench::widgets {

/// A motor that turns to and fro: two Halls, angle, speed, current, two temperatures at 1 kHz.
inline void appendMotor(control::SampleHistory& history, double seconds) {
    const auto layout = control::layoutOf(
        {"hall.a", "hall.b", "angle", "speed", "current", "temperature.a", "temperature.b"}, 0.001);
    Random random(3);
    const auto rows = static_cast<std::size_t>(seconds * 1000.0);
    for (std::size_t first = 0; first < rows; first += 100) {
        history.append(control::blockOf(layout, first, 100, [&](std::size_t row, std::size_t column) {
            const double t = 0.001 * static_cast<double>(row);
            const double angle = 2.5 * std::sin(2.0 * t) + 0.4 * std::sin(9.0 * t);
            switch (column) {
            case 0:
                return 0.08 * std::cos(angle) + 2e-4 * random.gaussian();
            case 1:
                return 0.08 * std::sin(angle) + 2e-4 * random.gaussian();
            case 2:
                return angle;
            case 3:
                return 5.0 * std::cos(2.0 * t) + 3.6 * std::cos(9.0 * t) + 0.1 * random.gaussian();
            case 4:
                return std::fmod(t, 2.0) < 1.0 ? 0.31 : -0.31;
            case 5:
                return 62.0 + 3.0 * std::sin(0.2 * t) + 0.02 * random.gaussian();
            default:
                return 58.0 + 3.0 * std::sin(0.2 * t - 0.4) + 0.02 * random.gaussian();
            }
        }));
    }
}

inline std::vector<PlotSpec> motorPlots() {
    const auto curve = [](const char* signal, const char* label, const char* unit, double factor,
                          int decimals) {
        return PlotCurve{signal, QString::fromUtf8(label), QString::fromUtf8(unit), factor, decimals};
    };
    return {{"Hall field",
             "mT",
             {curve("hall.a", "Hall A", "mT", 1e3, 2), curve("hall.b", "Hall B", "mT", 1e3, 2)},
             {},
             {}},
            {"angle", "°", {curve("angle", "Angle", "°", 180.0 / Pi, 2)}, {}, {}},
            {"speed", "r/min", {curve("speed", "Speed", "r/min", 30.0 / Pi, 1)}, {}, {}},
            {"current", "A", {curve("current", "q-axis current command", "A", 1.0, 3)}, {}, {}},
            {"coil temperature",
             "°C",
             {curve("temperature.a", "Coil A", "°C", 1.0, 1), curve("temperature.b", "Coil B", "°C", 1.0, 1)},
             {{65.0, 70.0, LimitBand::Role::Warn}, {70.0, INFINITY, LimitBand::Role::Bad}},
             {}}};
}

} // namespace halbench::widgets
