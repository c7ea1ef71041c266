#include "app/documents/text/procedure_choices.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(ProcedureChoices, knowTheDirectionsOfASweep) {
    EXPECT_EQ(sweepDirections("").value(), SweepDirections::Both);
    EXPECT_EQ(sweepDirections("both").value(), SweepDirections::Both);
    EXPECT_EQ(sweepDirections("forward").value(), SweepDirections::Forward);
    EXPECT_EQ(sweepDirections("reverse").value(), SweepDirections::Reverse);
    EXPECT_EQ(sweepDirections("Forward").error().code, ErrorCode::Usage);
}

TEST(ProcedureChoices, knowEveryCalibrationByItsName) {
    const std::vector<Calibration> all = CalibrateConfig{}.which;
    EXPECT_EQ(calibrationsFrom("all").value(), all);
    for (const Calibration calibration : all) {
        EXPECT_EQ(calibrationsFrom(std::string(calibrationName(calibration))).value(),
                  std::vector<Calibration>{calibration});
    }
    EXPECT_EQ(calibrationsFrom("halls").error().code, ErrorCode::Usage);
}

} // namespace
} // namespace halbench::app
