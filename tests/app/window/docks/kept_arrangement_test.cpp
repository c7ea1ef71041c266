#include "app/window/docks/arrangement_notice.h"
#include "app/window/docks/dock_layout.h"
#include "app/window/project/project_file.h"
#include "tests/app/window/window_test.h"

#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>

namespace halbench::app {
namespace {

class KeptArrangementTest : public WindowTest {
protected:
    /// One of this window, with its log unfolded.
    QByteArray whole() {
        window->docks().unfold("log");
        settle(); // its area gets its size
        const QByteArray text = window->docks().arrangements().value("monitor");
        window->docks().reset();
        return text;
    }
    static QByteArray newer(QByteArray text) {
        return text.replace("UserVersion=\"2\"", "UserVersion=\"3\"");
    }

    /// What a project holds of the arrangements, as its file has it.
    QStringList projectLines() {
        Project project;
        project.layouts["monitor"] = window->docks().arrangements().value("monitor").toStdString();
        return QString::fromStdString(projectText(project)).split('\n');
    }

    const ArrangementNotice& notice() const { return *window->findChild<ArrangementNotice*>(); }
    QString said() const { return notice().isVisible() ? notice().message().text : QString(); }
    bool isFirst() const { return window->docks().docks().value("log")->isClosed(); }
};

TEST_F(KeptArrangementTest, isReadAsItWasKept) {
    open();
    const QByteArray kept = whole();
    EXPECT_FALSE(faultOf(kept, 2));
    window->docks().setArrangements({{"monitor", kept}});
    EXPECT_FALSE(isFirst());
    EXPECT_EQ(said(), "");
}

/// Lines that only one of the two has, those of the other order included: what a comparison shows.
int differences(const QStringList& one, const QStringList& other) {
    std::vector<std::vector<int>> common(static_cast<std::size_t>(one.size()) + 1,
                                         std::vector<int>(static_cast<std::size_t>(other.size()) + 1));
    for (std::size_t i = 1; i < common.size(); ++i) {
        for (std::size_t j = 1; j < common[i].size(); ++j) {
            const bool isSame = one[static_cast<int>(i) - 1] == other[static_cast<int>(j) - 1];
            common[i][j] = isSame ? common[i - 1][j - 1] + 1 : std::max(common[i - 1][j], common[i][j - 1]);
        }
    }
    return one.size() + other.size() - 2 * common.back().back();
}

TEST_F(KeptArrangementTest, movingOnePanelChangesFewLinesOfTheProject) {
    open();
    for (const char* id : {"drive", "parameters", "log", "notes"}) {
        window->docks().unfold(id);
    }
    const QStringList before = projectLines();
    ads::CDockWidget* log = window->docks().docks().value("log");
    log->dockManager()->addDockWidget(ads::CenterDockWidgetArea, log,
                                      window->docks().docks().value("drive")->dockAreaWidget());
    const QStringList after = projectLines();
    // Both say each panel on a line of its own, and which areas and sizes there are beside them.
    EXPECT_GT(before.size(), 2 * window->docks().docks().size());
    // The panel's own line, the heads of the area it left and of the one it came to, and the sizes.
    EXPECT_LE(differences(before, after), 12) << before.join('\n').toStdString() << "\n\n"
                                              << after.join('\n').toStdString();
    EXPECT_GT(differences(before, after), 0);
}

/// Of a project that was saved before arrangements had lines.
TEST_F(KeptArrangementTest, oneOnASingleLineIsReadAsItWasKept) {
    open();
    const QByteArray kept = whole();
    QByteArrayList pieces;
    for (const QByteArray& line : kept.split('\n')) {
        pieces << line.trimmed();
    }
    const QByteArray single = pieces.join();
    ASSERT_GT(kept.count('\n'), 20);
    ASSERT_EQ(single.count('\n'), 0);
    window->docks().setArrangements({{"monitor", single}});
    EXPECT_FALSE(isFirst());
    EXPECT_EQ(said(), "");
    EXPECT_EQ(window->docks().arrangements().value("monitor"), kept);
}

/// By way of the file: its quotes, its lines and the one it ends with.
TEST_F(KeptArrangementTest, theLinesComeBackFromTheProjectAsTheyWere) {
    open();
    Project project;
    project.layouts["monitor"] = whole().toStdString();
    const Result<Project> read = parseProject(projectText(project), "motor.toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->layouts, project.layouts);
}

TEST_F(KeptArrangementTest, oneThatIsDamagedIsSaidAndItsOctetsStay) {
    open();
    const QByteArray kept = whole();
    for (const QByteArray& damaged :
         {kept.left(kept.size() / 2), QByteArray("not a layout"), QByteArray("\xff\x00", 2)}) {
        window->docks().setArrangements({{"monitor", damaged}});
        EXPECT_TRUE(isFirst());
        EXPECT_TRUE(said().contains("in Monitor is damaged")) << said().toStdString();
        EXPECT_TRUE(notice().message().remedy.contains("monitor.unread"));
        EXPECT_EQ(window->docks().arrangements().value("monitor.unread"), damaged);
        EXPECT_FALSE(faultOf(window->docks().arrangements().value("monitor"), 2));
    }
}

TEST_F(KeptArrangementTest, oneOfAnotherVersionIsSaidWhenItsPerspectiveIsEntered) {
    open();
    const QByteArray later = newer(whole());
    ASSERT_EQ(faultOf(later, 2), ArrangementFault::Newer);
    EXPECT_EQ(faultOf(later, 4), ArrangementFault::Older);
    window->docks().setArrangements({{"tune", later}});
    EXPECT_EQ(said(), "");
    window->docks().setPerspective(Perspective::Tune);
    EXPECT_TRUE(said().contains("in Tune is from a newer version")) << said().toStdString();
    window->docks().setPerspective(Perspective::Monitor);
    window->docks().setArrangements({{"monitor", newer(later).replace("\"3\"", "\"1\"")}});
    EXPECT_TRUE(said().contains("older version")) << said().toStdString();
}

TEST_F(KeptArrangementTest, oneOfANewerVersionStaysInTheProjectBesideTheNewOne) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("motor.toml");
    open();
    const QByteArray later = newer(whole());
    Project project;
    project.layouts["monitor"] = later.toStdString();
    ASSERT_TRUE(saveProject(project, path.toStdString()));
    window->openProject(path);
    EXPECT_TRUE(said().contains("newer version"));
    window->docks().reset(); // of what is shown
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return loadProject(path.toStdString())->layouts.size() > 1; }));
    const auto layouts = loadProject(path.toStdString())->layouts;
    EXPECT_EQ(layouts.at("monitor.unread"), later.toStdString());
    EXPECT_FALSE(faultOf(QByteArray::fromStdString(layouts.at("monitor")), 2));
    window.reset(); // its lock is in the folder
}

TEST_F(KeptArrangementTest, oneThatIsDamagedStaysInThePreferencesAndOutOfTheProject) {
    const QByteArray damaged("\xff\xfe half", 7); // no text: a project with it could not be read again
    Preferences preferences;
    preferences.arrangements = {{"monitor", damaged}};
    open(preferences);
    window->recoverUnnamed();
    EXPECT_TRUE(said().contains("damaged"));
    window->close();
    EXPECT_EQ(loadPreferences().arrangements.value("monitor.unread"), damaged);
    for (const auto& [key, layout] : window->project().project().layouts) {
        EXPECT_NE(key, "monitor.unread");
    }
}

TEST_F(KeptArrangementTest, asManyAsThereAreStay) {
    QHash<QString, QByteArray> kept = {{"monitor.unread", "a"}};
    EXPECT_EQ(unreadName(kept, "tune"), "tune.unread");
    EXPECT_EQ(unreadName(kept, "monitor"), "monitor.unread-2");
}

} // namespace
} // namespace halbench::app
