#include "app/cli/loop_pictures.h"
#include "app/documents/text/output_file.h"
#include "app/figures/picture_file.h"
#include "tests/app/documents/published_estimate.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <utility>

namespace halbench::app {
namespace {

TuneResult judged(const std::string& method) {
    TuneConfig config;
    config.method = method;
    auto result = runTune(published(), config);
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? *std::move(result) : TuneResult();
}

TEST(LoopPictures, aViewAndAFileAreAskedFor) {
    const auto pictures = loopPicturesOf({"bode=a.svg", "root-locus=out/b=1.pdf"});
    ASSERT_TRUE(pictures);
    EXPECT_EQ((*pictures)[1].view, "root-locus");
    EXPECT_EQ((*pictures)[1].path, "out/b=1.pdf");
    for (const char* wrong : {"bode", "bode=", "=a.svg", "smith=a.svg", "bode=a.gif"}) {
        const auto refused = loopPicturesOf({wrong});
        ASSERT_FALSE(refused) << wrong;
        EXPECT_EQ(refused.error().code, ErrorCode::Usage);
        EXPECT_FALSE(refused.error().hint.empty());
    }
}

TEST(LoopPictures, everyViewIsWrittenInEveryFormat) {
    const QTemporaryDir folder;
    const TuneResult result = judged("recommended");
    const TuneResult slower = judged("lqr");
    const MotorEstimate motor = published();
    const auto path = [&](const std::string& name) { return folder.filePath(name.c_str()).toStdString(); };
    std::vector<LoopPicture> pictures;
    for (const std::string& view : loopViews()) {
        pictures.push_back({view, path(view + ".svg")});
    }
    pictures.push_back({"nyquist", path("n.pdf")});
    pictures.push_back({"bode", path("b.png")});
    const auto written =
        writeLoopPictures(pictures, {&result, &motor, {{"slower.json", &slower.predicted}}, {1000, 1}});
    ASSERT_TRUE(written) << written.error().message;
    for (const std::string& view : loopViews()) {
        const auto content = readFile(path(view + ".svg"));
        ASSERT_TRUE(content) << view;
        EXPECT_NE(content->find("<svg"), std::string::npos) << view;
        if (view != "disturbance") {
            EXPECT_NE(content->find("slower.json"), std::string::npos) << view; // the other one beside it
        }
    }
    EXPECT_EQ(readFile(path("n.pdf"))->substr(0, 5), "%PDF-");
    EXPECT_EQ(readFile(path("b.png"))->substr(1, 3), "PNG");
}

TEST(LoopPictures, anUnstableLoopHasItsBodeAndNoStep) {
    const QTemporaryDir folder;
    const TuneResult result = judged("published-degrees");
    const MotorEstimate motor = published();
    const std::string path = folder.filePath("x.svg").toStdString();
    EXPECT_TRUE(writeLoopPictures({{"bode", path}}, {&result, &motor, {}, {}}));
    for (const char* view : {"step", "sensitivity", "disturbance"}) {
        const auto refused = writeLoopPictures({{view, path}}, {&result, &motor, {}, {}});
        ASSERT_FALSE(refused) << view;
        EXPECT_EQ(refused.error().code, ErrorCode::Refused);
        EXPECT_NE(refused.error().message.find(view), std::string::npos);
    }
}

TEST(PictureFile, equalFiguresGiveEqualFiles) {
    widgets::Figure figure;
    figure.x = {"x", "s", false, {}, {}, {}};
    figure.panels.resize(1);
    figure.panels[0].curves = {{"y", {0.0, 1.0}, {0.0, 1.0}, widgets::CurveStyle::Line, {}}};
    for (const char* name : {"a.svg", "a.pdf", "a.png"}) {
        const auto one = figurePicture(figure, name);
        ASSERT_TRUE(one) << name;
        EXPECT_EQ(*one, *figurePicture(figure, name)) << name;
    }
    EXPECT_FALSE(figurePicture({}, "a.svg"));
}

} // namespace
} // namespace halbench::app
