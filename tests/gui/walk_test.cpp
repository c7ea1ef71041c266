#include "app/window/dock_layout.h"
#include "app/window/help_window.h"
#include "app/window/language.h"
#include "tests/app/window/window_test.h"
#include "tests/gui/inspection.h"
#include "widgets/stop_button.h"

#include <QMenuBar>
#include <qtadvanceddocking/DockWidget.h>

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

    void look(const QString& place) {
        QTest::qWait(50); // one frame of the window
        for (const QString& finding : inspect(*window, phrases)) {
            note(place, finding);
        }
        const auto* stop = window->findChild<widgets::StopButton*>();
        const QRect where(stop->mapTo(window.get(), QPoint()), stop->size());
        if (!stop->isVisible() || !window->rect().contains(where)) {
            note(place, "STOP is not in sight");
        }
    }

    void note(const QString& place, const QString& finding) {
        if (!findings.contains(finding)) {
            findings << finding;
            ADD_FAILURE() << place.toStdString() << ": " << finding.toStdString();
        }
    }

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
