#include "app/workspaces/parts/picture_scroll.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"

#include <QScrollArea>
#include <QVBoxLayout>

namespace halbench::app {
namespace {

class PictureScrollTest : public widgets::GuiTest {};

// Two rows of remarks and two steps of the grid are left for what stands below.
TEST_F(PictureScrollTest, theFigureFillsThePlaceWhateverItsSize) {
    widgets::VerdictView verdict;
    PictureScroll scroll(verdict);
    scroll.show();
    for (const QSize size : {QSize(600, 700), QSize(500, 320), QSize(900, 500)}) {
        scroll.resize(size);
        QCoreApplication::processEvents();
        const int place_px = scroll.findChild<QScrollArea*>()->viewport()->height();
        EXPECT_EQ(place_px, size.height());
        EXPECT_LE(scroll.picture().height(), place_px);
        EXPECT_GE(scroll.picture().height(), place_px - 4 * scroll.fontMetrics().lineSpacing());
    }
}

} // namespace
} // namespace halbench::app
