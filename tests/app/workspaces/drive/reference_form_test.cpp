#include "app/workspaces/drive/reference_form.h"
#include "app/workspaces/parts/panel_parts.h"
#include "control/base/units.h"
#include "tests/app/workspaces/bench_fixture.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>

namespace halbench::app {
namespace {

class ReferenceFormTest : public BenchTest {
protected:
    ReferenceForm& form() {
        if (!m_form) {
            m_form = std::make_unique<ReferenceForm>();
        }
        return *m_form;
    }
    void TearDown() override { m_form.reset(); }

    void choose(int shape) { find<QComboBox>(form(), "Shape of the reference")->setCurrentIndex(shape - 1); }
    double valueOf(const std::string& name) {
        const auto values = form().takeValues();
        EXPECT_TRUE(values) << (values ? "" : values.error().message);
        for (const ParameterValue& value : values ? *values : std::vector<ParameterValue>()) {
            if (value.name == name) {
                return value.value;
            }
        }
        ADD_FAILURE() << name;
        return 0.0;
    }

private:
    std::unique_ptr<ReferenceForm> m_form;
};

TEST_F(ReferenceFormTest, everyShapeShowsOnlyItsParameters) {
    const int rows[] = {3, 4, 4, 4, 5, 7, 1}; // resources/help/monitor.md, the generator's table
    form().setMode(devices::BoardMode::Current);
    for (int shape = 1; shape <= 7; ++shape) {
        choose(shape);
        int shown = 0;
        for (const auto* box : form().findChildren<QDoubleSpinBox*>()) {
            shown += box->isVisibleTo(&form()) ? 1 : 0;
        }
        EXPECT_EQ(shown, rows[shape - 1]) << shape;
    }
}

TEST_F(ReferenceFormTest, anglesAreRadiansForTheBoard) {
    choose(3);
    find<QDoubleSpinBox>(form(), "Amplitude")->setValue(90.0);
    find<QDoubleSpinBox>(form(), "Frequency")->setValue(2.0);
    find<QDoubleSpinBox>(form(), "Duration")->setValue(4.0);
    EXPECT_EQ(valueOf("reference.shape"), 3.0);
    EXPECT_NEAR(valueOf("reference.amplitude"), Pi / 2.0, 1e-12);
    EXPECT_EQ(valueOf("reference.frequency"), 2.0);
    EXPECT_EQ(valueOf("reference.duration"), 4.0);
    EXPECT_NEAR(form().peak(), Pi / 2.0, 1e-12);
}

TEST_F(ReferenceFormTest, thePreferredUnitShowsTheSameMotion) {
    choose(2);
    find<QDoubleSpinBox>(form(), "Slope")->setValue(15.0); // r/min, the preference at first
    find<QDoubleSpinBox>(form(), "Amplitude")->setValue(90.0);
    EXPECT_NEAR(valueOf("reference.rate"), 15.0 * Pi / 30.0, 1e-12);
    form().setUnits({widgets::AngleUnit::Radian, SpeedUnit::DegreesPerSecond});
    EXPECT_NEAR(find<QDoubleSpinBox>(form(), "Slope")->value(), 90.0, 1e-9);
    EXPECT_TRUE(find<QDoubleSpinBox>(form(), "Slope")->suffix().endsWith("\u00b0/s"));
    EXPECT_TRUE(find<QDoubleSpinBox>(form(), "Offset speed (added)")->suffix().endsWith("\u00b0/s"));
    EXPECT_TRUE(find<QDoubleSpinBox>(form(), "Amplitude")->suffix().endsWith("rad"));
    EXPECT_NEAR(valueOf("reference.amplitude"), Pi / 2.0, 5e-5); // four decimals are shown
    EXPECT_NEAR(valueOf("reference.rate"), Pi / 2.0, 1e-12);
    EXPECT_NEAR(find<QDoubleSpinBox>(form(), "Amplitude")->maximum(), degreesToRadians(36000.0), 1e-4);
    form().setMode(devices::BoardMode::Current); // no angle there
    EXPECT_TRUE(find<QDoubleSpinBox>(form(), "Amplitude")->suffix().endsWith("A"));
    form().setUnits({widgets::AngleUnit::Degree, SpeedUnit::RadiansPerSecond});
    find<QDoubleSpinBox>(form(), "Amplitude")->setValue(0.7);
    EXPECT_EQ(valueOf("reference.amplitude"), 0.7);
}

TEST_F(ReferenceFormTest, currentsStayAmpereAndTheBaseAddsToThePeak) {
    form().setMode(devices::BoardMode::Current);
    choose(1);
    find<QDoubleSpinBox>(form(), "Amplitude")->setValue(-1.5);
    find<QDoubleSpinBox>(form(), "Offset current (added)")->setValue(0.25);
    EXPECT_EQ(valueOf("reference.amplitude"), -1.5);
    EXPECT_EQ(valueOf("reference.base"), 0.25);
    EXPECT_NEAR(form().peak(), 1.75, 1e-12);
}

TEST_F(ReferenceFormTest, plateausBelongToTheCurrentModes) {
    auto* shapes = find<QComboBox>(form(), "Shape of the reference");
    EXPECT_EQ(shapes->count(), 6);
    form().setMode(devices::BoardMode::Current);
    EXPECT_EQ(shapes->count(), 7);
    choose(7);
    find<QLineEdit>(form(), "Currents of the plateaus in ampere")->setText("1; 2.5 -3");
    EXPECT_EQ(valueOf("plateau.count"), 3.0);
    EXPECT_EQ(valueOf("plateau.current_2"), 2.5);
    EXPECT_EQ(valueOf("plateau.current_3"), -3.0);
    EXPECT_EQ(form().peak(), 3.0);
    find<QLineEdit>(form(), "Currents of the plateaus in ampere")->setText("1; two");
    const auto refused = form().takeValues();
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("two"), std::string::npos);
    find<QLineEdit>(form(), "Currents of the plateaus in ampere")->setText("0,500"); // not 500 A
    EXPECT_FALSE(form().takeValues());
}

TEST_F(ReferenceFormTest, aStepOfNothingIsRefused) {
    choose(1);
    find<QDoubleSpinBox>(form(), "Amplitude")->setValue(0.0);
    EXPECT_FALSE(form().takeValues());
}

} // namespace
} // namespace halbench::app
