#include "app/workspaces/drive/reference_fields.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(ReferenceFields, everyFieldBeginsWithinItsLimitsAndBelongsToAShape) {
    for (const ReferenceFieldSpec& spec : referenceFields()) {
        for (const ReferenceRange& range : {spec.angle, spec.current}) {
            EXPECT_LE(range.min, range.initial) << spec.title;
            EXPECT_LE(range.initial, range.max) << spec.title;
            EXPECT_GT(range.step, 0.0) << spec.title;
        }
        EXPECT_EQ(&referenceField(spec.field), &spec);
        bool isUsed = false;
        for (int code = 1; code <= PlateausShape; ++code) {
            isUsed = isUsed || hasField(code, spec.field);
        }
        EXPECT_TRUE(isUsed) << spec.title;
    }
}

// resources/help/monitor.md, "Reference generator".
TEST(ReferenceFields, onlyAMultisineHasASeedAndOnlyPlateausDwell) {
    for (int code = 1; code <= PlateausShape; ++code) {
        EXPECT_EQ(hasField(code, ReferenceField::Seed), code == 6) << code;
        EXPECT_EQ(hasField(code, ReferenceField::Dwell), code == PlateausShape) << code;
    }
}

} // namespace
} // namespace halbench::app
