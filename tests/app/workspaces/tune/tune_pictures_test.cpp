#include "app/workbench/shared_results.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSplitter>

namespace halbench::app {
namespace {

class TunePicturesTest : public TunePanelTest {};

TEST_F(TunePicturesTest, aWideWindowShowsTheOpenLoopBesideTheStep) {
    bench.setIdentification(publishedMotor());
    auto* splitter = panel.findChild<QSplitter*>();
    splitter->setStretchFactor(0, 1); // as the docks do with every splitter
    const auto isBoth = [&] {
        return figure("Open loop") != nullptr && figure("Open loop")->isVisible() &&
               figure("Predicted step with") != nullptr && figure("Predicted step with")->isVisible();
    };
    panel.resize(1500, 700);
    EXPECT_TRUE(wait(isBoth));
    EXPECT_LE(splitter->widget(0)->width(), splitter->widget(0)->minimumWidth() + 2);
    panel.resize(900, 700);
    EXPECT_TRUE(wait([&] { return figure("Open loop")->isVisible() && !isBoth(); }));
}

const TuneNumber& number(const std::vector<TuneNumber>& numbers, const QString& part) {
    const auto found = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const TuneNumber& each) { return each.name.contains(part); });
    EXPECT_NE(found, numbers.end()) << part.toStdString();
    return *found;
}

TEST_F(TunePicturesTest, theNumbersHaveTheirUnits) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    const auto numbers = tuneNumbers(*bench.design(), std::nullopt, {});
    // i_f/K_P = 1.434 A/(40 A/rad) = 2.05 degrees, of which the assist takes 90 %: what the analysis says
    const QString band = number(numbers, "band").proposed;
    EXPECT_TRUE(band.startsWith("\u00b1") && band.endsWith("\u00b0")) << band.toStdString();
    const auto radians =
        tuneNumbers(*bench.design(), std::nullopt, {widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond});
    EXPECT_TRUE(number(radians, "band").proposed.endsWith(" rad"));
    EXPECT_EQ(number(radians, "Step of").name, "Step of 1.75 rad: rise time");
    EXPECT_EQ(panel.findChild<TuneNumbers*>()->rowCount(), static_cast<int>(numbers.size()));
    EXPECT_TRUE(number(numbers, "Gain crossover").proposed.endsWith(" Hz"));
    DisplayUnits angular;
    angular.frequency = FrequencyUnit::RadiansPerSecond;
    const double crossover_rad_s = *bench.design()->predicted.margins.gainCrossover_rad_s;
    EXPECT_EQ(number(tuneNumbers(*bench.design(), std::nullopt, angular), "Gain crossover").proposed,
              widgets::numberText(crossover_rad_s, 3) + " rad/s");
}

TEST_F(TunePicturesTest, theFiguresOfAStepAreRowsOfOneNumberEach) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    TuneResult design = *bench.design();
    design.predicted.step->riseTime_s = 0.05;
    design.predicted.step->overshoot_percent = 12.5;
    design.predicted.step->settlingTime_s.reset();
    const auto numbers = tuneNumbers(design, std::nullopt, {});
    EXPECT_EQ(number(numbers, "Linear step: rise").proposed, "0.05 s");
    EXPECT_EQ(number(numbers, "Linear step: over").proposed, "12.5 %");
    EXPECT_EQ(number(numbers, "Linear step: settling").proposed, "\u2013"); // never: no number
    EXPECT_EQ(number(numbers, "Step of 100\u00b0: over").present, "");      // nothing is on a device
}

TEST_F(TunePicturesTest, marginsHaveTheIntervalOfTheIdentificationOrSayThatNoneIsKnown) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    TuneResult design = *bench.design();
    design.robust.isUncertain = true;
    design.robust.gainMargin_ratio = control::Robustness::Interval{4.1, 4.3};
    design.robust.phaseMargin_deg = control::Robustness::Interval{36.5, 39.0};
    design.robust.delayMargin_s = control::Robustness::Interval{0.0138, 0.0151};
    design.robust.modulusMargin = control::Robustness::Interval{0.55, 0.61};
    const auto known = tuneNumbers(design, std::nullopt, {});
    EXPECT_EQ(number(known, "Gain margin").interval, "4.1 to 4.3");
    EXPECT_EQ(number(known, "Phase margin").interval, "36.5 to 39");
    EXPECT_EQ(number(known, "Delay margin").interval, "13.8 to 15.1");
    EXPECT_EQ(number(known, "Modulus").interval, "0.55 to 0.61");
    EXPECT_TRUE(number(known, "Largest").interval.isEmpty()); // has none, which is something else
    design.robust = {};
    const auto unknown = tuneNumbers(design, std::nullopt, {});
    for (const char* margin : {"Gain margin", "Phase margin", "Delay margin", "Modulus"}) {
        EXPECT_EQ(number(unknown, margin).interval, "not known") << margin;
    }
}

TEST_F(TunePicturesTest, whatALoadDoesStandsAmongTheNumbersWithItsIntervalAndItsBand) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    const auto& disturbance = bench.design()->disturbance;
    ASSERT_TRUE(disturbance && disturbance->band && disturbance->step.recoveryTime_s);
    const auto numbers = tuneNumbers(*bench.design(), std::nullopt, {});
    EXPECT_TRUE(number(numbers, "Peak after a load step equal to 0.5 A").proposed.endsWith("\u00b0"));
    EXPECT_TRUE(number(numbers, "Peak after a load step equal to 0.5 A").interval.contains(" to "));
    EXPECT_TRUE(number(numbers, "Settling after load").proposed.startsWith("after "));
    TuneResult unknown = *bench.design();
    unknown.disturbance->band.reset();
    EXPECT_EQ(number(tuneNumbers(unknown, std::nullopt, {}), "Settling after load").interval, "not known");
    click(panel, "Disturbance");
    const auto& curves = figure("Load step equal to 0.5 A")->figure().panels.at(0).curves;
    EXPECT_TRUE(std::any_of(curves.begin(), curves.end(),
                            [](const auto& each) { return each.style == widgets::CurveStyle::Band; }));
}

TEST_F(TunePicturesTest, figuresAndGainsFollowThePreferredAngle) {
    prepare();
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); })) << message().toStdString();
    const auto unit = [&](const QString& title) { return figure(title)->figure().panels.at(0).y.unit; };
    for (const char* title : {"Predicted step with", "Predicted step of", "Verification"}) {
        EXPECT_EQ(unit(title), "rad") << title;
    }
    const double rad = curve("Verification", "measured").back();
    EXPECT_NE(button(panel, "Step of 1.75 rad"), nullptr);
    bench.setDisplayUnits({widgets::AngleUnit::Degree, SpeedUnit::TurnsPerMinute});
    ASSERT_TRUE(wait([&] { return unit("Predicted step with") == "deg"; }));
    EXPECT_EQ(unit("Predicted step of"), "deg");
    EXPECT_EQ(unit("Verification"), "deg");
    EXPECT_NEAR(curve("Verification", "measured").back(), rad * 180.0 / M_PI, 1e-9);
    EXPECT_NE(button(panel, "Step of 100\u00b0"), nullptr);
    EXPECT_TRUE(agreement().contains(QRegularExpression("max. deviation from the prediction [0-9.]+\u00b0")))
        << agreement().toStdString();
    EXPECT_NEAR(shown("gain.kp"), 40.0 / 57.29578, 1e-4);
    choose("Unit of the gains", "A/rad"); // in place
    EXPECT_NEAR(shown("gain.kp"), 40.0, 1e-4);
}

TEST_F(TunePicturesTest, everyPictureIsReachedByItsButtonAndTheArrowKeys) {
    prepare();
    EXPECT_FALSE(button(panel, "Verification")->isEnabled()); // nothing was measured
    click(panel, "Small step");
    EXPECT_TRUE(figure("Predicted step of")->isVisible());
    EXPECT_FALSE(figure("Open loop")->isVisible());
    QApplication::setActiveWindow(&panel);
    button(panel, "Small step")->setFocus();
    QTest::keyClick(button(panel, "Small step"), Qt::Key_Left);
    EXPECT_TRUE(figure("Predicted step with")->isVisible());
}

TEST_F(TunePicturesTest, theOpenLoopIsSeenInFiveWays) {
    prepare();
    choose("Open-loop plot", "Nyquist");
    ASSERT_NE(figure("Nyquist plot"), nullptr);
    EXPECT_TRUE(figure("Nyquist plot")->isVisible());
    choose("Open-loop plot", "Nichols");
    EXPECT_NE(figure("Nichols plot"), nullptr);
    choose("Open-loop plot", "Sensitivity");
    ASSERT_NE(figure("Sensitivity and closed loop"), nullptr);
    choose("Source of the gains", "Preset: published"); // the view stays
    EXPECT_TRUE(wait([&] { return bench.design() && bench.design()->law.gains.proportional == 10.0; }));
    EXPECT_NE(figure("Sensitivity and closed loop"), nullptr);
    choose("Open-loop plot", "Root locus");
    ASSERT_NE(figure("Root locus"), nullptr);
    EXPECT_TRUE(figure("Root locus")->isVisible());
    choose("Open-loop plot", "Bode");
    EXPECT_NE(figure("Open loop"), nullptr);
}

TEST_F(TunePicturesTest, theFrequencyThatIsReadStaysFromViewToView) {
    prepare();
    auto* view = const_cast<widgets::FigureView*>(figure("Open loop"));
    view->probeAlong(3.0);
    const double read_Hz = view->probedAlong().value();
    EXPECT_NEAR(read_Hz, 3.0, 0.05); // the nearest of 400 samples
    EXPECT_TRUE(view->probeText().contains("phase")) << view->probeText().toStdString();
    for (const char* other : {"Nyquist", "Nichols", "Sensitivity", "Bode"}) {
        choose("Open-loop plot", other);
        EXPECT_EQ(view->probedAlong(), read_Hz) << other;
    }
    choose("Open-loop plot", "Root locus"); // has none
    EXPECT_FALSE(view->probedAlong());
    choose("Open-loop plot", "Nyquist");
    EXPECT_EQ(view->probedAlong(), read_Hz);
}

TEST_F(TunePicturesTest, frequenciesAreInThePreferredUnitAndTheHandlesStayWhereTheyAre) {
    prepare();
    auto* view = const_cast<widgets::FigureView*>(figure("Open loop"));
    view->probeAlong(3.0);
    const double read_Hz = view->probedAlong().value();
    const auto place = view->handlePlace(0);
    const double crossover_Hz = view->handles().at(0).x;
    DisplayUnits units = bench.displayUnits();
    units.frequency = FrequencyUnit::RadiansPerSecond;
    bench.setDisplayUnits(units);
    EXPECT_EQ(view->figure().x.unit, "rad/s");
    EXPECT_NEAR(view->probedAlong().value(), 2.0 * M_PI * read_Hz, 1e-9);
    EXPECT_NEAR(view->handles().at(0).x, 2.0 * M_PI * crossover_Hz, 1e-9);
    ASSERT_TRUE(place && view->handlePlace(0));
    EXPECT_LE((*place - *view->handlePlace(0)).manhattanLength(), 3); // labels of other widths
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Right, Qt::ControlModifier); // two percent up
    EXPECT_TRUE(wait([&] {
        return std::abs(view->handles().at(0).x - 2.0 * M_PI * 1.02 * crossover_Hz) < 0.02 * crossover_Hz;
    }));
    choose("Open-loop plot", "Nyquist");
    EXPECT_EQ(view->figure().parameter->unit, "rad/s");
}

TEST_F(TunePicturesTest, thePhaseIsDrawnWithinHalfATurnWhenWanted) {
    prepare();
    const auto lowest = [&] {
        const auto& values = figure("Open loop")->figure().panels.at(1).curves.at(0).y;
        double low = 0.0;
        for (const double value : values) {
            low = std::isfinite(value) ? std::min(low, value) : low;
        }
        return low;
    };
    ASSERT_LT(lowest(), -185.0); // integral action
    auto* wrap = panel.findChild<widgets::FigureView*>()->parentWidget()->findChild<QCheckBox*>();
    ASSERT_NE(wrap, nullptr);
    wrap->setFocus();
    QTest::keyClick(wrap, Qt::Key_Space);
    EXPECT_GE(lowest(), -180.0);
    EXPECT_EQ(figure("Open loop")->figure().panels.at(1).y.max, 180.0);
    choose("Open-loop plot", "Nyquist");
    EXPECT_FALSE(wrap->isVisible()); // is of the Bode plot
}

TEST_F(TunePicturesTest, theNumbersOfAPictureAreSavedAsATable) {
    prepare();
    DisplayUnits units = bench.displayUnits();
    units.frequency = FrequencyUnit::RadiansPerSecond; // of what is drawn: files stay in Hz
    bench.setDisplayUnits(units);
    const QString path = m_folder.filePath("loop.csv");
    QString kinds;
    panel.setFileChooser({[&](QWidget*, const FileQuestion& question) {
                              kinds = question.filter;
                              return path;
                          },
                          {}});
    auto* view = const_cast<widgets::FigureView*>(figure("Open loop"));
    QApplication::setActiveWindow(&panel);
    view->setFocus();
    QTest::keyClick(view, Qt::Key_E, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return QFileInfo(path).size() > 1000; }));
    EXPECT_TRUE(kinds.contains("csv"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString header = QString::fromUtf8(file.readLine());
    EXPECT_TRUE(header.contains("frequency [Hz]") && header.contains("magnitude [dB]"))
        << header.toStdString();
    const QString first = QString::fromUtf8(file.readLine());
    EXPECT_EQ(first.count(','), header.count(','));
    EXPECT_NEAR(first.section(',', 0, 0).toDouble(), 0.01, 1e-9); // a loop of 100 Hz begins there
}

// Integral action takes the load over; with the published gains alone it moves farther.
TEST_F(TunePicturesTest, whatALoadDoesIsSeenBesideTheStep) {
    prepare();
    click(panel, "Disturbance");
    ASSERT_NE(figure("Load step equal to 0.5 A"), nullptr);
    EXPECT_TRUE(figure("Load step equal to 0.5 A")->isVisible());
    const auto peak = [&] {
        return figure("Load step equal to 0.5 A")->figure().panels.at(0).lines.at(0).at;
    };
    const double before_rad = peak();
    EXPECT_GT(before_rad, 0.5 / 40.0 * 0.5); // of the order of the load over K_P
    choose("Source of the gains", "Preset: published");
    EXPECT_TRUE(wait([&] { return peak() > 2.0 * before_rad; }));
}

TEST_F(TunePicturesTest, theTitlesOfThePicturesAreWholeInANarrowPanelToo) {
    prepare();
    panel.resize(700, 500);
    const QStringList titles = {"Open loop", "Step of 1.75 rad", "Small step", "Numbers", "Verification"};
    const auto areWhole = [&] {
        return std::all_of(titles.begin(), titles.end(), [&](const QString& title) {
            const QAbstractButton* chooser = button(panel, title);
            return chooser != nullptr && chooser->width() >= chooser->sizeHint().width();
        });
    };
    EXPECT_TRUE(wait(areWhole));
    const auto rowOf = [&](const char* title) { return button(panel, title)->mapTo(&panel, QPoint()).y(); };
    EXPECT_GT(rowOf("Verification"), rowOf("Open loop")); // they took another row
}

} // namespace
} // namespace halbench::app
