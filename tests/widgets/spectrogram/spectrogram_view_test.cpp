#include "tests/widgets/gui_fixture.h"
#include "widgets/spectrogram/spectrogram_view.h"
#include "widgets/theme/sequence_colours.h"

#include <QAction>
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <qwt_scale_widget.h>

#include <cmath>

namespace halbench::widgets {
namespace {

class SpectrogramViewTest : public GuiTest {
protected:
    void SetUp() override {
        view.resize(600, 400);
        view.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    }

    /// A second of 50 Hz between two of nothing, from 10 s on.
    static SpectrogramPicture tone() {
        SpectrogramPicture picture;
        picture.title = "Spectrogram of Hall A";
        picture.quantity = "amplitude";
        picture.unit = "mT";
        picture.time_s = {10.0, 11.0, 12.0};
        for (int line = 0; line < 11; ++line) {
            picture.frequency_Hz.push_back(10.0 * line);
        }
        picture.values.assign(33, 0.01);
        picture.values[11 + 5] = 3.0;
        return picture;
    }

    /// Whether a row of the colour bar's labels, counted from its lowest tick downwards, has ink.
    bool hasInkBelowLowestTick(int down_px) {
        QwtScaleWidget& bar = *view.axisWidget(QwtPlot::yRight);
        const QImage shown = bar.grab().toImage();
        const QwtScaleDiv& ticks = view.axisScaleDiv(QwtPlot::yRight);
        const int tick_px = static_cast<int>(bar.scaleDraw()->scaleMap().transform(ticks.lowerBound()));
        const double ratio = shown.devicePixelRatio();
        const int y = static_cast<int>(ratio * (tick_px + down_px));
        for (int x = shown.width() / 3; x < shown.width() - 2 && y < shown.height(); ++x) {
            if (shown.pixel(x, y) != shown.pixel(shown.width() - 1, y)) {
                return true;
            }
        }
        return false;
    }

    /// The colour at a place of the axes.
    QColor colourAt(double time_s, double frequency_Hz) {
        const QImage shown = view.canvas()->grab().toImage();
        const double ratio = shown.devicePixelRatio();
        return shown.pixelColor(static_cast<int>(ratio * view.transform(QwtPlot::xBottom, time_s)),
                                static_cast<int>(ratio * view.transform(QwtPlot::yLeft, frequency_Hz)));
    }

    SpectrogramView view;
};

TEST_F(SpectrogramViewTest, whatIsLoudIsBrightAndAtItsPlace) {
    view.setPicture(tone());
    const SequenceColours colours(true); // 0.01 to 10
    EXPECT_EQ(colourAt(11.0, 50.0).rgb(), colours.rgb({0.01, 10.0}, 3.0));
    EXPECT_EQ(colourAt(10.0, 50.0).rgb(), colours.rgb({0.01, 10.0}, 0.01));
    EXPECT_EQ(colourAt(11.0, 80.0).rgb(), colours.rgb({0.01, 10.0}, 0.01));
}

TEST_F(SpectrogramViewTest, aLogarithmicFrequencyHasTheLineAtItsPlace) {
    SpectrogramPicture picture = tone();
    picture.isFrequencyLogarithmic = true;
    view.setPicture(picture);
    // 5 Hz to 105 Hz: half a line beyond the outermost ones, without that at zero.
    EXPECT_DOUBLE_EQ(view.axisScaleDiv(QwtPlot::yLeft).lowerBound(), 5.0);
    const double height = view.canvas()->height() - 1.0;
    const double expected_px = height * (1.0 - std::log(50.0 / 5.0) / std::log(105.0 / 5.0));
    EXPECT_NEAR(view.transform(QwtPlot::yLeft, 50.0), expected_px, 1.5); // of whole pixels
    const SequenceColours colours(true);
    EXPECT_EQ(colourAt(11.0, 50.0).rgb(), colours.rgb({0.01, 10.0}, 3.0));
    EXPECT_EQ(colourAt(11.0, 46.0).rgb(), colours.rgb({0.01, 10.0}, 3.0)); // the line reaches to 45 Hz
    EXPECT_EQ(colourAt(11.0, 43.0).rgb(), colours.rgb({0.01, 10.0}, 0.01));
    EXPECT_TRUE(view.axisScaleDiv(QwtPlot::yLeft).ticks(QwtScaleDiv::MajorTick).contains(10.0));
    EXPECT_EQ(view.axisTitle(QwtPlot::yLeft).text(), "frequency [Hz]");
}

TEST_F(SpectrogramViewTest, onlyTheFrequenciesBetweenTheEndsAreShown) {
    SpectrogramPicture picture = tone();
    picture.lowest_Hz = 30.0;
    picture.highest_Hz = 70.0;
    view.setPicture(picture);
    EXPECT_DOUBLE_EQ(view.axisScaleDiv(QwtPlot::yLeft).lowerBound(), 30.0);
    EXPECT_DOUBLE_EQ(view.axisScaleDiv(QwtPlot::yLeft).upperBound(), 70.0);
    EXPECT_EQ(colourAt(11.0, 50.0).rgb(), SequenceColours(true).rgb({0.01, 10.0}, 3.0));
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_Up); // at the highest value, 50 Hz
    QTest::keyClick(&view, Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_TRUE(view.probeText().startsWith("11.000 s, 70 Hz")) << view.probeText().toStdString();
}

TEST_F(SpectrogramViewTest, theColoursAreSaidInDecibelsReOneOfTheUnitAndReachAsFarAsAsked) {
    SpectrogramPicture picture = tone();
    picture.decade_dB = 20.0;
    picture.darkest = 0.1;    // -20 dB
    picture.brightest = 10.0; // 20 dB
    view.setPicture(picture);
    EXPECT_EQ(view.axisTitle(QwtPlot::yRight).text(), "amplitude [dB re 1 mT]");
    const QwtScaleDiv& ticks = view.axisScaleDiv(QwtPlot::yRight);
    EXPECT_DOUBLE_EQ(ticks.lowerBound(), 0.1);
    EXPECT_DOUBLE_EQ(ticks.upperBound(), 10.0);
    QStringList labels;
    for (const double at : ticks.ticks(QwtScaleDiv::MajorTick)) {
        labels << view.axisScaleDraw(QwtPlot::yRight)->label(at).text();
    }
    EXPECT_TRUE(labels.contains("-20") && labels.contains("0") && labels.contains("20"))
        << labels.join(' ').toStdString();
    const SequenceColours colours(true);
    EXPECT_EQ(colourAt(11.0, 50.0).rgb(), colours.rgb({0.1, 10.0}, 3.0));
    EXPECT_EQ(colourAt(10.0, 50.0).rgb(), colours.rgb({0.1, 10.0}, 0.1)); // below the darkest
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_EQ(view.probeText(), "11.000 s, 50 Hz: 9.5 dB, 3 mT"); // 20 lg 3 = 9.54
}

TEST_F(SpectrogramViewTest, everyAxisHasQuantityAndUnit) {
    view.setPicture(tone());
    EXPECT_EQ(view.axisTitle(QwtPlot::xBottom).text(), "time [s]");
    EXPECT_EQ(view.axisTitle(QwtPlot::yLeft).text(), "frequency [Hz]");
    EXPECT_EQ(view.axisTitle(QwtPlot::yRight).text(), "amplitude [mT]");
    EXPECT_TRUE(view.axisWidget(QwtPlot::yRight)->isColorBarEnabled());
    EXPECT_EQ(view.accessibleName(), "Spectrogram of Hall A");
    EXPECT_TRUE(view.accessibleDescription().contains("11.000 s, 50 Hz: 3 mT"))
        << view.accessibleDescription().toStdString();
}

TEST_F(SpectrogramViewTest, theKeysWalkFromTheHighestValue) {
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(view.probeText(), ""); // nothing to walk in
    view.setPicture(tone());
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_EQ(view.probeText(), "11.000 s, 50 Hz: 3 mT");
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_EQ(view.probeText(), "11.000 s, 60 Hz: 0.01 mT");
    QTest::keyClick(&view, Qt::Key_Left);
    QTest::keyClick(&view, Qt::Key_Left); // stays at the end
    EXPECT_EQ(view.probeText(), "10.000 s, 60 Hz: 0.01 mT");
    QTest::keyClick(&view, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(view.probeText(), "10.000 s, 0 Hz: 0.01 mT");
}

TEST_F(SpectrogramViewTest, theMarkStaysAtItsTimeAndGoesWithIt) {
    view.setPicture(tone());
    QTest::keyClick(&view, Qt::Key_Right);
    SpectrogramPicture later = tone();
    later.time_s = {11.0, 12.0, 13.0};
    view.setPicture(later);
    EXPECT_TRUE(view.probeText().startsWith("11.000 s, 50 Hz")) << view.probeText().toStdString();
    later.time_s = {21.0, 22.0, 23.0};
    view.setPicture(later);
    EXPECT_EQ(view.probeText(), "");
}

TEST_F(SpectrogramViewTest, isSavedInEveryFormatAndCopied) {
    QTemporaryDir folder;
    EXPECT_FALSE(view.taken()(folder.filePath("none.png"))());
    view.setPicture(tone());
    for (const auto& [name, start] :
         {std::pair{"a.svg", "<?xml"}, std::pair{"a.pdf", "%PDF-"}, std::pair{"a.png", "\x89PNG"}}) {
        const QString path = folder.filePath(name);
        ASSERT_TRUE(view.taken()(path)());
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        EXPECT_TRUE(file.readAll().startsWith(start)) << name;
    }
    QSignalSpy asked(&view, &SpectrogramView::exportRequested);
    QTest::keyClick(&view, Qt::Key_E, Qt::ControlModifier);
    EXPECT_EQ(asked.count(), 1);
    QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->image().size(), 2 * view.size());
}

// A comma reaches below the digits: with its tail cut off it reads as the point of another language.
TEST_F(SpectrogramViewTest, theLowestLabelOfTheColourBarIsWhole) {
    const QLocale before;
    QLocale::setDefault(QLocale("de"));
    SpectrogramPicture picture = tone();
    picture.isLogarithmic = true;
    view.setPicture(picture);
    QTest::qWait(0);
    const int half_px = view.fontMetrics().ascent() / 2; // digits stand as far below the tick as above it
    EXPECT_TRUE(hasInkBelowLowestTick(half_px + 1));
    QLocale::setDefault(before);
}

} // namespace
} // namespace halbench::widgets
