#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/axes/time_axis_bar.h"

#include <QFontInfo>
#include <QPainter>
#include <QStyle>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include <cmath>

// How the plots of a stack stand above each other, and what they say of their axes and curves.

namespace halbench::widgets {
namespace {

TEST_F(LivePlotStackTest, allPlotsAndTheTimeAxisAlign) {
    const auto all = plots();
    ASSERT_EQ(all.size(), 5U);
    const QRect first = all.front()->canvasRect();
    for (const LivePlot* plot : all) {
        EXPECT_EQ(plot->mapTo(&stack, plot->canvasRect().topLeft()).x(), first.left());
        EXPECT_EQ(plot->canvasRect().width(), first.width());
    }
}

/// What QTableView paints of a name: its cell without the line sample and the margins around both.
int roomForName(const LiveLegend& legend) {
    const int margin = 2 * (legend.style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
    const auto sample = legend.model()->index(0, 0).data(Qt::DecorationRole).value<QPixmap>();
    return legend.columnWidth(LegendTableModel::Name) - 2 * margin -
           static_cast<int>(sample.width() / sample.devicePixelRatio());
}

void expectNamesAreWhole(const LiveLegend& legend) {
    for (int row = 0; row < legend.model()->rowCount(); ++row) {
        const QString name = legend.model()->index(row, LegendTableModel::Name).data().toString();
        EXPECT_LE(legend.fontMetrics().horizontalAdvance(name), roomForName(legend)) << name.toStdString();
    }
}

void expectTitleIsWhole(const LivePlot& plot) {
    const QwtText title = plot.axisTitle(QwtPlot::yLeft);
    EXPECT_EQ(title.text().simplified(), // the unit may stand below
              QStringLiteral("%1 [%2]").arg(plot.spec().quantity, plot.spec().unit));
    // Letters on their side are painted some pixels wider than they measure.
    EXPECT_LE(title.textSize().width() + PanelMargin_px, plot.axisWidget(QwtPlot::yLeft)->height());
    EXPECT_GE(title.font().pointSizeF(), 0.7 * QFontInfo(plot.font()).pointSizeF() - 1e-9);
}

TEST_F(LivePlotStackTest, nothingIsShortenedOnTheWindowsFirstSize) {
    std::vector<PlotSpec> specs = motorPlots(); // with the words of the window
    specs[4].quantity = QStringLiteral("temperature");
    for (PlotCurve& curve : specs[3].curves) {
        curve.label = QStringLiteral("Current command");
    }
    stack.setPlots(specs);
    stack.resize(730, 560); // what 1440 x 900 leaves for it
    // The letters of the window, and larger ones.
    for (const double size_pt : {1.25 * Dress().fontSize_pt, Dress().fontSize_pt}) {
        applyTheme(*qApp, loadTheme("light").value(), {QLocale(), size_pt});
        frame();
        frame();
        for (const LiveLegend* legend : legends()) {
            expectNamesAreWhole(*legend);
        }
        for (const LivePlot* plot : plots()) {
            expectTitleIsWhole(*plot);
            if (size_pt == Dress().fontSize_pt) {
                // Nearly half of the place is the data's: a second line of the title costs less than a title
                // cut off.
                EXPECT_GT(plot->canvas()->width(), 0.47 * stack.width());
            }
        }
    }
}

TEST_F(LivePlotStackTest, aLargeNumberIsWholeInTheLegendOfANarrowStack) {
    control::SampleHistory far{std::size_t{1} << 24};
    SampleBlock block;
    block.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"angle", "rad"}}, 0.001});
    for (int row = 0; row < 1000; ++row) {
        block.time_s.push_back(0.001 * row);
        block.values.push_back(-2345.678); // -134397.45 degrees, of many turns
    }
    far.append(block);
    stack.setHistory(&far);
    stack.resize(690, 560);
    stack.setCursorsVisible(true);
    frame();
    frame(); // the numbers of the first are known to the widths of the second
    const LiveLegend* legend = legends()[1];
    const QString value = legend->model()->index(0, LegendTableModel::Value).data().toString();
    EXPECT_EQ(value.size(), 10) << value.toStdString();
    // The live value may give way to the names; those at the cursors have room for the same number.
    for (const int column : {LegendTableModel::AtA, LegendTableModel::AtB, LegendTableModel::Difference}) {
        ASSERT_FALSE(legend->isColumnHidden(column));
        EXPECT_GE(legend->columnWidth(column), legend->fontMetrics().horizontalAdvance(value)) << column;
    }
    const QRect last = legend->visualRect(legend->model()->index(0, LegendTableModel::Unit));
    EXPECT_LE(last.right(), legend->viewport()->width());
    stack.setHistory(&history);
}

/// Of each curve, as they are drawn: with dots where the column is too narrow.
QStringList shownNames(const LiveLegend& legend) {
    QStringList names;
    for (int row = 0; row < legend.model()->rowCount(); ++row) {
        const QString name = legend.model()->index(row, LegendTableModel::Name).data().toString();
        names << legend.fontMetrics().elidedText(name, Qt::ElideRight, roomForName(legend));
    }
    return names;
}

TEST_F(LivePlotStackTest, besideCursorsANameIsNeverNarrowerThanWhatTellsItApart) {
    std::vector<PlotSpec> specs = motorPlots();
    specs[4].curves[0].label = QStringLiteral("Temperature of A");
    specs[4].curves[1].label = QStringLiteral("Temperature of B"); // told apart by their last letters
    for (const bool areCursorsShown : {false, true}) {
        for (const int width : {1200, 730, 690, 560}) {
            stack.setPlots(specs);
            stack.resize(width, 560);
            stack.setCursorsVisible(areCursorsShown);
            frame();
            frame();
            for (const LiveLegend* legend : legends()) {
                QStringList names = shownNames(*legend);
                const QString all = names.join(QStringLiteral(" | "));
                EXPECT_EQ(names.removeDuplicates(), 0) << width << ": " << all.toStdString();
                EXPECT_FALSE(names.contains(QString(QChar(0x2026)))) << width << ": " << all.toStdString();
                const QRect unit = legend->visualRect(legend->model()->index(0, LegendTableModel::Unit));
                EXPECT_LE(unit.right(), legend->viewport()->width()) << width << ": numbers are whole";
            }
        }
    }
}

TEST_F(LivePlotStackTest, besideCursorsInTheWindowsFirstSizeNamesAreWholeBeforeNow) {
    std::vector<PlotSpec> specs = motorPlots();
    specs[3].curves[0].label = QStringLiteral("Current");
    stack.setPlots(specs);
    stack.resize(730, 560); // what 1440 x 900 leaves for it
    stack.setCursorsVisible(true);
    frame();
    frame();
    for (const LiveLegend* legend : legends()) {
        EXPECT_TRUE(legend->isColumnHidden(LegendTableModel::Value)) << "those at the cursors are asked for";
        expectNamesAreWhole(*legend);
    }
    stack.setCursorsVisible(false);
    frame();
    EXPECT_FALSE(legends().front()->isColumnHidden(LegendTableModel::Value));
}

TEST_F(LivePlotStackTest, thatItIsPausedIsWholeBesideCursorsInTheWindowsFirstSize) {
    stack.resize(716, 560);
    stack.setCursorsVisible(true);
    trigger(LivePlotStack::Command::Pause);
    frame();
    const auto bars = stack.findChildren<TimeAxisBar*>();
    const auto said = std::find_if(bars.begin(), bars.end(), [](const TimeAxisBar* bar) {
        return bar->isVisible() && bar->state().contains("Paused for");
    });
    ASSERT_NE(said, bars.end());
    QString words = (*said)->state(); // for a while
    (*said)->setState(words.replace(QStringLiteral("0.0 s"), QStringLiteral("123.4 s")), true);
    EXPECT_EQ((*said)->shownState(), words);
    EXPECT_TRUE(words.contains("123.4 s")) << words.toStdString();
}

TEST_F(LivePlotStackTest, axesDoNotMoveWhileLabelsGrow) {
    const int before = plots().front()->canvasRect().left();
    stack.fitAll();
    frame();
    appendMotor(history, 5.0);
    frame();
    EXPECT_EQ(plots().front()->canvasRect().left(), before);
}

TEST_F(LivePlotStackTest, aLabelThatGrowsMovesAllAxesOnceAndNoneBack) {
    const auto layout = control::layoutOf({"angle"}, 0.001);
    std::size_t row = 31'000;
    std::vector<int> lefts;
    // From degrees to millions of them, and back: labels grow by digits and a sign, and get short again.
    for (int decade = 0; decade < 16; ++decade) {
        const double size = std::pow(10.0, decade < 8 ? decade : 15 - decade);
        history.append(control::blockOf(
            layout, row, 200, [&](std::size_t at, std::size_t) { return at % 2 == 0 ? -size : size; }));
        row += 200;
        frame();
        frame();
        const auto all = plots();
        for (const LivePlot* plot : all) {
            ASSERT_EQ(plot->canvasRect().left(), all.front()->canvasRect().left()) << decade;
            ASSERT_EQ(plot->canvasRect().right(), all.front()->canvasRect().right()) << decade;
        }
        if (!lefts.empty()) {
            ASSERT_GE(all.front()->canvasRect().left(), lefts.back()) << "nothing jumps back and forth";
        }
        lefts.push_back(all.front()->canvasRect().left());
    }
    EXPECT_GT(lefts.back(), lefts.front()); // or no label grew
    lefts.erase(std::unique(lefts.begin(), lefts.end()), lefts.end());
    EXPECT_LE(lefts.size(), 5U) << "a few steps for eight decades";
}

TEST_F(LivePlotStackTest, titlesChangeTheirFormForAllPlotsSoThatAxesAlign) {
    std::vector<PlotSpec> specs = motorPlots();
    specs.emplace_back(); // an empty plot has an axis as well
    stack.setPlots(specs);
    for (const int height : {1500, 560}) {
        stack.resize(1200, height);
        frame();
        frame();
        const auto all = plots();
        const int lines = all.front()->axisTitle(QwtPlot::yLeft).text().count(QLatin1Char('\n'));
        EXPECT_EQ(lines, height == 560 ? 1 : 0);
        for (const LivePlot* plot : all) {
            EXPECT_EQ(plot->axisTitle(QwtPlot::yLeft).text().count(QLatin1Char('\n')), lines);
            EXPECT_EQ(plot->canvasRect().left(), all.front()->canvasRect().left());
        }
    }
}

// A decimal comma that loses its tail at the edge of the axis is read as a point.
TEST_F(LivePlotStackTest, everyLabelOfAnAxisIsWholeAndANumberOfTheLocale) {
    const QLocale before;
    const QLocale german(QLocale::German, QLocale::Germany);
    QLocale::setDefault(german);
    LivePlotStack own;
    own.setTheme(loadTheme("light").value());
    own.setHistory(&history);
    PlotSpec spec = motorPlots().front();
    own.show();
    const ValueRange ranges[] = {{-0.55, 0.55}, {24.43, 25.6}, {-2400.0, 1200.0}, {-0.0012, 0.0007}};
    for (const ValueRange& range : ranges) {
        spec.fixedRange = range;
        own.setPlots({spec});
        for (int height_px = 150; height_px < 260; height_px += 3) { // where ticks stand changes with it
            own.resize(700, height_px);
            QApplication::processEvents();
            own.refresh();
            QApplication::processEvents();
            const auto* plot = own.findChild<LivePlot*>();
            const auto* axis = plot->axisWidget(QwtPlot::yLeft);
            const QFontMetrics metrics(axis->font());
            const int tail_px = metrics.tightBoundingRect(QStringLiteral(",")).bottom() + 1;
            ASSERT_GT(tail_px, 0);
            for (const double tick : plot->axisScaleDiv(QwtPlot::yLeft).ticks(QwtScaleDiv::MajorTick)) {
                const QString text = axis->scaleDraw()->label(tick).text();
                bool isNumber = false;
                // A step of 1e-3 is the finest here: the text has all of the tick's digits.
                EXPECT_NEAR(german.toDouble(text, &isNumber), tick, 1e-9) << text.toStdString();
                EXPECT_TRUE(isNumber) << text.toStdString();
                const QRect label = axis->scaleDraw()->boundingLabelRect(axis->font(), tick);
                EXPECT_LE(label.top() + label.height() + tail_px, axis->height() + 1)
                    << text.toStdString() << " at " << height_px;
            }
        }
    }
    QLocale::setDefault(before);
}

TEST_F(LivePlotStackTest, anEventIsTheZeroOfTheTimeAxisAndOfItsGrid) {
    const auto ticks = [&] {
        return plots().front()->axisScaleDiv(QwtPlot::xBottom).ticks(QwtScaleDiv::MajorTick);
    };
    stack.setEvent(12.3456);
    stack.showTimeRange({12.0, 13.0});
    frame();
    const QList<double> fromEvent = ticks();
    ASSERT_FALSE(fromEvent.isEmpty());
    EXPECT_TRUE(std::any_of(fromEvent.begin(), fromEvent.end(),
                            [](double tick) { return std::abs(tick - 12.3456) < 1e-9; }));
    stack.setEvent(std::nullopt);
    frame();
    const QList<double> plain = ticks();
    EXPECT_TRUE(
        std::any_of(plain.begin(), plain.end(), [](double tick) { return std::abs(tick - 12.0) < 1e-9; }));
}

/// A plot whose canvas is drawn on a picture, as the window's buffer is at a scale.
struct DrawnPlot : LivePlot {
    using LivePlot::drawCanvas;
};

/// A canvas promises the window that nothing shows through it, so each pixel of it must be painted wherever
/// it stands at each scale: what is left out keeps pieces of older frames.
TEST_F(LivePlotStackTest, aFramePaintsEachPixelOfTheCanvas) {
    DrawnPlot plot;
    plot.setTheme(loadTheme("light").value());
    plot.resize(400, 200);
    plot.updateLayout();
    const QColor left(Qt::magenta); // no colour of the theme
    for (const double ratio : {1.0, 1.0417, 1.25, 1.5, 2.0}) {
        for (int place = 0; place < 24; ++place) { // the parts of a pixel come again after 24
            const QRect canvas(QPoint(place, place), plot.canvas()->size());
            const QRectF whole(QPointF(canvas.topLeft()) * ratio, QSizeF(canvas.size()) * ratio);
            const auto first = static_cast<int>(std::lround(whole.left()));
            const auto right = static_cast<int>(std::lround(whole.right()));
            const auto bottom = static_cast<int>(std::lround(whole.bottom()));
            QImage seen(right, bottom, QImage::Format_RGB32);
            seen.setDevicePixelRatio(ratio);
            seen.fill(left);
            QPainter painter(&seen);
            painter.translate(canvas.topLeft());
            plot.drawCanvas(&painter);
            painter.end();
            EXPECT_NE(seen.pixelColor(right - 1, first), left) << place << " at " << ratio;
            EXPECT_NE(seen.pixelColor(first, bottom - 1), left) << place << " at " << ratio;
            EXPECT_NE(seen.pixelColor(first, first), left) << place << " at " << ratio;
        }
    }
}

TEST_F(LivePlotStackTest, theStateBelowANarrowPlotIsWholeBecauseTheTitleGivesWay) {
    TimeAxisBar bar;
    const int letter_px = bar.fontMetrics().averageCharWidth();
    bar.setRange({-1.0, 3.0}, 1.0, 0.0); // the longer title: time from the event
    bar.setState(QStringLiteral("Triggered view (End: live)"), true);
    for (const int canvas : {40, 60, 200}) { // in letters; the legend has thirty at its right
        bar.resize((10 + canvas + 30) * letter_px, bar.height());
        bar.setCanvas(10 * letter_px, canvas * letter_px);
        EXPECT_EQ(bar.shownState(), bar.state()) << canvas;
    }
    bar.resize(40 * letter_px, bar.height());
    bar.setCanvas(10 * letter_px, 30 * letter_px);
    EXPECT_NE(bar.shownState(), bar.state()); // here is room for neither
}

} // namespace
} // namespace halbench::widgets
