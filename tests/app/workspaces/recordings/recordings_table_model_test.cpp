#include "app/workspaces/recordings/recordings_table_model.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

RecordingEntry entryOf(const QString& name, const QString& device, double duration_s) {
    RecordingEntry entry;
    entry.path = "/data/" + name + ".csv";
    entry.name = name;
    entry.device = device;
    entry.duration_s = duration_s;
    entry.date = QDateTime({2026, 1, 2}, {3, 4, 5}, Qt::UTC);
    return entry;
}

class RecordingsTableModelTest : public testing::Test {
protected:
    RecordingsTableModelTest() {
        RecordingEntry gaps = entryOf("warm", "HB-17", 9.0);
        gaps.gaps = 2;
        gaps.missingRows = 12;
        gaps.results = QStringList({"warm.json", "warm.gains.json"});
        gaps.tags = QStringList({"bearing"});
        gaps.signalNames = QStringList({"position", "hall.a"});
        RecordingEntry partial = entryOf("lost", "HB-18", 10.0);
        partial.isInterrupted = true;
        model.setEntries({entryOf("cold", "HB-17", 70.0), gaps, partial});
        filter.setSourceModel(&model);
    }
    QString text(int row, int column) const { return model.index(row, column).data().toString(); }

    RecordingsTableModel model;
    RecordingsFilterModel filter;
};

TEST_F(RecordingsTableModelTest, everyColumnSaysWhatItIsAbout) {
    EXPECT_EQ(text(0, RecordingsTableModel::Name), "cold");
    EXPECT_EQ(text(0, RecordingsTableModel::Length), "1:10");
    EXPECT_EQ(text(0, RecordingsTableModel::Gaps), "");
    EXPECT_EQ(text(1, RecordingsTableModel::Gaps), "2 (12 rows)");
    EXPECT_EQ(text(1, RecordingsTableModel::Signals), "2");
    EXPECT_EQ(text(2, RecordingsTableModel::Gaps), "interrupted");
    EXPECT_EQ(model.index(1, RecordingsTableModel::Signals).data(Qt::ToolTipRole), "position\nhall.a");
    EXPECT_EQ(text(1, RecordingsTableModel::Results), "warm.json, warm.gains.json");
    EXPECT_EQ(model.index(1, RecordingsTableModel::Results).data(Qt::ToolTipRole),
              "warm.json\nwarm.gains.json");
    for (int column = 0; column < model.columnCount(); ++column) {
        EXPECT_FALSE(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().isEmpty());
    }
}

TEST_F(RecordingsTableModelTest, aSimulatedDeviceIsSaidToBeOneOnce) {
    RecordingEntry own = entryOf("own", "sim-htm-1", 1.0);
    RecordingEntry renamed = entryOf("renamed", "HB-17", 1.0);
    own.isSimulated = renamed.isSimulated = true;
    model.setEntries({own, renamed});
    EXPECT_EQ(text(0, RecordingsTableModel::Device), "sim-htm-1");
    EXPECT_EQ(text(1, RecordingsTableModel::Device), "HB-17 (simulated)");
}

TEST_F(RecordingsTableModelTest, everyWordThatIsSearchedForMustOccur) {
    filter.setWords("hb-17");
    EXPECT_EQ(filter.rowCount(), 2);
    filter.setWords("  HB-17   hall ");
    EXPECT_EQ(filter.rowCount(), 1);
    filter.setWords("bearing cold");
    EXPECT_EQ(filter.rowCount(), 0);
    filter.setWords("");
    EXPECT_EQ(filter.rowCount(), 3);
}

TEST_F(RecordingsTableModelTest, lengthsAreOrderedAsNumbers) {
    filter.setSortRole(RecordingsTableModel::SortRole);
    filter.sort(RecordingsTableModel::Length);
    EXPECT_EQ(filter.index(0, 0).data(), "warm");
    EXPECT_EQ(filter.index(2, 0).data(), "cold");
}

TEST_F(RecordingsTableModelTest, wordsOfTheUserAreFoundAtOnce) {
    EXPECT_EQ(model.rowOf("/data/none.csv"), -1);
    model.setWords("/data/cold.csv", {"winter"}, "outside");
    EXPECT_EQ(text(0, RecordingsTableModel::Tags), "winter");
    filter.setWords("outside");
    EXPECT_EQ(filter.rowCount(), 1);
}

} // namespace
} // namespace halbench::app
