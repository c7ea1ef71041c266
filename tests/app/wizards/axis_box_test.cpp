#include "app/wizards/axis_box.h"
#include "widgets/figure/offscreen_application.h"

#include <QComboBox>
#include <QSignalSpy>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(AxisBox, offersAllThenEachAxisAndSaysNothing) {
    const auto application = widgets::OffscreenApplication::ensure();
    ASSERT_TRUE(application);
    devices::Catalogue catalogue;
    for (const char* id : {"x", "phi"}) {
        devices::AxisSpec axis;
        axis.id = id;
        axis.title = std::string("Axis ") + id;
        catalogue.axes.push_back(axis);
    }
    QComboBox box;
    box.addItem(QStringLiteral("of another device"));
    QSignalSpy changes(&box, QOverload<int>::of(&QComboBox::currentIndexChanged));
    fillAxisBox(box, catalogue, QStringLiteral("every axis"));
    ASSERT_EQ(box.count(), 3);
    EXPECT_EQ(box.itemText(0), QStringLiteral("every axis"));
    EXPECT_EQ(box.itemData(0).toString(), QStringLiteral("all"));
    EXPECT_EQ(box.itemText(2), QStringLiteral("Axis phi"));
    EXPECT_EQ(box.itemData(2).toString(), QStringLiteral("phi"));
    EXPECT_EQ(changes.size(), 0);
}

} // namespace
} // namespace halbench::app
