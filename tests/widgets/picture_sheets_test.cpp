#include "tests/widgets/gui_fixture.h"
#include "widgets/picture_sheets.h"
#include "widgets/theme_style.h"

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
