// Colour, line and name of a curve, chosen in its legend.
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/axes/time_axis_bar.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QtTest>

namespace halbench::widgets {
namespace {

class CurveLookTest : public LivePlotStackTest {
protected:
    CurveLookTest() {
        std::vector<PlotSpec> specs = motorPlots();
        specs.push_back(specs[0]); // the signals of the first plot once more
        stack.setPlots(specs);
        frame();
    }
    void TearDown() override { closeMenu(); }
    void closeMenu() {
        while (QWidget* open = QApplication::activePopupWidget()) {
            open->close();
        }
    }
    QMenu* menuOf(std::size_t plot, int curve) {
        LiveLegend* legend = legends()[plot];
        legend->setCurrentIndex(legend->model()->index(curve, 0));
        QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(5, 5));
        QApplication::sendEvent(legend->viewport(), &event);
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }
    /// By the words of the menu, from level to level.
    void choose(std::size_t plot, int curve, const QStringList& words) {
        QMenu* menu = menuOf(plot, curve);
        ASSERT_NE(menu, nullptr);
        for (const QString& word : words) {
            const QList<QAction*> actions = menu->actions();
            const auto found = std::find_if(actions.begin(), actions.end(),
                                            [&](const QAction* action) { return action->text() == word; });
            ASSERT_NE(found, actions.end()) << word.toStdString();
            if ((*found)->menu() != nullptr) {
                menu = (*found)->menu();
            } else {
                (*found)->trigger();
            }
        }
        closeMenu();
        frame();
    }
    const HistoryCurve& curve(std::size_t plot, std::size_t index) const {
        return *plots()[plot]->curves()[index];
    }
    QString name(std::size_t plot, int row) const {
        return legends()[plot]->model()->index(row, LegendTableModel::Name).data().toString();
    }
    const Theme theme = loadTheme("light").value();
};

TEST_F(CurveLookTest, aColourOfTheMenuIsThatOfTheSignalInAllPlots) {
    int changes = 0;
    QObject::connect(&stack, &LivePlotStack::plotsChanged, &stack, [&] { ++changes; });
    const ValueRange held{-3.0, 4.0};
    plots()[0]->zoomValues(held);
    choose(0, 1, {"Colour", "Purple"});
    EXPECT_EQ(changes, 1);
    const std::size_t last = plots().size() - 1;
    EXPECT_EQ(curve(0, 1).colour(), theme.curves[4]); // purple is the fifth of the themes
    EXPECT_EQ(curve(last, 1).colour(), theme.curves[4]);
    EXPECT_EQ(curve(0, 1).pattern(), LinePattern::Solid);
    EXPECT_EQ(stack.valueRange(0), held) << "zoom stays";
    choose(last, 1, {"Line", "Dotted"});
    EXPECT_EQ(curve(0, 1).colour(), theme.curves[4]) << "the line leaves the colour";
    EXPECT_EQ(curve(0, 1).pattern(), LinePattern::Dot);
    choose(0, 1, {"Colour", "Automatic colour and line"});
    EXPECT_TRUE(stack.looks().empty());
    EXPECT_EQ(curve(0, 1).pattern(), LinePattern::Solid);
}

TEST_F(CurveLookTest, itsMenusShowThePresentChoice) {
    choose(0, 1, {"Colour", "Purple"});
    choose(0, 1, {"Line", "Dotted"});
    QStringList shown;
    for (const QAction* action : menuOf(0, 1)->actions()) {
        if (action->menu() != nullptr && action->menu()->defaultAction() != nullptr) {
            shown << action->menu()->defaultAction()->text();
        }
    }
    EXPECT_EQ(shown, QStringList({"Purple", "Dotted"}));
}

TEST_F(CurveLookTest, aChosenLookComesBackWithItsSignal) {
    const PlotCurve first = stack.plots()[0].curves[0];
    choose(0, 0, {"Colour", "Grey"});
    stack.setPlots({motorPlots()[1]});
    frame();
    EXPECT_NE(curve(0, 0).colour(), theme.curves[7]) << "no other signal takes it";
    stack.addCurve(-1, first);
    frame();
    EXPECT_EQ(curve(1, 0).colour(), theme.curves[7]);
}

TEST_F(CurveLookTest, aNameIsTypedInPlaceAndEmptiedForThatOfTheSignal) {
    const QString before = name(0, 0);
    const std::size_t last = plots().size() - 1;
    const auto type = [&](const QString& words) {
        LiveLegend* legend = legends()[0];
        legend->setFocus();
        legend->setCurrentIndex(legend->model()->index(0, 0));
        QTest::keyClick(legend, Qt::Key_F2);
        auto* edit = legend->findChild<QLineEdit*>();
        ASSERT_NE(edit, nullptr);
        edit->setText(words);
        QTest::keyClick(edit, Qt::Key_Return);
        frame();
    };
    type("  Rotor sensor ");
    EXPECT_EQ(name(0, 0), "Rotor sensor");
    EXPECT_EQ(name(last, 0), "Rotor sensor");
    type("");
    EXPECT_EQ(name(0, 0), before);
    EXPECT_EQ(name(last, 0), before);
}

TEST_F(CurveLookTest, theMenuIsShortAndCopiesTheValue) {
    QMenu* menu = menuOf(0, 0);
    ASSERT_NE(menu, nullptr);
    int entries = 0;
    for (const QAction* action : menu->actions()) {
        entries += action->isSeparator() ? 0 : 1;
    }
    EXPECT_LE(entries, 10);
    closeMenu();
    choose(0, 0, {"Copy value"});
    const QStringList copied = QGuiApplication::clipboard()->text().split('\t');
    ASSERT_EQ(copied.size(), 3);
    EXPECT_EQ(copied[0], name(0, 0));
    EXPECT_EQ(copied[1], legends()[0]->model()->index(0, LegendTableModel::Value).data().toString());
}

TEST_F(CurveLookTest, recordedDataOfferNothingToFollow) {
    const auto state = [this] {
        QStringList states;
        for (const TimeAxisBar* bar : stack.findChildren<TimeAxisBar*>()) {
            states << bar->state();
        }
        return states.join(' ');
    };
    stack.showTimeRange({0.0, 30.0});
    frame();
    ASSERT_TRUE(state().contains("End: live")) << state().toStdString();
    stack.setLive(false);
    frame();
    EXPECT_TRUE(state().contains("Recorded data, 30 s")) << state().toStdString();
    EXPECT_FALSE(stack.action(LivePlotStack::Command::Follow)->isEnabled());
    EXPECT_FALSE(stack.action(LivePlotStack::Command::Pause)->isEnabled());
    stack.setLive(true);
    EXPECT_TRUE(stack.action(LivePlotStack::Command::Follow)->isEnabled());
}

} // namespace
} // namespace halbench::widgets
