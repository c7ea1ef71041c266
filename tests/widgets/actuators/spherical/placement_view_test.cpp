#include "control/base/units.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/actuators/spherical/placement_view.h"

#include <QtTest/QTest>

#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

class PlacementViewTest : public GuiTest {
protected:
    PlacementViewTest() {
        view.resize(400, 400);
        view.setSight(0.0, 0.0); // along X: Y to the right, Z upwards
        QObject::connect(&view, &PlacementView::sensorMoved, &view,
                         [this](std::size_t sensor, const Eigen::Vector3d& direction) {
                             moved = {sensor, direction};
                             auto sensors = view.sensors();
                             sensors[sensor].place_m = sensors[sensor].place_m.norm() * direction;
                             view.setSensors(sensors);
                         });
        view.show();
    }
    void drag(const QPointF& from, const QPointF& to) {
        QTest::mousePress(&view, Qt::LeftButton, {}, from.toPoint());
        QMouseEvent event(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&view, &event);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, to.toPoint());
    }

    PlacementView view;
    std::pair<std::size_t, Eigen::Vector3d> moved{9, Eigen::Vector3d::Zero()};
};

// Half a radius to the right of the middle is asin(1/2) = 30 degrees from X towards Y. A pixel is 0.5
// degrees.
TEST_F(PlacementViewTest, sensorFollowsTheMouseOverTheSphere) {
    const QPointF main = view.placeOf(view.sensors()[0].place_m);
    EXPECT_NEAR(main.x(), 200.0, 1e-9);
    EXPECT_NEAR(main.y(), 200.0, 1e-9);
    const QPointF edge = view.placeOf({0.0, 0.05, 0.0});
    drag(main, {200.0 + 0.5 * (edge.x() - 200.0), 200.0});
    EXPECT_EQ(moved.first, 0U);
    EXPECT_NEAR(std::atan2(moved.second.y(), moved.second.x()), Pi / 6.0, 0.01);
    EXPECT_NEAR(moved.second.z(), 0.0, 1e-9);
    EXPECT_NEAR(moved.second.norm(), 1.0, 1e-12);
}

TEST_F(PlacementViewTest, outsideTheSphereTheSensorStaysOnItsEdge) {
    drag(view.placeOf(view.sensors()[0].place_m), {399.0, 200.0});
    EXPECT_NEAR(moved.second.y(), 1.0, 1e-9);
}

TEST_F(PlacementViewTest, sensorBehindTheRotorStaysBehind) {
    auto sensors = view.sensors();
    sensors[2].place_m = {-0.03, 0.0, 0.04};
    view.setSensors(sensors);
    const QPointF at = view.placeOf(sensors[2].place_m);
    drag(at, at + QPointF(20.0, 0.0));
    EXPECT_EQ(moved.first, 2U);
    EXPECT_LT(moved.second.x(), 0.0);
    EXPECT_GT(moved.second.y(), 0.1);
}

TEST_F(PlacementViewTest, dragBesideTheSensorsTurnsTheView) {
    const QPointF before = view.placeOf({0.0, 0.0, 0.05});
    drag({200.0, 330.0}, {200.0, 380.0});
    EXPECT_EQ(moved.first, 9U) << "no sensor";
    EXPECT_NE(view.placeOf({0.0, 0.0, 0.05}), before);
}

TEST_F(PlacementViewTest, keysChooseAndMove) {
    QTest::keyClick(&view, Qt::Key_1);
    EXPECT_EQ(view.chosen(), 1U);
    QTest::keyClick(&view, Qt::Key_Down);
    EXPECT_EQ(moved.first, 1U);
    EXPECT_NEAR(std::asin(moved.second.z()), -Pi / 180.0, 1e-9);
    const QPointF before = view.placeOf({0.0, 0.05, 0.0});
    QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_NE(view.placeOf({0.0, 0.05, 0.0}), before) << "Shift turns the view";
}

} // namespace
} // namespace halbench::widgets
