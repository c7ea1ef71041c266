#include "control/design/design_methods.h"
#include "widgets/language/window_terms.h"

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

TEST(WindowTerms, namesNoOptionOfTheCommandLine) {
    // The hints as the layers below give them: a method that lacks its target.
    for (const char* method : {"bandwidth", "phase-margin"}) {
        const auto law = control::designLaw(method, {2.24, 25.9, 1.43}, {}, {});
        ASSERT_FALSE(law);
        const auto here = windowTerms(QString::fromStdString(law.error().hint));
        ASSERT_TRUE(here) << law.error().hint;
        EXPECT_FALSE(here->contains("--"));
    }
}

TEST(WindowTerms, leavesEverythingElse) {
    EXPECT_FALSE(windowTerms("use a longer time at each current"));
}

} // namespace
} // namespace halbench::widgets
