#include "app/documents/presets.h"
#include "app/workspaces/tune/loop/design_names.h"
#include "control/design/design_methods.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

// A name of the program is no title: it would stay English in every language.
TEST(DesignNames, everyMethodAndPresetHasATitle) {
    const auto isTitled = [](const std::string& name) {
        return name.find('-') == std::string::npos || designTitle(name).toStdString() != name ||
               name == "micro-step";
    };
    for (const control::DesignMethod& method : control::designMethods()) {
        EXPECT_TRUE(isTitled(std::string(method.name))) << method.name;
    }
    for (const std::string& preset : presetNames()) {
        EXPECT_TRUE(isTitled(preset)) << preset;
    }
    EXPECT_EQ(designTitle("pole-placement"), "pole placement");
    EXPECT_EQ(designTitle("edited"), "edited manually"); // what the form calls them
    EXPECT_EQ(designTitle("device"), "from the device");
    EXPECT_EQ(designTitle("lqr"), "LQR");
}

TEST(DesignNames, whatIsNotKnownKeepsItsName) {
    EXPECT_EQ(designTitle("of-a-newer-version"), "of-a-newer-version");
}

} // namespace
} // namespace halbench::app
