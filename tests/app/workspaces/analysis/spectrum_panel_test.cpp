#include "app/procedures/move/move_procedure.h"
#include "app/workspaces/analysis/spectrogram_figure.h"
#include "app/workspaces/analysis/spectrum_panel.h"
#include "app/workspaces/parts/signal_box.h"
#include "control/base/units.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/figure/figure_view.h"
#include "widgets/spectrogram/spectrogram_view.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <qwt_scale_div.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using control::SpectrumScale;

SpectrumLook fieldLook() {
    SpectrumLook look;
    look.signal = "Hall A";
    look.quantity = displayQuantity("T", {});
    return look;
}

/// 3 mT at 12.5 Hz for 4 s at 1 kHz.
Result<control::Spectrum> sineSpectrum(SpectrumScale scale) {
    std::vector<double> time_s;
    std::vector<double> values;
    for (int row = 0; row < 4000; ++row) {
        time_s.push_back(0.001 * row);
        values.push_back(0.003 * std::sin(2.0 * Pi * 12.5 * time_s.back()));
    }
    control::SpectrumConfig config;
    config.scale = scale;
    return control::spectrum({time_s, values, "T"}, config);
}

TEST(SpectrumFigureTest, unitsFollowTheScale) {
    EXPECT_EQ(spectrumUnitText("mT", SpectrumScale::Peak), "mT");
    EXPECT_EQ(spectrumUnitText("mT", SpectrumScale::Density), QString::fromUtf8("mT\u00b2/Hz"));
    EXPECT_EQ(spectrumUnitText("mT", SpectrumScale::RootDensity), QString::fromUtf8("mT/\u221aHz"));
    EXPECT_EQ(spectrumUnitText("r/min", SpectrumScale::Density), QString::fromUtf8("(r/min)\u00b2/Hz"));
    EXPECT_EQ(spectrumUnitText(QString::fromUtf8("\u00b0C"), SpectrumScale::Rms), "K");
    EXPECT_EQ(spectrumUnitText("", SpectrumScale::Density), "1/Hz");
}

TEST(SpectrumFigureTest, aSineReadsItsAmplitudeInTheUnitShown) {
    const auto spectrum = sineSpectrum(SpectrumScale::Peak);
    ASSERT_TRUE(spectrum);
    const auto peaks = spectrumPeaks(*spectrum, fieldLook(), 3);
    ASSERT_FALSE(peaks.empty());
    EXPECT_NEAR(peaks[0].frequency_Hz, 12.5, 1e-9); // 50 whole periods: on a line
    EXPECT_NEAR(peaks[0].value, 3.0, 1e-6);         // mT
    const widgets::Figure figure = spectrumFigure(*spectrum, fieldLook());
    EXPECT_EQ(figure.panels.at(0).y.unit, "mT");
    EXPECT_EQ(figure.x.unit, "Hz");
}

TEST(SpectrumFigureTest, theDensityIntegratesToTheMeanSquareInTheUnitShown) {
    const auto spectrum = sineSpectrum(SpectrumScale::Density);
    ASSERT_TRUE(spectrum);
    SpectrumLook look = fieldLook();
    look.isValueLogarithmic = false;
    const widgets::Curve curve = spectrumFigure(*spectrum, look).panels.at(0).curves.at(0);
    double sum = 0.0;
    for (const double value : curve.y) {
        sum += value * spectrum->lineDistance_Hz();
    }
    EXPECT_NEAR(sum, 0.5 * 3.0 * 3.0, 0.01); // mT^2; segments cut the sine's period by a part of a line
}

TEST(SpectrumFigureTest, aLogarithmicAxisHasNoZero) {
    const auto spectrum = sineSpectrum(SpectrumScale::Peak);
    ASSERT_TRUE(spectrum);
    SpectrumLook look = fieldLook();
    look.isFrequencyLogarithmic = true;
    const widgets::Figure figure = spectrumFigure(*spectrum, look);
    for (const double frequency_Hz : figure.panels.at(0).curves.at(0).x) {
        EXPECT_GT(frequency_Hz, 0.0);
    }
}

TEST(SpectrumFigureTest, saysResolutionAveragesAndTotal) {
    const auto spectrum = sineSpectrum(SpectrumScale::Peak);
    ASSERT_TRUE(spectrum);
    const QString words = spectrumWords(*spectrum, fieldLook());
    EXPECT_TRUE(words.contains("Bin width 0.25 Hz, resolution 0.375 Hz")) << words.toStdString(); // Hann: 1.5
    EXPECT_TRUE(words.contains("; 1 average(s); ")) << words.toStdString();
    EXPECT_TRUE(words.contains("rms of all lines 2.121 mT")) << words.toStdString(); // 3/sqrt(2)
    EXPECT_FALSE(words.contains("gaps"));
}

/// Rows at 1 kHz with the given phase.
template <typename Phase>
SignalStretch stretchOf(int rows, Phase phase) {
    SignalStretch stretch;
    stretch.unit = "T";
    for (int row = 0; row < rows; ++row) {
        stretch.time_s.push_back(0.001 * row);
        stretch.values.push_back(0.003 * std::sin(phase(stretch.time_s.back())));
    }
    return stretch;
}

TEST(SpectrogramFigureTest, withoutALengthThereAreAsManySegmentsAsLines) {
    const auto made = spectrogramOf(stretchOf(10000, [](double t) { return 2.0 * Pi * 50.0 * t; }), {});
    ASSERT_TRUE(made);
    // 200 rows each: 101 lines, and 99 segments half over each other.
    EXPECT_NEAR(static_cast<double>(made->frequency_Hz.size()), 101.0, 6.0); // the nearest fast length
    EXPECT_NEAR(static_cast<double>(made->time_s.size()), 99.0, 6.0);
}

TEST(SpectrogramFigureTest, theRidgeOfAChirpIsItsFrequencyInTheUnitShown) {
    control::SpectrumConfig config;
    config.segment_s = 0.5;
    const auto made = spectrogramOf(
        stretchOf(20000, [](double t) { return 2.0 * Pi * (30.0 * t + 0.5 * 4.0 * t * t); }), config);
    ASSERT_TRUE(made);
    const widgets::SpectrogramPicture picture = spectrogramPicture(*made, SpectrumScale::Peak, fieldLook());
    EXPECT_EQ(picture.unit, "mT");
    EXPECT_EQ(picture.title, "Spectrogram of Hall A");
    for (std::size_t column = 0; column < picture.time_s.size(); ++column) {
        std::size_t ridge = 0;
        for (std::size_t line = 1; line < picture.frequency_Hz.size(); ++line) {
            ridge = picture.value(column, line) > picture.value(column, ridge) ? line : ridge;
        }
        EXPECT_NEAR(picture.frequency_Hz[ridge], 30.0 + 4.0 * picture.time_s[column], picture.lineStep_Hz());
        // Hann reads a sine half way between two lines as 0.849 of it; the sweep over one line in a segment
        // takes 0.7 % more.
        EXPECT_LE(picture.value(column, ridge), 3.0 * 1.001);
        EXPECT_GE(picture.value(column, ridge), 3.0 * 0.84);
    }
}

class SpectrumPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<SpectrumPanel>(bench());
        panel->resize(900, 700);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }
    void TearDown() override { panel.reset(); }

    void swing() {
        session().runProcedure(
            "Move",
            [](devices::Device& device, const ProcedureObserver& observer) {
                MoveConfig config;
                config.reference = *parseMoveReference("sine,amplitude_deg=20,period_s=0.5");
                config.duration_s = 20.0;
                return runMove(device, config, observer);
            },
            [](const Result<MoveResult>& moved) {
                EXPECT_TRUE(moved || moved.error().code == ErrorCode::Interrupted) << moved.error().message;
            });
    }
    QTableWidget& peaks() { return *find<QTableWidget>(*panel, "Highest peaks"); }
    QString words() { return find<QLabel>(*panel, "Summary of the spectrum")->text(); }
    widgets::SpectrogramView& gram() { return *panel->findChild<widgets::SpectrogramView*>(); }
    widgets::FigureView& view() { return *panel->findChild<widgets::FigureView*>(); }

    std::unique_ptr<SpectrumPanel> panel;
};

TEST_F(SpectrumPanelTest, withoutADeviceItOffersTheSimulatedMotor) {
    QSignalSpy asked(panel.get(), &SpectrumPanel::connectRequested);
    click(*panel, "Connect the simulated motor");
    EXPECT_EQ(asked.count(), 1);
    connectTo("sim:htm", 5.0);
    EXPECT_FALSE(panel->findChild<widgets::EmptyState*>()->isVisible());
}

TEST_F(SpectrumPanelTest, aMotorThatSwingsHasItsFrequencyAsTheHighestPeak) {
    connectTo("sim:htm", 0.0); // as fast as possible: a busy machine changes nothing
    swing();
    panel->findChild<SignalBox*>()->choose("reference");
    // Ten seconds of it: lines every 0.1 Hz. The peak is on the line of 2 Hz.
    const auto hasPeak = [&] {
        return peaks().rowCount() > 0 && std::fabs(peaks().item(0, 0)->text().toDouble() - 2.0) < 0.06 &&
               std::fabs(peaks().item(0, 1)->text().toDouble() - 20.0) < 1.0; // degrees, the amplitude
    };
    EXPECT_TRUE(wait(hasPeak)) << words().toStdString();
    EXPECT_TRUE(words().contains("Bin width")) << words().toStdString();
    EXPECT_FALSE(view().isEmpty());
}

/// A number that is cut is another number.
TEST_F(SpectrumPanelTest, theListOfPeaksIsAsWideAsItsLongestUnit) {
    connectTo("sim:htm", 5.0);
    panel->findChild<SignalBox*>()->choose("speed");
    for (QComboBox* box : panel->findChildren<QComboBox*>()) {
        if (box->accessibleName() == "Quantity") {
            box->setFocus();
            QTest::keyClick(box, Qt::Key_P); // power density
        }
    }
    ASSERT_TRUE(wait([&] {
        return peaks().rowCount() > 0 && peaks().horizontalHeaderItem(1)->text().contains("/Hz");
    })) << words().toStdString();
    EXPECT_LE(peaks().horizontalHeader()->length(), peaks().viewport()->width());
}

TEST_F(SpectrumPanelTest, holdKeepsThePictureAndItsCursor) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return !view().isEmpty(); }));
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_H);
    QTest::qWait(300); // what was under way
    const auto before = view().figure().panels.at(0).curves.at(0).y;
    QTest::keyClick(&view(), Qt::Key_Right);
    const QString read = view().probeText();
    EXPECT_TRUE(read.contains("Hz")) << read.toStdString();
    QTest::qWait(700);
    EXPECT_EQ(view().figure().panels.at(0).curves.at(0).y, before);
    EXPECT_EQ(view().probeText(), read);
    QTest::keyClick(&view(), Qt::Key_H);
    EXPECT_TRUE(wait([&] { return view().figure().panels.at(0).curves.at(0).y != before; }));
}

TEST_F(SpectrumPanelTest, axesAreSwitchedByKeyAndTheUnitByTheKind) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return !view().isEmpty(); }));
    EXPECT_TRUE(view().figure().panels.at(0).y.isLogarithmic);
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Y);
    EXPECT_FALSE(view().figure().panels.at(0).y.isLogarithmic);
    QTest::keyClick(&view(), Qt::Key_X);
    EXPECT_TRUE(view().figure().x.isLogarithmic);
    auto* kind = find<QComboBox>(*panel, "Quantity");
    kind->setCurrentIndex(2);
    Q_EMIT kind->activated(2);
    EXPECT_TRUE(wait([&] {
        return !view().isEmpty() &&
               view().figure().panels.at(0).y.unit == QString::fromUtf8("(r/min)\u00b2/Hz").toStdString();
    }));
    EXPECT_TRUE(words().contains("95 % interval")) << words().toStdString();
}

TEST_F(SpectrumPanelTest, overTimeItIsASpectrogramOfTheSameSettings) {
    connectTo("sim:htm", 0.0); // as fast as possible: a busy machine changes nothing
    panel->findChild<SignalBox*>()->choose("reference");
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_O);
    auto* segment = find<widgets::QuantityEdit>(*panel, "Segment");
    type(segment, "2");
    QTest::keyClick(segment, Qt::Key_Return);
    swing();
    // 20 degrees at 2 Hz, in segments of whole periods: on a line, as high as the amplitude.
    EXPECT_TRUE(wait([&] {
        const widgets::SpectrogramPicture& shown = gram().picture();
        const widgets::SpectrogramCell highest = widgets::highestCell(shown);
        return !shown.isEmpty() && std::fabs(shown.lineStep_Hz() - 0.5) < 0.01 &&
               std::fabs(shown.frequency_Hz[highest.line] - 2.0) < 0.1 &&
               std::fabs(shown.value(highest.column, highest.line) - 20.0) < 1.0;
    })) << words().toStdString();
}

TEST_F(SpectrumPanelTest, aKeySwitchesBetweenAllAtOnceAndOverTime) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return !view().isEmpty(); }));
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_O);
    ASSERT_TRUE(wait([&] { return !gram().isEmpty(); })) << words().toStdString();
    EXPECT_TRUE(gram().isVisible());
    EXPECT_FALSE(view().isVisible());
    EXPECT_EQ(panel->focusWidget(), &gram());
    EXPECT_EQ(gram().picture().unit, "r/min");
    EXPECT_TRUE(words().contains("one every")) << words().toStdString();
    EXPECT_TRUE(gram().picture().isLogarithmic);
    QTest::keyClick(&gram(), Qt::Key_Y);
    EXPECT_FALSE(gram().picture().isLogarithmic);
    QTest::keyClick(&gram(), Qt::Key_O);
    EXPECT_TRUE(view().isVisible());
    EXPECT_EQ(panel->focusWidget(), &view());
}

TEST_F(SpectrumPanelTest, theSpectrogramsEndsAreTypedAndItsColoursAreInDecibels) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return !view().isEmpty(); }));
    auto* lowest = find<widgets::OptionalNumberEdit>(*panel, "Min. [Hz]");
    auto* highest = find<widgets::OptionalNumberEdit>(*panel, "Max. [Hz]");
    auto* darkest = find<widgets::OptionalNumberEdit>(*panel, "Colour scale min");
    EXPECT_FALSE(lowest->isVisible());
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_O);
    ASSERT_TRUE(wait([&] { return !gram().isEmpty(); })) << words().toStdString();
    EXPECT_TRUE(lowest->isVisible());
    const auto enter = [](QLineEdit* edit, const QString& text) {
        type(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    };
    enter(lowest, "20");
    enter(highest, "80");
    EXPECT_EQ(widgets::frequencyRange(gram().picture()), (widgets::ValueRange{20.0, 80.0}));
    EXPECT_DOUBLE_EQ(gram().axisScaleDiv(QwtPlot::yLeft).upperBound(), 80.0);
    gram().setFocus();
    QTest::keyClick(&gram(), Qt::Key_X);
    EXPECT_TRUE(gram().picture().isFrequencyLogarithmic);
    enter(darkest, "0.01");
    EXPECT_DOUBLE_EQ(widgets::colourRange(gram().picture()).low, 0.01);
    gram().setFocus();
    QTest::keyClick(&gram(), Qt::Key_D);
    EXPECT_EQ(gram().axisTitle(QwtPlot::yRight).text(), "amplitude [dB re 1 r/min]");
    EXPECT_DOUBLE_EQ(*darkest->value(), -40.0); // 20 lg 0.01
    EXPECT_NEAR(widgets::colourRange(gram().picture()).low, 0.01, 1e-15);
    auto* scale = find<QComboBox>(*panel, "Quantity");
    scale->setCurrentIndex(2); // a power
    Q_EMIT scale->activated(2);
    EXPECT_TRUE(wait([&] { return gram().picture().unit.endsWith("Hz"); }));
    EXPECT_FALSE(darkest->value()) << "it was another quantity's";
    EXPECT_EQ(gram().picture().decade_dB, 10.0);
    enter(highest, "10");
    EXPECT_TRUE(words().startsWith("The lowest frequency must be below the highest"))
        << words().toStdString();
    QTest::keyClick(&gram(), Qt::Key_O);
    EXPECT_FALSE(lowest->isVisible());
}

TEST_F(SpectrumPanelTest, aSegmentLongerThanTheStretchIsRefusedInWords) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return !view().isEmpty(); }));
    auto* segment = find<widgets::QuantityEdit>(*panel, "Segment");
    type(segment, "500");
    QTest::keyClick(segment, Qt::Key_Return);
    EXPECT_TRUE(wait([&] { return view().isEmpty(); }));
    EXPECT_FALSE(words().isEmpty());
}

TEST_F(SpectrumPanelTest, asksForItsSignalOnlyWhileItIsSeen) {
    connectTo("sim:htm", 5.0);
    panel->findChild<SignalBox*>()->choose("truth.speed");
    EXPECT_TRUE(wait([&] { return bench().history().latest("truth.speed").has_value(); }));
    panel->hide();
    const auto& streamed = bench().liveSignals().streamed();
    EXPECT_EQ(std::count(streamed.begin(), streamed.end(), "truth.speed"), 0);
}

TEST_F(SpectrumPanelTest, thePictureIsSaved) {
    QTemporaryDir folder;
    const QString path = folder.filePath("spectrum.svg");
    panel->setFileChooser({[&](QWidget*, const FileQuestion&) { return path; }, {}});
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return !view().isEmpty(); }));
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_E, Qt::ControlModifier);
    EXPECT_TRUE(wait([&] { return QFile::exists(path); }));
}

} // namespace
} // namespace halbench::app
