// A legend over its canvas is drawn when it looks different, not at each frame of the curves below it.
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"

#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QWidget>

#include <cstdlib>

namespace halbench::widgets {
namespace {

class CountingDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        ++painted;
        QStyledItemDelegate::paint(painter, option, index);
    }
    mutable int painted = 0;
};

class LegendPictureTest : public LivePlotStackTest {
protected:
    LegendPictureTest() {
        legend = legends().front();
        legend->setItemDelegate(&delegate);
        frame();
        QApplication::processEvents(); // the view lays itself out later
        legend->keepPicture();
        delegate.painted = 0;
    }
    ~LegendPictureTest() override { legend->setItemDelegate(nullptr); }
    /// What the canvas below does thirty times a second.
    void repaintCanvas() {
        plots().front()->canvas()->repaint(); // at once: no timer of the view comes between
    }
    /// Without the events of a resize that grab() sends.
    QImage seen() {
        QImage image(legend->viewport()->size(), QImage::Format_RGB32);
        image.fill(Qt::white);
        legend->viewport()->render(&image, {}, {}, QWidget::RenderFlags());
        return image;
    }

    CountingDelegate delegate;
    LiveLegend* legend = nullptr;
};

TEST_F(LegendPictureTest, aFrameOfTheCanvasDrawsNoItemOfTheLegendAnew) {
    ASSERT_TRUE(plots().front()->canvas()->geometry().intersects(legend->geometry()));
    repaintCanvas();
    EXPECT_EQ(delegate.painted, 0);
    legend->setTheme(loadTheme("light").value());
    repaintCanvas();
    EXPECT_GT(delegate.painted, 0);
}

TEST_F(LegendPictureTest, aChosenCurveAndNewNumbersAreDrawnAtOnce) {
    legend->setCurrentIndex(legend->model()->index(1, 0));
    QApplication::processEvents();
    EXPECT_GT(delegate.painted, 0);
    QApplication::processEvents();
    legend->keepPicture();
    delegate.painted = 0;
    std::vector<LegendNumbers> numbers(static_cast<std::size_t>(legend->model()->rowCount()));
    numbers.front().value = 1.25;
    legend->table().setNumbers(numbers);
    repaintCanvas();
    EXPECT_GT(delegate.painted, 0);
}

// A plot of a small screen at scale 2 is as high as four lines of text.
TEST_F(LegendPictureTest, rowsComeCloserWhereAllOfThemHaveRoomThen) {
    const int letters_px = legend->fontMetrics().height();
    const int rows = legend->model()->rowCount();
    ASSERT_GE(rows, 2);
    const int width_px = legend->width();
    legend->setInside(QRect(0, 0, width_px, 100 * letters_px), width_px);
    const int usual_px = legend->verticalHeader()->defaultSectionSize();
    EXPECT_GT(usual_px, letters_px);
    legend->setInside(QRect(0, 0, width_px, rows * letters_px + 2 * legend->frameWidth()), width_px);
    EXPECT_EQ(legend->verticalHeader()->defaultSectionSize(), letters_px);
    EXPECT_GE(legend->height(), rows * letters_px);
    // Where not even that is enough they are scrolled to, at their usual distance.
    legend->setInside(QRect(0, 0, width_px, rows * letters_px + 2 * legend->frameWidth() - 1), width_px);
    EXPECT_EQ(legend->verticalHeader()->defaultSectionSize(), usual_px);
}

TEST_F(LegendPictureTest, theKeptPictureIsWhatWouldBeDrawn) {
    const QImage kept = seen();
    ASSERT_EQ(delegate.painted, 0);
    legend->setTheme(loadTheme("light").value());
    const QImage anew = seen();
    ASSERT_GT(delegate.painted, 0);
    ASSERT_EQ(kept.size(), anew.size());
    constexpr int Rounding = 4; // of colours that are mixed in another order
    for (int y = 0; y < kept.height(); ++y) {
        for (int x = 0; x < kept.width(); ++x) {
            ASSERT_LE(std::abs(qGray(kept.pixel(x, y)) - qGray(anew.pixel(x, y))), Rounding) << x << " " << y;
        }
    }
}

} // namespace
} // namespace halbench::widgets
