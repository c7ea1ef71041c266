#include "app/figures/recording_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace halbench::app {
namespace {

Recording sample() {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(
        StreamLayout{{{"hall.a", "T"}, {"position", "rad"}, {"hall.b", "T"}, {"share", "1"}}, 0.1});
    for (int row = 0; row < 20; ++row) {
        recording.time_s.push_back(0.1 * row + (row >= 10 ? 1.0 : 0.0)); // a second is missing
        for (const double value : {0.1, 0.01 * row, 0.2, 0.5}) {
            recording.values.push_back(value);
        }
    }
    return recording;
}

TEST(RecordingPictureTest, theEndingSaysWhatIsAPicture) {
    EXPECT_TRUE(isPictureFile("a.svg") && isPictureFile("a.pdf") && isPictureFile("a.png"));
    EXPECT_FALSE(isPictureFile("a.csv") || isPictureFile("pdf"));
}

TEST(RecordingPictureTest, signalsOfOneUnitShareAPanel) {
    const auto panels = picturePanels(*sample().layout);
    ASSERT_TRUE(panels);
    ASSERT_EQ(panels->size(), 3U);
    EXPECT_EQ((*panels)[0].unit, "T");
    EXPECT_EQ((*panels)[0].columns, (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ((*panels)[1].columns, (std::vector<std::size_t>{1}));
}

TEST(RecordingPictureTest, aSignalGoesToTheRightAxisOfTheOneBeforeIt) {
    const std::shared_ptr<const StreamLayout> kept = sample().layout;
    const StreamLayout& layout = *kept;
    const std::string second = layout.columns[1].name; // an angle behind a flux density
    const auto panels = picturePanels(layout, {second});
    ASSERT_TRUE(panels);
    ASSERT_EQ(panels->size(), 2U);
    EXPECT_EQ((*panels)[0].rightUnit, "rad");
    EXPECT_EQ((*panels)[0].rightColumns, (std::vector<std::size_t>{1}));
    EXPECT_EQ((*panels)[0].columns, (std::vector<std::size_t>{0, 2}));
    const auto picture = recordingPicture(sample(), "run.csv", "a.svg", {second});
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_NE(picture->find(">angle [rad]<"), std::string::npos);
    EXPECT_NE(picture->find(">" + second + " (right)<"), std::string::npos);
    EXPECT_EQ(picturePanels(layout, {"no.such"}).error().code, ErrorCode::UnknownName);
    EXPECT_EQ(picturePanels(layout, {layout.columns[0].name}).error().code, ErrorCode::Usage);
}

TEST(RecordingPictureTest, axesAreTitledAndTheTitleStands) {
    const auto picture = recordingPicture(sample(), "run.csv", "a.svg");
    ASSERT_TRUE(picture) << picture.error().message;
    for (const char* words :
         {">flux density [T]<", ">angle [rad]<", ">ratio<", ">time [s]<", ">run.csv<", ">hall.b<"}) {
        EXPECT_NE(picture->find(words), std::string::npos) << words;
    }
    EXPECT_EQ(*picture, *recordingPicture(sample(), "run.csv", "a.svg"));
    EXPECT_EQ(recordingPicture(sample(), "run.csv", "a.pdf")->substr(0, 5), "%PDF-");
}

TEST(RecordingPictureTest, missingRowsInterruptTheLine) {
    const auto lines = [](const Recording& recording) {
        const std::string picture = *recordingPicture(recording, "", "a.svg");
        std::size_t count = 0;
        const std::string begin = "points=\"";
        for (std::size_t at = picture.find(begin); at != std::string::npos;
             at = picture.find(begin, at + 1)) {
            const std::string points = picture.substr(at, picture.find('"', at + begin.size()) - at);
            count += std::count(points.begin(), points.end(), ',') > 5 ? 1U : 0U; // ticks have fewer
        }
        return count;
    };
    Recording whole = sample();
    for (std::size_t row = 10; row < whole.rows(); ++row) {
        whole.time_s[row] -= 1.0;
    }
    EXPECT_EQ(lines(sample()), lines(whole) + 4U); // each of four curves is in two pieces
}

} // namespace
} // namespace halbench::app
