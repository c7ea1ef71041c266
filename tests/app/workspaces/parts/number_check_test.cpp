#include "app/workspaces/parts/number_check.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/quantity_edit.h"

#include <QSignalSpy>

namespace halbench::app {
namespace {

class NumberCheckTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        window = std::make_unique<QWidget>();
        field = new widgets::QuantityEdit(window.get());
        field->setFormat({"A", -4.0, 4.0, 0.1, 3});
        field->setValue(0.5);
        check = new NumberCheck(*field);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    }
    void TearDown() override { window.reset(); }

    std::unique_ptr<QWidget> window;
    widgets::QuantityEdit* field = nullptr;
    NumberCheck* check = nullptr;
};

TEST_F(NumberCheckTest, takesWhatIsTypedBeforeTheFieldIsLeft) {
    EXPECT_EQ(*check->take(), 0.5);
    type(field, "1.25");
    EXPECT_EQ(*check->take(), 1.25);
}

TEST_F(NumberCheckTest, refusesATextThatStandsThereEveryTime) {
    type(field, "9");
    for (int i = 0; i < 2; ++i) {
        const auto taken = check->take();
        ASSERT_FALSE(taken);
        EXPECT_NE(taken.error().message.find("'9"), std::string::npos) << taken.error().message;
    }
    EXPECT_EQ(field->value(), 0.5);
}

TEST_F(NumberCheckTest, refusesATextThatWasLeftOnceAndThenTakesWhatIsShown) {
    QSignalSpy refusals(check, &NumberCheck::refused);
    type(field, "9");
    field->clearFocus();
    EXPECT_EQ(refusals.count(), 1);
    EXPECT_TRUE(refusals.at(0).at(1).toString().contains("Reset to 0.5")) << "what holds now";
    EXPECT_FALSE(check->take());
    EXPECT_EQ(*check->take(), 0.5);
}

TEST_F(NumberCheckTest, aNumberAfterTheRefusalIsTakenAtOnce) {
    type(field, "9");
    field->clearFocus();
    type(field, "0.5"); // the same as before: nothing changes its value
    field->clearFocus();
    EXPECT_EQ(*check->take(), 0.5);
}

} // namespace
} // namespace halbench::app
