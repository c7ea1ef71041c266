// The rotor's picture against the frame it has to fit in beside the plots.
#include "control/base/units.h"
#include "tests/bench/goal.h"
#include "widgets/actuators/htm/rotor_field_lines.h"
#include "widgets/actuators/htm/rotor_view.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>
#include <QImage>

#include <benchmark/benchmark.h>

#include <cmath>

namespace halbench::bench {
namespace {

using namespace widgets;

constexpr int Side_px = 500;

double repaint_s(RotorView& view, double pixelRatio) {
    QImage image(QSize(Side_px, Side_px) * pixelRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    double angle_rad = 0.0;
    return processorTime_s(
        [&] {
            angle_rad += 0.05; // every frame is a new picture
            view.setAngle(angle_rad);
            view.setCurrents(-3.0 * std::sin(angle_rad), 3.0 * std::cos(angle_rad));
            view.setHall(0.157 * std::cos(angle_rad), 0.157 * std::sin(angle_rad));
            view.render(&image);
        },
        50);
}

void benchRepaint(Goals& goals) {
    RotorView view;
    view.resize(Side_px, Side_px);
    for (const FieldModel model : {FieldModel::Ideal, FieldModel::Segmented, FieldModel::Measured}) {
        view.setFieldModel(model);
        const std::string name = "rotor at 500 x 500, field model " + std::to_string(static_cast<int>(model));
        goals.below(name, repaint_s(view, 1.0) * 1e3, 4.0, "ms");
        goals.below(name + ", 2x", repaint_s(view, 2.0) * 1e3, 16.0, "ms"); // four times the pixels
    }
}

void benchFieldLines(Goals& goals) {
    // Once, when the user asks for them: below what is felt as waiting.
    const double lines_s =
        processorTime_s([] { benchmark::DoNotOptimize(segmentedFieldLines(RotorGeometry{}, 22).data()); }, 5);
    goals.below("field lines of 20 magnets, once", lines_s * 1e3, 100.0, "ms");
}

} // namespace
} // namespace halbench::bench

int main() {
    const auto application = halbench::widgets::OffscreenApplication::ensure();
    halbench::bench::Goals goals;
    if (!application) {
        goals.failed("rotor", application.error().message);
        return goals.exitCode();
    }
    halbench::widgets::applyTheme(*qApp, halbench::widgets::loadTheme("dark").value());
    halbench::bench::benchRepaint(goals);
    halbench::bench::benchFieldLines(goals);
    return goals.exitCode();
}
