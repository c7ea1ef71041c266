#include "app/workspaces/parts/field_grid.h"
#include "app/workspaces/parts/signal_box.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>

namespace halbench::app {
namespace {

class SignalBoxTest : public widgets::GuiTest {
protected:
    static devices::Catalogue catalogue() {
        devices::Catalogue made;
        for (const char* name : {"speed", "hall.a", "hall.b"}) {
            SignalSpec spec;
            spec.name = name;
            made.signals.push_back(spec);
        }
        made.signals.back().role = "hall.b";
        return made;
    }
};

TEST_F(SignalBoxTest, beginsWithARoleAndKeepsWhatIsChosen) {
    SignalBox box(nullptr);
    EXPECT_EQ(box.signal(), "");
    box.setCatalogue(catalogue(), {"torque", "hall.b"});
    EXPECT_EQ(box.signal(), "hall.b");
    EXPECT_EQ(box.currentText(), "Hall B");
    box.choose("speed");
    box.setCatalogue(catalogue(), {"hall.b"});
    EXPECT_EQ(box.signal(), "speed");
}

TEST_F(SignalBoxTest, takesASignalOfTheTree) {
    SignalBox box(nullptr);
    box.setCatalogue(catalogue(), {});
    QSignalSpy chosen(&box, &SignalBox::chosen);
    QMimeData data;
    data.setData(widgets::SignalsMimeType, "hall.a\nspeed");
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&box, &enter);
    QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&box, &drop);
    EXPECT_EQ(box.signal(), "hall.a");
    EXPECT_EQ(chosen.count(), 1);
}

TEST_F(SignalBoxTest, fieldsOfAGridStandBelowTheirTitlesInRows) {
    FieldGrid grid(2, nullptr);
    for (const char* title : {"one", "two", "three"}) {
        grid.addBox(title, "what it is for");
    }
    grid.addNumber({"four", "a number"});
    grid.resize(400, 200);
    grid.show();
    const auto labels = grid.findChildren<QLabel*>();
    ASSERT_EQ(labels.size(), 4);
    for (const QLabel* label : labels) {
        ASSERT_NE(label->buddy(), nullptr);
        EXPECT_EQ(label->buddy()->accessibleName(), label->text());
        EXPECT_EQ(label->x(), label->buddy()->x());
        EXPECT_LT(label->y(), label->buddy()->y());
    }
    EXPECT_EQ(labels[0]->y(), labels[1]->y());
    EXPECT_LT(labels[1]->y(), labels[2]->y());
}

} // namespace
} // namespace halbench::app
