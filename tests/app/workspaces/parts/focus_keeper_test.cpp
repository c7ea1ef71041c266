#include "app/workspaces/parts/focus_keeper.h"
#include "tests/widgets/gui_fixture.h"

#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::app {
namespace {

class FocusKeeperTest : public widgets::GuiTest {
protected:
    void SetUp() override {
        GuiTest::SetUp();
        auto* column = new QVBoxLayout(&m_window.emplace());
        for (QWidget* one : std::initializer_list<QWidget*>{rest = new QWidget,
                            button = new QPushButton("Start"), limit = new QLineEdit}) {
            column->addWidget(one);
        }
        m_window->show();
        button->setFocus();
    }
    void TearDown() override { m_window.reset(); }

    QWidget* focus() { return m_window->focusWidget(); }

    QWidget* rest = nullptr;
    QPushButton* button = nullptr;
    QLineEdit* limit = nullptr;

private:
    std::optional<QWidget> m_window;
};

TEST_F(FocusKeeperTest, waitsWhereKeysDoNothingAndComesBack) {
    FocusKeeper place(*rest);
    place.setEnabled(*button, false);
    EXPECT_EQ(focus(), rest); // not the limit
    place.setEnabled(*button, true);
    EXPECT_EQ(focus(), button);
}

TEST_F(FocusKeeperTest, staysWhereItWasPutSince) {
    FocusKeeper place(*rest);
    place.setEnabled(*button, false);
    limit->setFocus();
    place.setEnabled(*button, true);
    EXPECT_EQ(focus(), limit);
}

TEST_F(FocusKeeperTest, ofAnotherControlIsLeftAlone) {
    FocusKeeper place(*rest);
    limit->setFocus();
    place.setEnabled(*button, false);
    EXPECT_EQ(focus(), limit);
}

TEST_F(FocusKeeperTest, isNotGivenBackWhenItIsForgotten) {
    FocusKeeper place(*rest);
    place.setEnabled(*button, false);
    place.forget();
    place.setEnabled(*button, true);
    EXPECT_EQ(focus(), rest);
}

} // namespace
} // namespace halbench::app
