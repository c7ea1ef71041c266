#include "app/workbench/drive_axes.h"
#include "tests/app/workspaces/bench_fixture.h"

namespace halbench::app {
namespace {

class DriveAxesOriginTest : public BenchTest {};

// The first samples of axes may come in different packets: until each has one that is new, none has an
// origin.
TEST_F(DriveAxesOriginTest, areThoseOfAllAxesAtOnce) {
    connectTo("sim:planar?imperfections=off", 5.0);
    DriveAxes axes(bench());
    axes.useFirst();
    std::vector<std::string> positions;
    for (const devices::AxisSpec& axis : axes.all()) {
        positions.push_back(axes.signal(axis.roles.position));
    }
    bench().liveSignals().want(&bench(), positions);
    ASSERT_TRUE(wait(
        [&] { return bench().history().latest(axes.signal(axes.chosen().roles.position)).has_value(); }));
    const auto known = [&axes] {
        int count = 0;
        for (const devices::AxisSpec& axis : axes.all()) {
            count += axes.motionOf(axis.id).origin.has_value();
        }
        return count;
    };
    axes.takeOrigin();
    EXPECT_FALSE(axes.seekOrigins()) << "samples from before do not tell";
    EXPECT_EQ(known(), 0);
    ASSERT_TRUE(wait([&] {
        const bool isFound = axes.seekOrigins();
        EXPECT_EQ(known(), isFound ? 3 : 0);
        return isFound;
    }));
    EXPECT_FALSE(axes.awaitsOrigin());
    axes.choose("y");
    EXPECT_TRUE(axes.motion().origin);
}

} // namespace
} // namespace halbench::app
