#include "tests/widgets/gui_fixture.h"
#include "widgets/actuators/planar/platen_view.h"

#include <QAction>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QtTest/QTest>

#include <map>
#include <string>

namespace halbench::widgets {
namespace {

class PlatenViewTest : public GuiTest {
protected:
    void SetUp() override {
        GuiTest::SetUp();
        view = std::make_unique<PlatenView>();
        view->resize(900, 600);
        for (int k = 1; k <= 6; ++k) {
            signals["current.coil" + std::to_string(k)] = 0.0;
            signals["coil_temperature.coil" + std::to_string(k)] = 25.0;
        }
        for (int j = 1; j <= 3; ++j) {
            signals["hall.x" + std::to_string(j)] = 0.0;
            signals["hall.y" + std::to_string(j)] = 0.0;
        }
        place("position", 0.0, 0.0);
    }
    void TearDown() override { view.reset(); }

    void place(const std::string& role, double x_m, double y_m) {
        signals[role + ".x"] = x_m;
        signals[role + ".y"] = y_m;
        signals[role + ".phi"] = 0.0;
    }
    void show() {
        const auto find = [](const std::map<std::string, double>& table) {
            return [&table](const std::string& role) -> std::optional<double> {
                const auto found = table.find(role);
                return found == table.end() ? std::nullopt : std::optional(found->second);
            };
        };
        const ActuatorValues values{find(signals), find(parameters)};
        view->showSettings(values);
        view->showSamples(values);
    }
    QImage drawn() { return view->grab().toImage(); }
    MapScale scale() const {
        return view->scale(platenLayout(view->size(), QFontMetricsF(tabularFont(view->font()))).map);
    }
    static double distance_px(const QPointF& one, const QPointF& other) {
        return std::hypot(one.x() - other.x(), one.y() - other.y());
    }

    std::unique_ptr<PlatenView> view;
    std::map<std::string, double> signals;
    std::map<std::string, double> parameters;
};

TEST_F(PlatenViewTest, poseAndItsAbsenceAreSaidInWords) {
    EXPECT_EQ(view->accessibleName(), "Platen over the magnet matrix");
    EXPECT_TRUE(view->accessibleDescription().contains("not known"));
    place("position", 6.35e-3, -12.0e-3);
    show();
    EXPECT_TRUE(view->accessibleDescription().contains("x 6.3 mm, y -12.0 mm") ||
                view->accessibleDescription().contains("x 6.4 mm, y -12.0 mm")); // a tie of rounding
    view->setStale(true);
    EXPECT_TRUE(view->accessibleDescription().contains("old values"));
    view->clear();
    EXPECT_TRUE(view->accessibleDescription().contains("not known"));
}

TEST_F(PlatenViewTest, zoomLeavesThePlaceUnderThePointer) {
    const QPointF pointer(300.0, 200.0);
    const Eigen::Vector2d before_m = scale().placeOf_m(pointer);
    view->zoom(5.0, pointer);
    EXPECT_LT(distance_px(scale().at(before_m), pointer), 1e-6); // rounding
    view->zoom(1e-3, pointer);                                   // never smaller than the whole matrix
    const double whole = scale().pixels_per_m;
    view->fit();
    EXPECT_DOUBLE_EQ(scale().pixels_per_m, whole);
}

TEST_F(PlatenViewTest, keysZoomMoveAndShowAll) {
    const MapScale first = scale();
    QTest::keyClick(view.get(), Qt::Key_Plus);
    EXPECT_GT(scale().pixels_per_m, first.pixels_per_m);
    QTest::keyClick(view.get(), Qt::Key_Right); // the view moves right, the map left
    EXPECT_LT(scale().origin_px.x(), first.origin_px.x());
    QTest::keyClick(view.get(), Qt::Key_Up);
    EXPECT_GT(scale().origin_px.y(), first.origin_px.y());
    QTest::keyClick(view.get(), Qt::Key_Home);
    EXPECT_EQ(scale(), first);
}

TEST_F(PlatenViewTest, draggingMovesTheMapAndEndsFollowing) {
    show();
    QAction* follow = nullptr;
    for (QAction* action : view->actions()) {
        follow = action->isCheckable() ? action : follow;
    }
    ASSERT_NE(follow, nullptr);
    follow->setChecked(true);
    const QPointF before = scale().origin_px;
    QTest::mousePress(view.get(), Qt::LeftButton, Qt::NoModifier, {100, 100});
    QMouseEvent drag(QEvent::MouseMove, QPointF(130.0, 80.0), Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(view.get(), &drag);
    EXPECT_LT(distance_px(scale().origin_px, before + QPointF(30.0, -20.0)), 1e-6);
    EXPECT_FALSE(follow->isChecked());
}

TEST_F(PlatenViewTest, followingKeepsThePlatenInTheMiddle) {
    view->setFollowing(true);
    place("position", 20e-3, -10e-3);
    show();
    const QRectF map = platenLayout(view->size(), QFontMetricsF(tabularFont(view->font()))).map;
    EXPECT_LT(distance_px(scale().at({20e-3, -10e-3}), map.center()), 1e-6);
}

TEST_F(PlatenViewTest, reachCountsFromWhereItWasArmed) {
    parameters = {{"window.x", 50e-3},
                  {"window.y", 50e-3},
                  {"window.phi", 30e-3},
                  {"window.position_enabled", 1.0},
                  {"hb.mode", 2.0}};
    signals["status"] = 0.0;
    place("position", 5e-3, 0.0);
    show();
    EXPECT_FALSE(view->reach()); // nothing is guarded yet
    signals["status"] = 1.0;
    show();
    place("position", 15e-3, 0.0);
    show();
    ASSERT_TRUE(view->reach());
    EXPECT_NEAR(view->reach()->up.x(), 40e-3, 1e-12);
    EXPECT_NEAR(view->reach()->down.x(), 60e-3, 1e-12);
    signals["status"] = 0.0;
    show();
    EXPECT_FALSE(view->reach());
}

TEST_F(PlatenViewTest, currentsHeatReadingsAndReferenceChangeThePicture) {
    show();
    QImage before = drawn();
    const auto changes = [&](const std::string& signal, double value) {
        signals[signal] = value;
        show();
        const QImage after = drawn();
        const bool isOther = after != before;
        before = after;
        return isOther;
    };
    EXPECT_TRUE(changes("current.coil3", 0.5));
    EXPECT_TRUE(changes("current.coil3", -0.5));
    EXPECT_TRUE(changes("coil_temperature.coil6", 70.0));
    EXPECT_TRUE(changes("hall.x2", 0.015));
    EXPECT_TRUE(changes("chips_left_out", 2.0));
    EXPECT_TRUE(changes("homed", 1.0));
    EXPECT_TRUE(changes("lift", 4.5));
    parameters["hb.mode"] = 2.0;
    signals["status"] = 1.0;
    place("reference", 1e-6, 0.0);
    show();
    before = drawn();
    EXPECT_TRUE(changes("reference.x", 3e-6)); // two micrometres: seen in the inset
}

// The map's colours are those of the field: a maximum below the origin, a minimum half a pitch along both
// axes, nothing where one array's maximum meets the other's minimum.
TEST_F(PlatenViewTest, mapHasTheColoursOfTheField) {
    const models::PlanarGeometry geometry;
    const Theme theme = currentTheme();
    LatticeMap map;
    MapScale far;
    far.pixels_per_m = 600.0; // blocks too small for their arrows
    far.origin_px = {100.5, 100.5};
    const QImage image = map.image(geometry, far, {201, 201}, 1.0, theme);
    const auto at = [&](double x_m, double y_m) {
        return QColor(image.pixel(far.at({x_m, y_m}).toPoint() - QPoint(0, 0)));
    };
    const auto isClose = [](const QColor& one, const QColor& other) {
        // Half a pixel away the field is another by 1 %.
        return std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
                   std::abs(one.blue() - other.blue()) <
               12;
    };
    EXPECT_TRUE(isClose(at(0.0, 0.0), fieldColour(theme, 1.0)));
    EXPECT_TRUE(isClose(at(25.4e-3, 25.4e-3), fieldColour(theme, -1.0)));
    EXPECT_TRUE(isClose(at(25.4e-3, 0.0), theme.plotBackground));
    EXPECT_TRUE(isClose(QColor(image.pixel(2, 2)), theme.plotBackground)); // beyond the matrix
}

TEST_F(PlatenViewTest, anImageOfTheMapIsKeptUntilItChanges) {
    const models::PlanarGeometry geometry;
    LatticeMap map;
    const Theme theme = currentTheme();
    const qint64 first = map.image(geometry, {{50.0, 50.0}, 1000.0}, {100, 100}, 1.0, theme).cacheKey();
    EXPECT_EQ(map.image(geometry, {{50.0, 50.0}, 1000.0}, {100, 100}, 1.0, theme).cacheKey(), first);
    EXPECT_NE(map.image(geometry, {{51.0, 50.0}, 1000.0}, {100, 100}, 1.0, theme).cacheKey(), first);
}

TEST_F(PlatenViewTest, lengthsOfScalesAreRound) {
    EXPECT_NEAR(roundLength(0.0123), 0.01, 1e-15);
    EXPECT_NEAR(roundLength(0.049), 0.02, 1e-15);
    EXPECT_NEAR(roundLength(9.9), 5.0, 1e-12);
}

TEST_F(PlatenViewTest, aNarrowPictureGivesItsNumbersUp) {
    const QFontMetricsF metrics{tabularFont(view->font())};
    EXPECT_TRUE(platenLayout({300.0, 300.0}, metrics).table.isEmpty());
    const PlatenLayout wide = platenLayout({1600.0, 900.0}, metrics);
    EXPECT_DOUBLE_EQ(wide.map.width() + wide.table.width(), 1600.0);
    EXPECT_TRUE(wide.map.contains(wide.inset));
    // A low one puts them side by side.
    EXPECT_NEAR(platenLayout({1400.0, 400.0}, metrics).table.width(), 2.0 * wide.table.width(), 1e-9);
}

TEST_F(PlatenViewTest, theFileIsPaintedInItsOwnColours) {
    show();
    const auto painted = [&](const char* name) {
        QImage image(600, 400, QImage::Format_RGB32);
        QPainter painter(&image);
        view->drawing()(painter, loadTheme(name).value(), QSizeF(600.0, 400.0));
        return image;
    };
    EXPECT_NE(painted("light"), painted("dark"));
}

} // namespace
} // namespace halbench::widgets
