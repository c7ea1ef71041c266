#include "app/workspaces/tune/loop/filter_editor.h"
#include "control/base/units.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/optional_number_edit.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QtTest/QTest>

#include <algorithm>

namespace halbench::app {
namespace {

class FilterEditorTest : public widgets::GuiTest {
protected:
    void SetUp() override {
        GuiTest::SetUp();
        editor.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&editor));
        QApplication::setActiveWindow(&editor);
    }

    widgets::OptionalNumberEdit* edit(const char* name) {
        return editor.findChild<widgets::OptionalNumberEdit*>(name);
    }
    QWidget* named(const QString& name) {
        for (auto* each : editor.findChildren<QWidget*>()) {
            if (each->accessibleName() == name && !each->isHidden()) {
                return each;
            }
        }
        return nullptr;
    }
    void press(const QString& name) {
        ASSERT_NE(named(name), nullptr) << name.toStdString();
        named(name)->setFocus();
        QTest::keyClick(named(name), Qt::Key_Space);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void type(const char* name, const char* text) {
        ASSERT_NE(edit(name), nullptr) << name;
        edit(name)->setFocus();
        QTest::keyClick(edit(name), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(edit(name), Qt::Key_Delete);
        QTest::keyClicks(edit(name), text);
    }
    static control::PidGains gains() {
        control::PidGains result;
        result.proportional = 12.0;
        result.integral = 20.0;
        result.derivative = 0.8;
        return result;
    }
    static control::FilteredLaw everything() {
        control::FilteredLaw law;
        law.gains = gains();
        law.gains.filter_s = 0.1 / 3.0;
        law.proportionalWeight = 0.6;
        law.derivativeWeight = 0.3;
        law.filters = {control::NotchFilter{180.0 / 7.0, 0.1, 0.5}, control::LowPassFilter{250.0, 2},
                       control::LeadFilter{40.0, 15.0}, control::LagFilter{2.0, 1.5}};
        return law;
    }
    control::FilteredLaw law() {
        const auto found = editor.filtered(gains());
        EXPECT_TRUE(found && *found) << (found ? "nothing shaped" : found.error().message);
        return found && *found ? **found : control::FilteredLaw{};
    }
    FilterEditor editor;
};

TEST_F(FilterEditorTest, whatWasSetComesBackToTheLastDigit) {
    editor.setShaping(everything());
    EXPECT_EQ(law(), everything());
    editor.setFrequencyUnit(FrequencyUnit::RadiansPerSecond);
    EXPECT_EQ(law(), everything());
    EXPECT_NEAR(*edit("filter2.0")->value(), 250.0, 1e-9);
    editor.setFrequencyUnit(FrequencyUnit::Hertz);
    EXPECT_NEAR(*edit("filter2.0")->value(), 250.0 / (2.0 * Pi), 1e-9);
}

// Nothing of it is the board's law, which is what may be applied.
TEST_F(FilterEditorTest, withNothingItIsTheBoardsLaw) {
    EXPECT_FALSE(*editor.filtered(gains()));
    editor.setShaping(everything());
    editor.setShaping(std::nullopt);
    EXPECT_FALSE(*editor.filtered(gains()));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(edit("filter1.0"), nullptr);
}

TEST_F(FilterEditorTest, filtersAreAddedChosenEditedAndRemovedByKeyboard) {
    QSignalSpy said(&editor, &FilterEditor::edited);
    press("Weights and filters");
    press("Add a filter");
    ASSERT_EQ(law().filters.size(), 1U);
    EXPECT_EQ(said.back().at(0).toString(), "Add a filter");
    auto* kind = qobject_cast<QComboBox*>(named("Filter 1: kind"));
    ASSERT_NE(kind, nullptr);
    EXPECT_TRUE(kind->hasFocus());
    QTest::keyClick(kind, Qt::Key_Up); // the notch stands before the low-pass
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    editor.setFrequencyUnit(FrequencyUnit::RadiansPerSecond);
    type("filter1.0", "180");
    type("filter1.1", "0.1");
    type("filter1.2", "0.5");
    EXPECT_EQ(said.back().at(0).toString(), "Edit Filter 1: Damping");
    const std::vector<control::LoopFilter> notch = {control::NotchFilter{180.0, 0.1, 0.5}};
    EXPECT_EQ(law().filters, notch);
    press("Add a filter");
    press("Remove Filter 1");
    ASSERT_EQ(law().filters.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<control::LowPassFilter>(law().filters[0]));
    EXPECT_NE(named("Filter 1: Corner"), nullptr) << "the second one is the first now";
    press("Remove Filter 1");
    EXPECT_FALSE(*editor.filtered(gains()));
}

TEST_F(FilterEditorTest, weightsAndTheDerivativesFilterAreTyped) {
    press("Weights and filters");
    type("weight.b", "0.5");
    type("weight.c", "0.25");
    type("filter.time", "0.004");
    EXPECT_EQ(law().proportionalWeight, 0.5);
    EXPECT_EQ(law().derivativeWeight, 0.25);
    EXPECT_EQ(law().gains.filter_s, 0.004);
    EXPECT_EQ(law().gains.proportional, 12.0);
}

TEST_F(FilterEditorTest, whatIsNoNumberIsNamed) {
    press("Weights and filters");
    type("weight.b", "2");
    auto refused = editor.filtered(gains());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("Set-point weight b (P)"), std::string::npos);
    type("weight.b", "1");
    press("Add a filter");
    type("filter1.0", "x");
    refused = editor.filtered(gains());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("Filter 1: Corner"), std::string::npos) << refused.error().message;
}

TEST_F(FilterEditorTest, saysWhetherTheDeviceRunsThem) {
    const auto says = [this](const char* words) {
        const auto labels = editor.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text().contains(words); });
    };
    EXPECT_TRUE(says("may run them"));
    editor.setOffered(BoardLawSpec{});
    EXPECT_TRUE(says("does not run them"));
    editor.setOffered(BoardLawSpec{true, true, true, 0});
    EXPECT_TRUE(says("runs a part"));
    editor.setOffered(BoardLawSpec{true, true, true, 4});
    EXPECT_TRUE(says("up to 4 filters"));
}

TEST_F(FilterEditorTest, thereAreFourAtMost) {
    editor.setShaping(everything());
    EXPECT_FALSE(named("Add a filter")->isEnabled());
    press("Remove Filter 4");
    EXPECT_TRUE(named("Add a filter")->isEnabled());
}

TEST_F(FilterEditorTest, whatCountsIsSeen) {
    EXPECT_FALSE(edit("weight.b")->isVisible());
    editor.setShaping(everything());
    EXPECT_TRUE(edit("weight.b")->isVisible());
}

} // namespace
} // namespace halbench::app
