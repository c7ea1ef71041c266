// The platen's picture against the frame it has to fit in: 8 ms at 1600 x 900.
#include "control/base/units.h"
#include "tests/bench/goal.h"
#include "widgets/actuators/planar/platen_view.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>
#include <QImage>

#include <cmath>
#include <map>
#include <string>

namespace halbench::bench {
namespace {

using namespace widgets;

/// The platen on a circle, under changing currents.
class Machine {
public:
    Machine() {
        parameters = {{"hb.mode", 2.0},
                      {"window.x", 0.05},
                      {"window.y", 0.05},
                      {"window.phi", 0.03},
                      {"window.position_enabled", 1.0}};
    }
    void turn() {
        m_angle_rad += 0.05;
        const double x_m = 0.04 * std::cos(m_angle_rad);
        const double y_m = 0.04 * std::sin(m_angle_rad);
        for (const char* pose : {"position", "reference", "truth.position"}) {
            signals[std::string(pose) + ".x"] = x_m;
            signals[std::string(pose) + ".y"] = y_m;
            signals[std::string(pose) + ".phi"] = 0.01 * std::sin(3.0 * m_angle_rad);
        }
        signals["reference.x"] += 5e-6 * std::sin(20.0 * m_angle_rad);
        signals["status"] = m_angle_rad > 0.06 ? 1.0 : 0.0;
        for (int k = 1; k <= 6; ++k) {
            signals["current.coil" + std::to_string(k)] = std::sin(m_angle_rad + k);
            signals["coil_temperature.coil" + std::to_string(k)] = 40.0 + k;
        }
        for (int j = 1; j <= 3; ++j) {
            signals["hall.x" + std::to_string(j)] = 0.02 * std::cos(m_angle_rad + j);
            signals["hall.y" + std::to_string(j)] = 0.02 * std::sin(m_angle_rad + j);
        }
    }
    ActuatorValues values() const { return {finding(signals), finding(parameters)}; }

    std::map<std::string, double> signals;
    std::map<std::string, double> parameters;

private:
    static std::function<std::optional<double>(const std::string&)>
    finding(const std::map<std::string, double>& table) {
        return [&table](const std::string& role) -> std::optional<double> {
            const auto found = table.find(role);
            return found == table.end() ? std::nullopt : std::optional(found->second);
        };
    }

    double m_angle_rad = 0.0;
};

double frame_s(PlatenView& view, double ratio) {
    QImage image(QSize(1600, 900) * ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    Machine machine;
    view.clear();
    view.showSettings(machine.values());
    for (int i = 0; i < 6000; ++i) { // a path as long as it gets
        machine.turn();
        view.showSamples(machine.values());
    }
    return processorTime_s(
        [&] {
            machine.turn();
            view.showSamples(machine.values());
            view.render(&image);
        },
        60);
}

void benchFrames(Goals& goals) {
    PlatenView view;
    view.resize(1600, 900);
    goals.below("platen at 1600 x 900", frame_s(view, 1.0) * 1e3, 8.0, "ms");
    view.setFollowing(true); // a new map every frame
    goals.below("platen at 1600 x 900, followed", frame_s(view, 1.0) * 1e3, 16.0, "ms");
    view.zoom(6.0, {600.0, 450.0});
    goals.below("platen at 1600 x 900, followed, 6 times as large", frame_s(view, 1.0) * 1e3, 16.0, "ms");
    view.setFollowing(false);
    view.fit();
    goals.below("platen at 1600 x 900, 2x", frame_s(view, 2.0) * 1e3, 32.0, "ms"); // four times the pixels
}

} // namespace
} // namespace halbench::bench

int main() {
    const auto application = halbench::widgets::OffscreenApplication::ensure();
    halbench::bench::Goals goals;
    if (!application) {
        goals.failed("platen", application.error().message);
        return goals.exitCode();
    }
    halbench::widgets::applyTheme(*qApp, halbench::widgets::loadTheme("dark").value());
    halbench::bench::benchFrames(goals);
    return goals.exitCode();
}
