// Picture of the spherical rotor against the frame that users feel, and against a bare picture of as many
// patches.
#include "control/base/units.h"
#include "tests/bench/goal.h"
#include "widgets/actuators/spherical/sphere_view.h"
#include "widgets/figure/offscreen_application.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>
#include <QImage>
#include <QPainter>

#include <Eigen/Geometry>
#include <cmath>

namespace halbench::bench {
namespace {

using namespace widgets;

constexpr int Side_px = 500;
constexpr int Rounds = 50;
constexpr int PathFrames = 700; ///< the longest path is drawn
/// Half of 14 bands of 32 sectors is seen.
constexpr int Patches = 224;

QImage imageOf(double pixelRatio) {
    QImage image(QSize(Side_px, Side_px) * pixelRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    return image;
}

/// Another pose every frame, with field, cone, truth and dots of wanted data.
void pose(SphereView& view, double angle_rad) {
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(0.7 * std::sin(0.9 * angle_rad), Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(0.7 * std::cos(1.1 * angle_rad), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    std::array<double, 9> readings_T{};
    for (std::size_t i = 0; i < readings_T.size(); ++i) {
        readings_T[i] = 0.2 * std::sin(angle_rad + static_cast<double>(i));
    }
    view.setReadings(readings_T);
    view.setOrientation(rotation, 0.03, SphereVerdict::Fresh);
    view.setTruth(rotation);
}

double frame_s(SphereView& view, double pixelRatio) {
    QImage image = imageOf(pixelRatio);
    double angle_rad = 0.0;
    return processorTime_s(
        [&] {
            angle_rad += 0.05;
            pose(view, angle_rad);
            view.render(&image);
        },
        Rounds);
}

/// As many filled patches that cover as much, without anything to compute.
double barePatches_s(double pixelRatio) {
    QImage image = imageOf(pixelRatio);
    return processorTime_s(
        [&] {
            QPainter painter(&image);
            painter.fillRect(0, 0, Side_px, Side_px, Qt::black);
            const double side_px = Side_px / 1.72 / 2.0 * std::sqrt(Pi / Patches);
            for (int i = 0; i < Patches; ++i) {
                const QPointF at(100.0 + side_px * (i % 15), 100.0 + side_px * (i / 15));
                const QColor colour(i, 255 - i, 128);
                painter.setPen(colour);
                painter.setBrush(colour);
                QPolygonF patch;
                patch << at << at + QPointF(side_px, 1.0) << at + QPointF(side_px, side_px)
                      << at + QPointF(1.0, side_px);
                painter.drawPolygon(patch);
            }
        },
        Rounds);
}

void benchFrame(Goals& goals) {
    SphereView view;
    view.resize(Side_px, Side_px);
    std::vector<SphereWanted> wanted;
    for (int i = 0; i < 25; ++i) {
        const double phi_rad = 0.25 * i;
        wanted.push_back({{0.5 * std::cos(phi_rad), 0.5 * std::sin(phi_rad), 0.87}, 0.04 * i});
    }
    view.setWanted(wanted);
    for (int frame = 0; frame < PathFrames; ++frame) {
        pose(view, 0.05 * frame);
    }
    const double single_s = frame_s(view, 1.0);
    goals.below("sphere at 500 x 500", single_s * 1e3, 8.0, "ms");
    goals.below("sphere at 500 x 500, 2x", frame_s(view, 2.0) * 1e3, 32.0, "ms"); // four times the pixels
    // Projection, axes, path, sensors, cone and words may cost twice as much as the patches of the rotor.
    goals.below("sphere against bare patches", single_s / barePatches_s(1.0), 3.0, "times");
}

} // namespace
} // namespace halbench::bench

int main() {
    const auto application = halbench::widgets::OffscreenApplication::ensure();
    halbench::bench::Goals goals;
    if (!application) {
        goals.failed("sphere", application.error().message);
        return goals.exitCode();
    }
    halbench::widgets::applyTheme(*qApp, halbench::widgets::loadTheme("dark").value());
    halbench::bench::benchFrame(goals);
    return goals.exitCode();
}
