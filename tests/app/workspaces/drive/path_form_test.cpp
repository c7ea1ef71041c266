#include "app/documents/pose_table_file.h"
#include "app/procedures/excite/travel_reference.h"
#include "app/workspaces/drive/path_form.h"
#include "control/base/units.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/quantity_edit.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include <algorithm>

namespace halbench::app {
namespace {

using Shape = MoveReference::Shape;

class PathFormTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        form = std::make_unique<PathForm>();
        form->show();
    }
    void TearDown() override { form.reset(); }

    void set(const char* name, double value) { find<QDoubleSpinBox>(*form, name)->setValue(value); }
    /// The note below the fields: the one label that is no title of a field.
    QString note() {
        for (const QLabel* label : form->findChildren<QLabel*>()) {
            if (label->buddy() == nullptr && label->isVisible()) {
                return label->text();
            }
        }
        return {};
    }
    void setTable(const std::string& text) {
        form->setTable("/tmp/poses.csv", parsePoseTable(text, "poses.csv"));
    }

    std::unique_ptr<PathForm> form;
};

TEST_F(PathFormTest, everyShapeShowsTheSettingsOfTheCommandLine) {
    for (const Shape shape : {Shape::Circle, Shape::Raster, Shape::Arc, Shape::Line, Shape::Table}) {
        form->setShape(shape);
        std::vector<QString> titles;
        for (const auto* field : form->findChildren<widgets::QuantityEdit*>()) {
            if (field->isVisible()) {
                titles.push_back(field->accessibleName());
            }
        }
        EXPECT_EQ(titles.size(), settingsOf(shape).size()) << static_cast<int>(shape);
        std::sort(titles.begin(), titles.end());
        EXPECT_EQ(std::unique(titles.begin(), titles.end()), titles.end()) << "two fields with the same name";
    }
}

TEST_F(PathFormTest, fieldsHaveTheLimitsAndWordsOfTheKeys) {
    form->setShape(Shape::Circle);
    const auto* radius = find<QDoubleSpinBox>(*form, "Radius");
    const SettingSpec spec = settingSpec({"radius", MoveReference::Quantity::Length});
    EXPECT_EQ(spec.key, "radius_m");
    EXPECT_EQ(spec.unit, "m");
    EXPECT_DOUBLE_EQ(radius->maximum(), spec.max * 1e3); // shown in mm
    EXPECT_DOUBLE_EQ(radius->minimum(), spec.min * 1e3);
    EXPECT_TRUE(radius->suffix().endsWith("mm"));
    EXPECT_TRUE(radius->toolTip().startsWith("Radius; of a circle the centre lies along the first axis"))
        << radius->toolTip().toStdString();
    EXPECT_EQ(find<QDoubleSpinBox>(*form, "Turns")->decimals(), 0);
}

TEST_F(PathFormTest, givesTheReferenceOfTheCommandLine) {
    form->setShape(Shape::Arc);
    set("Radius", 2.0);
    set("Angle", -90.0);
    set("Heading", 45.0);
    set("Speed", 20.0);
    set("Acceleration", 0.5);
    set("Jerk", 0.0);
    const auto shown = form->take();
    ASSERT_TRUE(shown) << shown.error().message;
    const auto typed =
        parseMoveReference("arc,radius_mm=2,angle_deg=-90,heading_deg=45,rate_mm_s=20,acceleration_m_s2=0.5");
    ASSERT_TRUE(typed);
    const auto parameters = [](const MoveReference& reference) {
        return generatorParameters(reference, 0.0);
    };
    const auto one = parameters(*shown);
    const auto other = parameters(*typed);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].name, other[i].name);
        EXPECT_NEAR(one[i].value, other[i].value, 1e-12) << one[i].name;
    }
    EXPECT_TRUE(note().startsWith("Travel time: ")) << note().toStdString();
}

TEST_F(PathFormTest, preferredUnitsShowTheSamePath) {
    form->setShape(Shape::Arc);
    set("Angle", 90.0);
    form->setUnits({widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond});
    EXPECT_NEAR(find<QDoubleSpinBox>(*form, "Angle")->value(), Pi / 2.0, 1e-4);
    const auto reference = form->reference();
    ASSERT_TRUE(reference);
    EXPECT_NEAR(reference->angle_rad.value_or(0.0), Pi / 2.0, 1e-4);
}

TEST_F(PathFormTest, whatIsRefusedStandsAtTheFields) {
    form->setShape(Shape::Arc);
    set("Radius", -2.0);
    EXPECT_FALSE(form->take());
    EXPECT_TRUE(note().contains("radius of an arc")) << note().toStdString();
    set("Radius", 2.0);
    EXPECT_TRUE(form->take());
}

TEST_F(PathFormTest, tableIsChosenReadAndJudged) {
    form->setShape(Shape::Table);
    EXPECT_TRUE(note().contains("No table of poses")) << note().toStdString();
    EXPECT_FALSE(form->take());
    QSignalSpy wanted(form.get(), &PathForm::fileWanted);
    for (auto* button : form->findChildren<QPushButton*>()) {
        button->click();
    }
    EXPECT_EQ(wanted.count(), 1);
    setTable("time_s,x_mm\n1,1\n2,nan\n");
    EXPECT_TRUE(note().contains("poses.csv:3:3:")) << note().toStdString();
    set("Speed", 100.0);
    set("Acceleration", 1.0);
    setTable("time_s,x_mm\n1,1\n2.5,0\n");
    const auto timed = form->take();
    ASSERT_TRUE(timed) << timed.error().message;
    EXPECT_NEAR(travelTime_s(*timed).value_or(0.0), 2.5, 1e-12);
    EXPECT_EQ(note(), "Travel time: 2.500 s");
    set("Speed", 1.0); // mm/s: 9/4 of the mean of 2/3 mm/s and more
    EXPECT_TRUE(note().contains("row 1")) << note().toStdString();
    set("Speed", 20.0);
    set("Dwell", 0.25);
    setTable("x_mm\n1\n2\n");
    const auto visited = form->take();
    ASSERT_TRUE(visited) << visited.error().message;
    EXPECT_DOUBLE_EQ(visited->dwell_s, 0.25);
}

TEST_F(PathFormTest, pathsAreThoseOfTheDevice) {
    EXPECT_TRUE(offeredPaths(devices::Catalogue{}).empty());
    connectTo("sim:planar?imperfections=off", 5.0);
    EXPECT_EQ(offeredPaths(session().catalogue()).size(), 5u);
    for (const Shape shape : offeredPaths(session().catalogue())) {
        EXPECT_FALSE(pathTitle(shape).isEmpty());
    }
    EXPECT_TRUE(pathTitle(Shape::Sine).isEmpty());
}

} // namespace
} // namespace halbench::app
