#include "tests/widgets/gui_fixture.h"
#include "widgets/figure/figure_file.h"
#include "widgets/theme/theme_style.h"

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

/// The writer's date has the distance from UTC behind it, by which all that follows moves.
TEST_F(FigureFileTest, pdfIsTheSameInEveryTimeZone) {
    const QByteArray before = qgetenv("TZ");
    qputenv("TZ", "UTC");
    const QByteArray utc = content(PictureFormat::Pdf);
    for (const char* zone : {"Asia/Tokyo", "America/St_Johns", "XYZ-13:45"}) {
        qputenv("TZ", zone);
        const QByteArray there = content(PictureFormat::Pdf);
        EXPECT_EQ(there, utc) << zone;
        const int table = there.mid(there.lastIndexOf("startxref\n") + 10).split('\n').front().toInt();
        ASSERT_EQ(there.mid(table, 5), "xref\n") << zone;
        const QList<QByteArray> places = there.mid(table).split('\n');
        for (int object = 1; object < places[1].split(' ')[1].toInt(); ++object) {
            const int place = places[2 + object].left(10).toInt();
            EXPECT_TRUE(there.mid(place).startsWith(QByteArray::number(object) + " 0 obj")) << object;
        }
    }
    before.isNull() ? qunsetenv("TZ") : qputenv("TZ", before);
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
