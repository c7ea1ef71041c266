// A view that follows its data against one that looks anew at every frame. Values are whole numbers, which
// the extremes of groups (floats) hold exactly, and steps are powers of two: both answers are equal to the
// bit.
#include "tests/control/history/history_twins.h"

#include <array>

namespace halbench::control {
namespace {

struct Grid {
    double step_s;
    std::size_t count;
};
/// A row or less in a column, some, hundreds, and so many that edges lie at marks.
constexpr std::array<Grid, 4> Grids{{{1.0 / 1024.0, 300}, {1.0 / 64.0, 300}, {0.5, 100}, {4.0, 10}}};

/// Follows, stops, or goes back, as the person at the window does.
class Viewer {
public:
    explicit Viewer(Grid grid) : m_step_s(grid.step_s), m_count(grid.count) {}

    void look(const SampleHistory& history, const std::string& signal, Random& random) {
        const double length_s = m_step_s * static_cast<double>(m_count);
        if (random.uniform() < 0.9) {
            m_end_s = m_step_s * std::ceil(history.range()->end_s / m_step_s);
        } else if (random.uniform() < 0.3) {
            m_end_s -= 20.0 * m_step_s;
        }
        const TimeRange range{m_end_s - length_s, m_end_s};
        history.columns(signal, range, m_count, m_kept);
        history.columns(signal, range, m_count, m_fresh);
        expectSame(m_fresh, m_kept.columns);
    }

private:
    double m_step_s;
    std::size_t m_count;
    double m_end_s = 1.0;
    KeptColumns m_kept;
    std::vector<HistoryColumn> m_fresh;
};

double wholeNumber(std::size_t row, std::size_t column) {
    const bool isNone = column == 1 && row % 3'000 > 2'800;
    return isNone ? NaN : static_cast<double>(1000 * column + (row * 7919) % 613);
}

class KeptColumnsTest : public testing::TestWithParam<Grid> {
protected:
    /// Blocks of a layout come, some after lost rows; the viewer looks after each.
    void record(const std::shared_ptr<const StreamLayout>& layout, std::size_t rows, double gap_ratio) {
        for (std::size_t row = 0; row < rows && !HasFatalFailure();) {
            const auto arriving = static_cast<std::size_t>(1.0 + 90.0 * m_random.uniform());
            m_twins.append(blockOf(layout, row, arriving, wholeNumber));
            row += arriving + (m_random.uniform() < gap_ratio ? 50 : 0);
            m_viewer.look(m_twins.plain, "b", m_random);
            m_pagedViewer.look(m_twins.paged, "b", m_random);
        }
    }

    Random m_random{3};
    Twins m_twins;
    Viewer m_viewer{GetParam()};
    Viewer m_pagedViewer{GetParam()};
};

TEST_P(KeptColumnsTest, areThoseOfANewLook) {
    record(layoutOf({"a", "b", "c"}, 0.001), 40'000, 0.05);
    record(layoutOf({"b", "d"}, 0.0005), 20'000, 0.0);  // another stream goes on with the signal
    record(layoutOf({"b", "d"}, 0.0005), 20'000, 0.01); // its clock starts again
}

TEST_P(KeptColumnsTest, followAHistoryThatForgetsItsOldest) {
    SampleHistory small(6 * SampleChunk::bytesFor(3));
    Viewer viewer(GetParam());
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    for (std::size_t row = 0; row < 60'000 && !HasFatalFailure(); row += 33) {
        small.append(blockOf(layout, row, 33, wholeNumber));
        viewer.look(small, "b", m_random);
    }
}

INSTANTIATE_TEST_SUITE_P(Grids, KeptColumnsTest, testing::ValuesIn(Grids));

TEST(KeptColumns, ofAnotherSignalOrHistoryAreForgotten) {
    SampleHistory one(Large);
    SampleHistory other(Large);
    const auto layout = layoutOf({"a", "b"}, 0.001);
    one.append(blockOf(layout, 0, 5'000, wholeNumber));
    other.append(blockOf(layout, 0, 5'000, [](std::size_t, std::size_t) { return -1.0; }));
    KeptColumns kept;
    const TimeRange range{1.0, 5.0};
    one.columns("a", range, 64, kept);
    EXPECT_GT(kept.columns[10].extremes.max, 100.0);
    one.columns("b", range, 64, kept);
    EXPECT_GT(kept.columns[10].extremes.min, 999.0);
    other.columns("b", range, 64, kept);
    EXPECT_EQ(kept.columns[10].extremes.max, -1.0);
    one.clear();
    one.columns("b", range, 64, kept);
    EXPECT_TRUE(kept.columns[10].extremes.isEmpty());
    one.append(blockOf(layout, 0, 5'000, [](std::size_t, std::size_t) { return -2.0; }));
    one.columns("b", range, 64, kept);
    EXPECT_EQ(kept.columns[10].extremes.max, -2.0);
}

/// What a glance could not see is not kept.
TEST(KeptColumns, areCompletedWhenTheDiskHasAnswered) {
    Twins twins;
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    for (std::size_t row = 0; row < 100'000; row += 1'000) {
        twins.append(blockOf(layout, row, 1'000, wholeNumber));
    }
    twins.pages->canFetch = true;
    const TimeRange range{20.0, 24.0};
    KeptColumns kept;
    std::vector<HistoryColumn> fresh;
    int frames = 0;
    for (bool isWhole = false; !isWhole && frames < 10; ++frames) {
        const SampleHistory::Glance glance(twins.paged);
        twins.paged.columns("b", range, 256, kept);
        isWhole = glance.isWhole();
        twins.pages->deliver();
        twins.paged.settle();
    }
    EXPECT_GT(frames, 1) << "nothing was missing at the first glance";
    EXPECT_LT(frames, 10);
    twins.plain.columns("b", range, 256, fresh);
    expectSame(fresh, kept.columns);
}

} // namespace
} // namespace halbench::control
