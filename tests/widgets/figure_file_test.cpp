#include "tests/widgets/gui_fixture.h"
#include "widgets/figure_file.h"
#include "widgets/theme_style.h"

#include <QFile>
#include <QTemporaryDir>

namespace halbench::widgets {
namespace {

class FigureFileTest : public GuiTest {
protected:
    static Figure figure() {
        Figure made;
        made.title = "Test run";
        made.x = {"time", "s", false, {}, {}, {}};
        Panel panel;
        panel.y = {"field", "mT", false, {}, {}, {}};
        panel.curves = {{"Hall A", {0.0, 1.0, 2.0}, {1.0, -1.0, 0.5}, CurveStyle::Line, {}}};
        made.panels = {panel};
        return made;
    }
    static QByteArray content(PictureFormat format) {
        return pictureFile(figure(), currentTheme(), format).value();
    }
};

TEST_F(FigureFileTest, theEndOfTheNameSaysTheFormat) {
    EXPECT_EQ(pictureFormat("a/b.svg"), PictureFormat::Svg);
    EXPECT_EQ(pictureFormat("a/b.PDF"), PictureFormat::Pdf);
    EXPECT_EQ(pictureFormat("a/b.png"), PictureFormat::Png);
    EXPECT_EQ(pictureFormat("a/b.jpg"), std::nullopt);
    EXPECT_EQ(pictureFormat("svg"), std::nullopt);
}

TEST_F(FigureFileTest, svgKeepsTheAxisWithItsUnitAsText) {
    EXPECT_TRUE(content(PictureFormat::Svg).contains("field [mT]"));
}

TEST_F(FigureFileTest, pngHasTheDotsOfAPrinter) {
    const QImage picture = QImage::fromData(content(PictureFormat::Png), "PNG");
    EXPECT_EQ(picture.width(), 2750);          // 880 / 96 inch with 300 dots each
    EXPECT_EQ(picture.dotsPerMeterX(), 11811); // 300 / 0.0254 m
}

TEST_F(FigureFileTest, pdfHasLinesAndTextAndNoDate) {
    const QByteArray first = content(PictureFormat::Pdf);
    EXPECT_TRUE(first.startsWith("%PDF"));
    EXPECT_TRUE(first.contains("/CreationDate (D:00000000000000")); // the same picture is the same file
    EXPECT_TRUE(first.contains("/FontFile2"));                      // text as text
    EXPECT_FALSE(first.contains("/Subtype /Image"));                // nothing is pixels
    EXPECT_EQ(first, content(PictureFormat::Pdf));
}

TEST_F(FigureFileTest, pdfIsForPaperInEveryTheme) {
    const QByteArray light = content(PictureFormat::Pdf);
    dress("dark");
    EXPECT_EQ(content(PictureFormat::Pdf), light);
}

TEST_F(FigureFileTest, aFolderThatIsNotThereIsSaid) {
    const Result<void> done = pictureWriting(content(PictureFormat::Png), "/nowhere/a.png")();
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::FileSystem);
}

TEST_F(FigureFileTest, withoutAPanelThereIsNoPicture) {
    EXPECT_FALSE(pictureFile({}, currentTheme(), PictureFormat::Pdf));
}

} // namespace
} // namespace halbench::widgets
