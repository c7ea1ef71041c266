// The start page of the window: what its lists hold and what opening a row does.
#include "app/window/docks/dock_layout.h"
#include "app/window/project/project_file.h"
#include "app/window/start/recent_files.h"
#include "app/window/start/recent_lists.h"
#include "app/window/start/sample_files.h"
#include "app/window/start/sample_list.h"
#include "app/window/start/start_list.h"
#include "app/workbench/shown_recording.h"
#include "app/workspaces/actuators/registry/sample_recordings.h"
#include "app/workspaces/device/device_panel.h"
#include "devices/open/device_title.h"
#include "devices/open/open_device.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/stop_button.h"

#include <QFile>
#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QTreeWidget>

namespace halbench::app {
namespace {

class StartPageTest : public WindowTest {
protected:
    QTreeWidget& rows(const QString& title) {
        for (auto* found : window->docks().panel("devices")->findChildren<QTreeWidget*>()) {
            if (found->accessibleName() == title) {
                return *found;
            }
        }
        ADD_FAILURE() << "no list is called " << title.toStdString();
        std::abort();
    }
    QStringList texts(const QString& title) {
        QStringList texts;
        for (int row = 0; row < rows(title).topLevelItemCount(); ++row) {
            texts << rows(title).topLevelItem(row)->text(0);
        }
        return texts;
    }
    void openRow(const QString& title, int row) {
        rows(title).setCurrentItem(rows(title).topLevelItem(row));
        QTest::keyClick(&rows(title), Qt::Key_Return);
    }
    bool isRecordingShown() { return window->bench().shownRecording().file() != nullptr; }
    QString project(const QString& fileName) {
        const QString path = folder.filePath(fileName);
        EXPECT_TRUE(saveProject(Project(), path.toStdString()));
        return path;
    }

    QTemporaryDir folder;
};

TEST_F(StartPageTest, simulatedActuatorsHaveTheirTitleBesideTheirAddress) {
    open();
    const auto* list = window->docks().panel("devices")->findChild<QListWidget*>();
    for (const devices::DeviceListing& listing : devices::listBuiltInDevices()) {
        const QString uri = QString::fromStdString(listing.uri);
        const QString title = QString::fromStdString(devices::simulatedTitle(listing.uri));
        ASSERT_FALSE(title.isEmpty()) << listing.uri;
        bool isListed = false;
        for (int row = 0; row < list->count(); ++row) {
            if (list->item(row)->data(Qt::UserRole).toString() == uri) {
                isListed = true;
                EXPECT_TRUE(list->item(row)->text().contains(title));
                EXPECT_TRUE(list->item(row)->text().contains(uri));
            }
        }
        EXPECT_TRUE(isListed) << listing.uri;
    }
}

TEST_F(StartPageTest, aRecentProjectIsOpenedAndOneThatIsGoneIsSaid) {
    const QString there = project(QStringLiteral("motor.toml"));
    recentProjectFiles().add(folder.filePath(QStringLiteral("gone.toml")));
    recentProjectFiles().add(there);
    open();
    const QString title = QStringLiteral("Recent projects");
    EXPECT_EQ(texts(title), (QStringList{QStringLiteral("motor.toml"), QStringLiteral("gone.toml")}));
    ASSERT_TRUE(
        wait([&] { return rows(title).topLevelItem(1)->text(1) == QStringLiteral("moved or deleted"); }));
    openRow(title, 0);
    EXPECT_TRUE(wait([&] { return window->project().path() == there.toStdString(); }));
    window->docks().raise("devices"); // the project has its own panels
    QApplication::setActiveWindow(window.get());
    rows(title).setFocus();
    rows(title).setCurrentItem(rows(title).topLevelItem(1));
    QTest::keyClick(&rows(title), Qt::Key_Delete);
    EXPECT_TRUE(wait([&] { return texts(title) == QStringList{QStringLiteral("motor.toml")}; }));
    EXPECT_EQ(recentProjectFiles().paths(), QStringList{there});
}

TEST_F(StartPageTest, everySampleIsShownAsARecordingAndKeptOutOfTheRecentOnes) {
    open();
    const std::vector<SampleRecording> samples = sampleRecordings();
    ASSERT_EQ(texts(QStringLiteral("Sample recordings")).size(), static_cast<int>(samples.size()));
    for (int row = 0; row < static_cast<int>(samples.size()); ++row) {
        const SampleRecording& sample = samples[static_cast<std::size_t>(row)];
        SCOPED_TRACE(sample.file.toStdString());
        window->docks().raise("devices");
        openRow(QStringLiteral("Sample recordings"), row);
        ASSERT_TRUE(wait([&] {
            return isRecordingShown() && window->bench().shownRecording().path().contains(sample.file);
        }));
        EXPECT_EQ(session().info().transport, "replay");
        EXPECT_EQ(session().info().model, sample.device.mid(4).toStdString());
        EXPECT_FALSE(window->docks().isOffered("drive")) << "a recording is not driven";
        EXPECT_GE(window->bench().shownRecording().file()->recording.rows(), 200U);
        EXPECT_LE(window->bench().shownRecording().file()->recording.rows(), 1000U) << "small";
        window->docks().setPerspective(Perspective::Monitor);
    }
    EXPECT_EQ(recentRecordingFiles().paths(), QStringList());
}

TEST_F(StartPageTest, aRecordingThatWasOpenedIsARecentOne) {
    const Result<QString> copy = copySample(sampleRecordings().front().file, folder.path());
    ASSERT_TRUE(copy);
    open();
    window->bench().shownRecording().open(*copy);
    ASSERT_TRUE(wait([&] { return isRecordingShown(); }));
    EXPECT_EQ(recentRecordingFiles().paths(), QStringList{*copy});
    ASSERT_TRUE(wait([&] { return texts(QStringLiteral("Recent recordings")).size() == 1; }));
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    window->docks().setPerspective(Perspective::Monitor);
    window->docks().raise("devices");
    openRow(QStringLiteral("Recent recordings"), 0);
    EXPECT_TRUE(wait([&] { return isRecordingShown(); }));
}

TEST_F(StartPageTest, everyListIsReachedByTab) {
    open();
    QApplication::setActiveWindow(window.get());
    for (const char* title : {"Recent projects", "Recent recordings"}) {
        recentProjectFiles().add(QStringLiteral("/a/motor.toml"));
        recentRecordingFiles().add(QStringLiteral("/a/run.csv"));
        window->docks().raise("signals"); // and back: the lists are read anew
        window->docks().setPerspective(Perspective::Tune);
        window->docks().setPerspective(Perspective::Monitor);
        window->docks().raise("devices");
        ASSERT_TRUE(wait([&] { return rows(QString::fromLatin1(title)).topLevelItemCount() == 1; })) << title;
    }
    for (const char* title : {"Recent projects", "Recent recordings", "Sample recordings"}) {
        QWidget* wanted = &rows(QString::fromLatin1(title));
        window->docks().panel("devices")->setFocus();
        for (int i = 0; i < 60 && QApplication::focusWidget() != wanted; ++i) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        EXPECT_EQ(QApplication::focusWidget(), wanted) << title;
    }
}

TEST_F(StartPageTest, scrollsInASmallWindowAndCutsNothingOffAtTheRight) {
    for (const QSize size : {QSize(952, 500), QSize(1366, 700), QSize(1920, 1160), QSize(952, 500)}) {
        if (!window) {
            open();
        }
        window->resize(size);
        settle();
        SCOPED_TRACE(size.width());
        const auto* page = window->docks().panel("devices")->findChild<QScrollArea*>();
        EXPECT_EQ(page->horizontalScrollBar()->maximum(), 0);
        EXPECT_LE(page->widget()->width(), page->viewport()->width());
        for (const auto* list : page->findChildren<StartList*>()) {
            const int right = list->mapTo(page->widget(), QPoint(list->width(), 0)).x();
            EXPECT_LE(right, page->viewport()->width());
        }
    }
}

} // namespace
} // namespace halbench::app
