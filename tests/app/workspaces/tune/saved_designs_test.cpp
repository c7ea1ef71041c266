#include "app/workspaces/tune/saved_designs.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

std::vector<std::string> names(const SavedDesigns& designs) {
    std::vector<std::string> result;
    for (const KeptDesign& design : designs.all()) {
        result.push_back(design.name);
    }
    return result;
}

using Names = std::vector<std::string>;

TEST(SavedDesigns, haveNamesOfTheirOwn) {
    SavedDesigns designs;
    EXPECT_EQ(designs.keep("lqr", "a"), 0U);
    EXPECT_EQ(designs.keep("lqr", "b"), 1U);
    EXPECT_EQ(designs.keep("lqr", "c"), 2U);
    EXPECT_EQ(names(designs), (Names{"lqr", "lqr 2", "lqr 3"}));
    ASSERT_TRUE(designs.rename(1, "calm"));
    EXPECT_EQ(designs.rename(2, "calm").error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(designs.rename(2, "").error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(names(designs), (Names{"lqr", "calm", "lqr 3"}));
    EXPECT_TRUE(designs.rename(1, "calm")); // as it is
}

TEST(SavedDesigns, whatWasDoneIsUndoneAndRedoneInOrder) {
    SavedDesigns designs;
    designs.restore({keptDesign("one", "1")});
    EXPECT_FALSE(designs.canUndo());
    designs.keep("two", "2");
    ASSERT_TRUE(designs.rename(0, "first"));
    designs.remove(1);
    EXPECT_EQ(names(designs), Names{"first"});
    designs.undo();
    EXPECT_EQ(names(designs), (Names{"first", "two"}));
    designs.undo();
    designs.undo();
    EXPECT_EQ(names(designs), Names{"one"});
    EXPECT_FALSE(designs.canUndo());
    designs.redo();
    EXPECT_EQ(names(designs), (Names{"one", "two"}));
    designs.remove(0); // from here on another story
    EXPECT_FALSE(designs.canRedo());
    designs.undo();
    EXPECT_EQ(names(designs), (Names{"one", "two"}));
}

TEST(SavedDesigns, whatIsAdoptedStaysWhateverIsUndone) {
    SavedDesigns designs;
    designs.restore({keptDesign("calm", "1"), keptDesign("quick", "2")});
    designs.remove(0);
    designs.adopt("calm", "3");
    EXPECT_EQ(names(designs), (Names{"quick", "calm 2"}));
    designs.undo();
    EXPECT_EQ(names(designs), (Names{"calm", "quick", "calm 2"}));
    designs.redo();
    EXPECT_EQ(names(designs), (Names{"quick", "calm 2"}));
}

TEST(SavedDesigns, theNameOfTheOneInUseIsTaken) {
    SavedDesigns designs;
    designs.keep("lqr", "a");
    EXPECT_EQ(designs.rename(0, "in use").error().code, ErrorCode::InvalidInput);
    designs.adopt("in use", "b");
    EXPECT_EQ(names(designs), (Names{"lqr", "in use 2"}));
}

TEST(SavedDesigns, aDocumentThatCannotBeReadStaysAsItIs) {
    const KeptDesign damaged = keptDesign("old", "no JSON");
    EXPECT_FALSE(damaged.gains);
    EXPECT_EQ(damaged.document, "no JSON");
}

} // namespace
} // namespace halbench::app
