#include "tests/widgets/gui_fixture.h"
#include "widgets/actuators/registry/actuator_views.h"

#include <QAction>

#include <algorithm>
#include <memory>
#include <set>

namespace halbench::widgets {
namespace {

class ActuatorViewsTest : public GuiTest {};

TEST_F(ActuatorViewsTest, aDeviceIsShownByTheViewWhoseSignalsItHas) {
    for (const ActuatorView& view : actuatorViews()) {
        const auto plays = [&](const std::string& role) {
            return std::find(view.needed.begin(), view.needed.end(), role) != view.needed.end();
        };
        EXPECT_EQ(actuatorViewFor(plays), &view) << view.id;
    }
    EXPECT_EQ(actuatorViewFor([](const std::string&) { return false; }), nullptr);
}

TEST_F(ActuatorViewsTest, everyViewStandsAnEmptyDevice) {
    const auto nothing = [](const std::string&) { return std::optional<double>(); };
    for (const ActuatorView& view : actuatorViews()) {
        const std::unique_ptr<ActuatorPicture> picture(view.make(nullptr));
        picture->showSettings({nothing, nothing});
        picture->showSamples({nothing, nothing});
        picture->setStale(true);
        picture->clear();
        picture->resize(300, 300);
        EXPECT_FALSE(picture->grab().isNull()) << view.id;
        std::set<QString> texts;
        for (const QAction* action : picture->actions()) {
            EXPECT_FALSE(action->toolTip().isEmpty()) << view.id;
            EXPECT_TRUE(texts.insert(action->text()).second) << view.id;
        }
    }
}

} // namespace
} // namespace halbench::widgets
