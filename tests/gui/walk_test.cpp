#include "app/window/docks/dock_layout.h"
#include "app/window/help/help_window.h"
#include "app/window/preferences/language.h"
#include "app/window/preferences/preferences_dialog.h"
#include "app/wizards/calibrate_panel.h"
#include "app/workbench/drive_control.h"
#include "app/workbench/recording_control.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/parts/page_chooser.h"
#include "app/workspaces/recordings/import_view.h"
#include "app/workspaces/tune/loop/filter_editor.h"
#include "tests/app/window/window_test.h"
#include "tests/gui/inspection.h"
#include "widgets/controls/stop_button.h"

#include <QAbstractButton>
#include <QAbstractEventDispatcher>
#include <QButtonGroup>
#include <QCheckBox>
#include <QFile>
#include <QMenuBar>
#include <QPushButton>
#include <QTabWidget>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/FloatingDockContainer.h>

#include <algorithm>

namespace halbench::gui {
namespace {

using app::Perspective;

struct Walk {
    const char* language;
    app::ThemeChoice theme;
};

/// The whole window on the simulated motor as its users see it. The scale comes from QT_SCALE_FACTOR.
class WalkTest : public app::WindowTest, public testing::WithParamInterface<Walk> {
protected:
    ~WalkTest() override { QLocale::setDefault(QLocale::c()); }

    void openDressed() {
        app::speak(application, GetParam().language);
        phrases = phrasesOf(GetParam().language);
        const auto theme = widgets::loadTheme(app::themeName(GetParam().theme).toStdString());
        ASSERT_TRUE(theme);
        widgets::applyTheme(application, *theme, {QLocale(), widgets::Dress().fontSize_pt});
        app::Preferences preferences;
        preferences.theme = GetParam().theme;
        preferences.language = GetParam().language;
        open(preferences);
        window->resize(SmallScreen);
    }

    void look(const QString& place) { look(*window, place); }

    /// A frame of the window, by hand, and all the work that follows from it. Bounded: a live window posts
    /// more and more.
    void showFrame() {
        constexpr int MostRounds = 20;
        window->bench().drainSamples();
        for (int round = 0; round < MostRounds; ++round) {
            if (!QAbstractEventDispatcher::instance()->processEvents(QEventLoop::AllEvents)) {
                break; // nothing is due any more
            }
        }
    }

    /// What stays wrong: what changes just now gets its room with the next frames, or when another thread has
    /// computed it, however busy the machine is.
    QStringList settled(QWidget& shown) {
        showFrame();
        QStringList found = inspect(shown, phrases);
        constexpr int Lasting_ms = 5000; // is waited for where something is wrong for good, and there alone
        (void)QTest::qWaitFor(
            [&] {
                showFrame();
                const QStringList still = found.isEmpty() ? found : inspect(shown, phrases);
                found.erase(std::remove_if(found.begin(), found.end(),
                                           [&](const QString& one) { return !still.contains(one); }),
                            found.end());
                return found.isEmpty();
            },
            Lasting_ms);
        return found;
    }

    void look(QWidget& shown, const QString& place) {
        const QStringList found = settled(shown);
        for (const QString& finding : found + inspectKeys(shown)) {
            note(place, finding);
        }
        const auto* stop = shown.findChild<widgets::StopButton*>();
        const QRect where(stop->mapTo(&shown, QPoint()), stop->size());
        if (!stop->isVisible() || !shown.rect().contains(where)) {
            note(place, "STOP is not in sight");
        }
    }

    /// The panel alone: what is around it was seen.
    void lookInside(const char* panel, const QString& place) {
        QWidget& shown = *window->docks().panel(panel);
        for (const QString& finding : settled(shown)) {
            note(place, finding);
        }
    }

    /// Every page that the panel has within itself.
    int lookAtPages(const char* panel, const QString& place) {
        int seen = 0;
        for (auto* tabs : window->docks().panel(panel)->findChildren<QTabWidget*>()) {
            for (int page = 0; page < tabs->count() && tabs->isVisible(); ++page) {
                tabs->setCurrentIndex(page);
                lookInside(panel, QStringLiteral("%1/tab %2").arg(place).arg(page));
                ++seen;
            }
        }
        for (auto* chooser : window->docks().panel(panel)->findChildren<app::PageChooser*>()) {
            for (QAbstractButton* choice : chooser->findChildren<QAbstractButton*>()) {
                if (choice->isCheckable() && choice->isEnabled() && choice->isVisible() &&
                    choice->group() != nullptr) {
                    choice->click();
                    lookInside(panel, place + QLatin1Char('/') + choice->text());
                    ++seen;
                }
            }
        }
        return seen;
    }

    /// What stands around gains in the Tune panel, one filter of each kind.
    void lookAtFilters() {
        auto* filters = window->docks().panel("tune")->findChild<app::FilterEditor*>();
        control::FilteredLaw filtered;
        filtered.filters = {control::LeadFilter{50.0, 20.0}, control::LagFilter{2.0, 2.0},
                            control::NotchFilter{150.0, 0.3, 0.5}, control::LowPassFilter{250.0, 1}};
        filters->setShaping(filtered);
        lookInside("tune", "tune/filters");
        filters->setShaping(std::nullopt);
    }

    void check(const char* panel, const char* key) {
        for (QAction* action : window->docks().panel(panel)->findChildren<QAction*>()) {
            if (action->isCheckable() && action->shortcut() == QKeySequence(QLatin1String(key))) {
                action->setChecked(true);
                return;
            }
        }
        ADD_FAILURE() << panel << " has no switch " << key;
    }

    void note(const QString& place, const QString& finding) {
        if (!findings.contains(finding)) {
            findings << finding;
            ADD_FAILURE() << place.toStdString() << ": " << finding.toStdString();
        }
    }

    QPushButton* button(const char* panel, const char* context, const char* text) {
        const QString words = QCoreApplication::translate(context, text);
        for (auto* found : window->docks().panel(panel)->findChildren<QPushButton*>()) {
            if (found->text() == words) {
                return found;
            }
        }
        return nullptr;
    }

    static constexpr int Fit_ms = 120000;
    static constexpr QSize SmallScreen{1366, 768};
    QHash<QString, QString> phrases;
    QStringList findings;
};

TEST_P(WalkTest, findsNothingWrongInAnyPerspective) {
    openDressed();
    look("without a device");
    connectMotor(1.0);
    for (const Perspective perspective : app::AllPerspectives) {
        window->docks().setPerspective(perspective);
        for (ads::CDockWidget* dock : window->docks().docks()) {
            if (!dock->isClosed()) {
                dock->setAsCurrentTab();
                look(app::perspectiveId(perspective) + '/' + dock->objectName());
            }
        }
    }
    for (const Perspective perspective : app::AllPerspectives) { // again: what was seen may have grown
        window->docks().setPerspective(perspective);
        QTest::qWait(50);
        EXPECT_LE(window->width(), SmallScreen.width()) << app::perspectiveId(perspective).toStdString();
        EXPECT_LE(window->height(), SmallScreen.height()) << app::perspectiveId(perspective).toStdString();
    }
}

TEST_P(WalkTest, findsNothingWrongInMenusAndHelp) {
    openDressed();
    for (QAction* action : window->menuBar()->actions()) {
        for (const QString& finding : inspectMenu(*action->menu(), phrases)) {
            note("menu", finding);
        }
    }
    app::HelpWindow help("monitor.md");
    help.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
    for (const QString& finding : inspect(help, phrases)) {
        note("help", finding);
    }
}

TEST_P(WalkTest, findsNothingWrongInResultsNorWhenStopped) {
    openDressed();
    connectMotor(0.0); // as fast as possible
    window->docks().setPerspective(Perspective::Identify);
    QPushButton* start = button("identify", "halbench::app::IdentifyPanel", "Start identification");
    ASSERT_NE(start, nullptr);
    ASSERT_TRUE(wait([&] { return start->isEnabled(); }));
    QTest::mouseClick(start, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->bench().identification().has_value(); }, Fit_ms));
    session().setPace({1.0});
    for (auto* tabs : window->docks().panel("identify")->findChildren<QTabWidget*>()) {
        for (int page = 0; page < tabs->count(); ++page) {
            tabs->setCurrentIndex(page);
            look(QStringLiteral("identify/result %1").arg(page));
        }
    }
    window->docks().setPerspective(Perspective::Tune);
    look("tune/design");
    lookAtFilters();
    // Open loop and step stand side by side; nothing has made a verification yet.
    EXPECT_GE(lookAtPages("tune", "tune"), 6);
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
    look("tune/stopped");
    window->docks().setPerspective(Perspective::Monitor);
    look("monitor/stopped");
}

TEST_P(WalkTest, findsNothingWrongInAMeasuredResponse) {
    openDressed();
    connectMotor(0.0); // as fast as possible
    window->docks().setPerspective(Perspective::Identify);
    window->docks().docks().value("frequency")->setAsCurrentTab();
    look("frequency/settings");
    QPushButton* start = button("frequency", "halbench::app::FrequencyPanel", "Start measurement");
    ASSERT_NE(start, nullptr);
    ASSERT_TRUE(wait([&] { return start->isEnabled(); }));
    QTest::mouseClick(start, Qt::LeftButton);
    QPushButton* again = button("frequency", "halbench::app::FrequencyPanel", "Measure again");
    ASSERT_NE(again, nullptr);
    ASSERT_TRUE(QTest::qWaitFor([&] { return again->isVisible() && again->isEnabled(); }, Fit_ms));
    session().setPace({1.0});
    look("frequency/result");
    lookAtPages("frequency", "frequency/result");
}

TEST_P(WalkTest, findsNothingWrongInAnArmedRecordingMotor) {
    openDressed();
    connectMotor(1.0);
    const QTemporaryDir folder;
    window->bench().recording().setFolder(folder.path());
    QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return window->bench().recording().isRecording(); }));
    window->bench().drive().giveConsent();
    window->bench().drive().arm();
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    for (const Perspective perspective : app::AllPerspectives) {
        window->docks().setPerspective(perspective);
        look(app::perspectiveId(perspective) + QStringLiteral("/armed"));
    }
    QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return !window->bench().recording().isRecording(); }));
    window->docks().setPerspective(Perspective::Record);
    look("record/written");
    EXPECT_EQ(lookAtPages("recordings", "recordings"), 4);
    QFile table(folder.filePath("other.txt"));
    ASSERT_TRUE(table.open(QIODevice::WriteOnly));
    table.write("t,omega,i_q\n0,1.5,0.1\n0.001,1.6,0.2\n0.002,1.7,0.3\n");
    table.close();
    window->docks().panel("recordings")->findChild<app::ImportView*>()->begin(table.fileName());
    QTest::qWait(200);
    lookInside("recordings", "recordings/import of a table");
}

/// What the bars of the Monitor, the ellipse and the spectrogram add.
TEST_P(WalkTest, findsNothingWrongInWhatPicturesAreSwitchedTo) {
    openDressed();
    connectMotor(1.0);
    check("monitor", "S");
    check("monitor", "C");
    check("monitor", "T");
    look("monitor/bars");
    window->docks().docks().value("spectrum")->setAsCurrentTab();
    check("spectrum", "O");
    QTest::qWait(300); // computed on another thread
    lookInside("spectrum", "spectrogram");
    window->docks().docks().value("xy")->setAsCurrentTab();
    window->docks().panel("xy")->findChild<QCheckBox*>()->click();
    QTest::qWait(300);
    lookInside("xy", "ellipse");
}

TEST_P(WalkTest, findsNothingWrongInDialogsAndFloatingDocks) {
    openDressed();
    connectMotor(1.0);
    app::PreferencesDialog dialog(window->preferences(), window->bench(), 3000000000U, window.get());
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    look(dialog, "preferences");
    dialog.close();
    for (const char* id : {"parameters", "drive", "log"}) {
        window->docks().raise(id);
        ads::CDockWidget* dock = window->docks().docks().value(id);
        dock->setFloating();
        ASSERT_TRUE(wait([&] { return dock->floatingDockContainer()->isVisible(); }));
        look(*dock->floatingDockContainer(), QString::fromLatin1(id) + QStringLiteral(" afloat"));
    }
}

TEST_P(WalkTest, findsNothingWrongInACalibration) {
    openDressed();
    connectMotor(0.0); // as fast as possible
    window->docks().setPerspective(Perspective::Identify);
    window->docks().docks().value("calibrate")->setAsCurrentTab();
    QPushButton* start = button("calibrate", "halbench::app::CalibratePanel", "Start calibration");
    ASSERT_NE(start, nullptr);
    ASSERT_TRUE(wait([&] { return start->isEnabled(); }));
    QTest::mouseClick(start, Qt::LeftButton);
    const auto* panel = static_cast<app::CalibratePanel*>(window->docks().panel("calibrate"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel->record().has_value(); }, Fit_ms));
    session().setPace({1.0});
    auto* pictures = panel->findChild<QTabWidget*>();
    ASSERT_NE(pictures, nullptr);
    for (int picture = 0; picture < pictures->count(); ++picture) {
        pictures->setCurrentIndex(picture);
        look(QStringLiteral("calibrate/result %1").arg(picture));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Gui, WalkTest,
    testing::Values(Walk{"en", app::ThemeChoice::Light}, Walk{"en", app::ThemeChoice::Dark},
                    Walk{"de", app::ThemeChoice::Light}, Walk{"de", app::ThemeChoice::Dark},
                    Walk{"zh_CN", app::ThemeChoice::Light}, Walk{"zh_CN", app::ThemeChoice::Dark}),
    [](const testing::TestParamInfo<Walk>& walk) {
        return std::string(walk.param.language) +
               (walk.param.theme == app::ThemeChoice::Dark ? "_dark" : "_light");
    });

} // namespace
} // namespace halbench::gui
