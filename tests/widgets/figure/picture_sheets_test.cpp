#include "tests/widgets/gui_fixture.h"
#include "widgets/figure/picture_sheets.h"
#include "widgets/theme/theme_style.h"

#include <QPainter>
#include <qwt_scale_map.h>

namespace halbench::widgets {
namespace {

class PictureSheetsTest : public GuiTest {
protected:
    static PictureSheet sheet(double largest) {
        PictureSheet made;
        made.figure.title = "Run";
        made.figure.x = {"time", "s", false, 0.0, 10.0, {}};
        Panel panel;
        panel.y = {"field", "mT", false, -largest, largest, {}};
        panel.curves = {{"Hall A", {0.0, 10.0}, {0.0, 0.0}, CurveStyle::Line, {}}};
        made.figure.panels = {panel};
        return made;
    }
};

TEST_F(PictureSheetsTest, figuresLieBelowEachOtherWithTheirCanvasesInLine) {
    const std::vector<PictureSheet> sheets{sheet(1.0), sheet(100000.0)}; // labels of other widths
    const PictureLayout layout = layOut(sheets, 880);
    EXPECT_EQ(layout.figures[0].panels[0].canvas.left(), layout.figures[1].panels[0].canvas.left());
    EXPECT_EQ(layout.figures[0].panels[0].canvas.right(), layout.figures[1].panels[0].canvas.right());
    EXPECT_GE(layout.tops_px[1], layout.figures[0].size.height());
    EXPECT_GE(layout.size.height(), layout.tops_px[1] + layout.figures[1].size.height());
}

TEST_F(PictureSheetsTest, columnsLieBesideEachOtherWithTheirSharesOfTheWidth) {
    std::vector<PictureSheet> sheets{sheet(1.0), sheet(1.0), sheet(100000.0)};
    sheets[1].figure.title.clear();
    sheets[2].figure.title.clear();
    sheets[2].column = 1;
    sheets[0].width_ratio = 0.8;
    sheets[2].width_ratio = 1.2;
    levelColumns(sheets, 880);
    const PictureLayout layout = layOut(sheets, 880);
    EXPECT_EQ(layout.lefts_px[0], 0);
    EXPECT_EQ(layout.lefts_px[1], 0);
    EXPECT_GE(layout.lefts_px[2], layout.figures[0].size.width());
    EXPECT_NEAR(layout.figures[2].size.width(), 1.5 * layout.figures[0].size.width(), 2.0);
    EXPECT_LE(layout.lefts_px[2] + layout.figures[2].size.width(), 880);
    const auto canvas = [&](std::size_t sheet) {
        return layout.figures[sheet].panels.front().canvas.translated(layout.lefts_px[sheet],
                                                                      layout.tops_px[sheet]);
    };
    EXPECT_EQ(canvas(2).top(), canvas(0).top()) << "no title, but the room of the first one's";
    EXPECT_EQ(canvas(2).bottom(), canvas(1).bottom()) << "the lower one has grown";
    EXPECT_EQ(layout.size.height(), layout.tops_px[2] + layout.figures[2].size.height());
}

TEST_F(PictureSheetsTest, aPictureThatIsTooNarrowHasAllBelowEachOther) {
    std::vector<PictureSheet> sheets{sheet(1.0), sheet(1.0), sheet(1.0)};
    sheets[1].column = 1;
    sheets[2].column = 2;
    const int before_px = sheets[0].figure.panels[0].height_px;
    levelColumns(sheets, 880);
    EXPECT_EQ(sheets[0].figure.panels[0].height_px, before_px);
    const PictureLayout narrow = layOut(sheets, 880);
    EXPECT_EQ(narrow.lefts_px, (std::vector<int>{0, 0, 0}));
    EXPECT_GE(narrow.tops_px[2], narrow.tops_px[1] + narrow.figures[1].size.height());
    EXPECT_EQ(narrow.figures[2].size.width(), 880);
    const PictureLayout wide = layOut(sheets, widthForColumns(3));
    EXPECT_LT(wide.lefts_px[1], wide.lefts_px[2]);
    EXPECT_EQ(widthForColumns(1), PictureWidth_px);
}

TEST_F(PictureSheetsTest, aNarrowColumnKeepsRoomForItsCurves) {
    std::vector<PictureSheet> sheets{sheet(1.0), sheet(1.0)};
    sheets[1].column = 1;
    sheets[1].width_ratio = 0.01;
    const PictureLayout layout = layOut(sheets, 880);
    EXPECT_GE(layout.figures[1].size.width(), 300);
    EXPECT_LE(layout.lefts_px[1] + layout.figures[1].size.width(), 880);
}

TEST_F(PictureSheetsTest, layersLieUnderAndOverTheCurvesOnThePanelsMapsAndNotBeyondIt) {
    std::vector<PictureSheet> sheets{sheet(1.0)};
    const auto fill = [](const QColor& colour, double fromTime_s, double toTime_s) {
        return
            [=](QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF&, const Theme&) {
                const QPointF from(x.transform(fromTime_s), y.transform(2.0)); // beyond the panel
                const QPointF to(x.transform(toTime_s), y.transform(-2.0));
                painter.fillRect(QRectF(from, to), colour);
            };
    };
    sheets[0].layers = {{fill(Qt::magenta, 2.0, 4.0), fill(Qt::cyan, 6.0, 8.0)}};
    const QImage image = sheetsImage(sheets, paperTheme(), 1.0);
    const QRectF canvas = layOut(sheets, PictureWidth_px).figures[0].panels[0].canvas;
    const auto at = [&](double time_s, double share) {
        return image.pixelColor(static_cast<int>(canvas.left() + 0.1 * time_s * canvas.width()),
                                static_cast<int>(canvas.top() + share * canvas.height()));
    };
    EXPECT_EQ(at(3.0, 0.31), QColor(Qt::magenta));
    EXPECT_NE(at(3.0, 0.5), QColor(Qt::magenta)) << "the curve at zero lies over it";
    EXPECT_EQ(at(7.0, 0.5), QColor(Qt::cyan)) << "and under this";
    EXPECT_NE(at(7.0, -0.02), QColor(Qt::cyan)) << "nothing leaves the panel";
}

TEST_F(PictureSheetsTest, everyFormatHasAllFiguresAndIsTheSameTwice) {
    const std::vector<PictureSheet> sheets{sheet(1.0), sheet(5.0)};
    const QByteArray svg = sheetsFile(sheets, paperTheme(), PictureFormat::Svg).value();
    EXPECT_EQ(svg.count("field [mT]"), 2);
    EXPECT_EQ(svg.count("<title>"), 1);
    for (const PictureFormat format : {PictureFormat::Svg, PictureFormat::Pdf, PictureFormat::Png}) {
        EXPECT_EQ(sheetsFile(sheets, paperTheme(), format).value(),
                  sheetsFile(sheets, paperTheme(), format).value());
    }
    EXPECT_FALSE(sheetsFile({}, paperTheme(), PictureFormat::Svg));
}

TEST_F(PictureSheetsTest, paperIsLightWhateverTheWindowWears) {
    dress("dark");
    EXPECT_EQ(paperTheme().name, "light");
}

} // namespace
} // namespace halbench::widgets
