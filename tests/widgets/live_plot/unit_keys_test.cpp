// The unit of a curve, chosen by the keys and the menu of its legend.
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/unit_menu.h"

#include <QContextMenuEvent>
#include <QMenu>

namespace halbench::widgets {
namespace {

class UnitKeysTest : public LivePlotStackTest {
protected:
    UnitKeysTest() {
        std::vector<PlotSpec> specs = motorPlots();
        for (PlotCurve& curve : specs[0].curves) {
            curve.unitChoices = {{"", "mT", 1e3, 2}, {"T", "T", 1.0, 5}, {"uT", "\u00b5T", 1e6, 0}};
        }
        stack.setPlots(specs);
        stack.setPaused(true);
        frame();
    }
    void TearDown() override {
        if (QWidget* open = QApplication::activePopupWidget()) {
            open->close();
        }
    }
    LiveLegend& chosen(std::size_t plot, int curve) {
        LiveLegend* legend = legends()[plot];
        legend->setFocus();
        legend->setCurrentIndex(legend->model()->index(curve, 0));
        return *legend;
    }
    static QMenu* press(QWidget& widget, int code) {
        QKeyEvent event(QEvent::KeyPress, code, Qt::NoModifier);
        QApplication::sendEvent(&widget, &event);
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }
    QString cell(std::size_t plot, int row, LegendTableModel::Column column) const {
        return legends()[plot]->model()->index(row, column).data().toString();
    }
    const PlotSpec& spec(std::size_t plot) const { return stack.plots()[plot]; }
};

TEST_F(UnitKeysTest, theKeyOffersTheUnitsAndArrowsChoose) {
    const double before_mT = cell(0, 1, LegendTableModel::Value).toDouble();
    int changes = 0;
    QObject::connect(&stack, &LivePlotStack::plotsChanged, &stack, [&] { ++changes; });
    QMenu* menu = press(chosen(0, 1), Qt::Key_U);
    ASSERT_NE(menu, nullptr);
    ASSERT_EQ(menu->actions().size(), 3);
    EXPECT_EQ(menu->actions()[0]->text(), "Default of the preferences (mT)");
    EXPECT_TRUE(menu->actions()[0]->isChecked());
    EXPECT_EQ(menu->activeAction(), menu->actions()[0]) << "arrows go on from the present one";
    press(*menu, Qt::Key_Down);
    press(*menu, Qt::Key_Down);
    press(*menu, Qt::Key_Return);
    frame();
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(spec(0).curves[1].ownUnit, "uT");
    EXPECT_TRUE(spec(0).curves[1].isRight) << "the other sensor stays in mT";
    EXPECT_EQ(cell(0, 1, LegendTableModel::Unit), QString::fromUtf8("\u00b5T"));
    // Both are rounded to half of their last digit.
    EXPECT_NEAR(cell(0, 1, LegendTableModel::Value).toDouble(), 1e3 * before_mT, 1e3 * 0.005 + 0.5);
    EXPECT_EQ(legends()[0]->currentIndex().row(), 1) << "keys go on with the curve";
    EXPECT_EQ(plots()[0]->axisTitle(QwtPlot::yRight).text(), QString::fromUtf8("Hall field [\u00b5T]"));
    EXPECT_EQ(plots()[0]->axisTitle(QwtPlot::yLeft).text(), "Hall field [mT]");
}

TEST_F(UnitKeysTest, aThirdUnitIsAPlotBelowAndStaysChosen) {
    ASSERT_TRUE(stack.showInUnit(0, "hall.b", "uT"));
    PlotSpec three = spec(0);
    PlotCurve third = three.curves[0];
    third.signal = "angle"; // any that has samples
    three.curves.push_back(third);
    std::vector<PlotSpec> specs = stack.plots();
    specs[0] = three;
    stack.setPlots(specs);
    frame();
    Q_EMIT chosen(0, 2).unitRequested(2, "T");
    frame();
    ASSERT_EQ(stack.plots().size(), 6U);
    EXPECT_EQ(spec(1).unit, "T");
    EXPECT_EQ(spec(1).curves[0].signal, "angle");
    EXPECT_EQ(legends()[1]->currentIndex().row(), 0);
}

TEST_F(UnitKeysTest, theMenuOfACurveHasThem) {
    LiveLegend& legend = chosen(0, 0);
    QContextMenuEvent request(QContextMenuEvent::Keyboard, QPoint(5, 5));
    QApplication::sendEvent(&legend, &request);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(menu, nullptr);
    const auto actions = menu->actions();
    const auto units = std::find_if(actions.begin(), actions.end(),
                                    [](const QAction* action) { return action->text() == "Unit\tU"; });
    ASSERT_NE(units, actions.end());
    ASSERT_NE((*units)->menu(), nullptr);
    (*units)->menu()->actions()[1]->trigger();
    EXPECT_EQ(spec(0).curves[0].ownUnit, "T");
}

TEST_F(UnitKeysTest, whatHasOneUnitOnlyOffersNone) {
    EXPECT_EQ(press(chosen(4, 0), Qt::Key_U), nullptr);
    EXPECT_EQ(unitMenu(spec(4).curves[0], stack, {}), nullptr);
}

TEST_F(UnitKeysTest, theOtherAxisStaysHeld) {
    ASSERT_TRUE(stack.showInUnit(0, "hall.b", "uT"));
    std::vector<PlotSpec> specs = stack.plots();
    specs[0].fixedRange = ValueRange{-20.0, 20.0};
    stack.setPlots(specs);
    ASSERT_TRUE(stack.showInUnit(0, "hall.b", "T"));
    EXPECT_EQ(stack.heldRange(0), (ValueRange{-20.0, 20.0}));
    EXPECT_FALSE(stack.showInUnit(0, "hall.b", "T"));
    EXPECT_FALSE(stack.showInUnit(7, "hall.b", "T"));
}

} // namespace
} // namespace halbench::widgets
