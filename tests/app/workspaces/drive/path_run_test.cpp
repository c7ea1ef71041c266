#include "app/documents/text/output_file.h"
#include "app/workspaces/drive/path_run.h"
#include "tests/app/workspaces/drive/drive_panel_fixture.h"

#include <QTemporaryDir>

namespace halbench::app {
namespace {

/// Paths of several axes in the Drive panel, on the simulated device that has them.
class PathRunTest : public DrivePanelTest {
protected:
    void connectPlanar() {
        connectTo("sim:planar?imperfections=off", 5.0);
        ASSERT_TRUE(wait([&] { return shapes()->findText("Circle") >= 0; }));
    }
    QComboBox* shapes() { return find<QComboBox>(*panel, "Shape of the reference"); }
    void choose(const char* shape) {
        shapes()->setCurrentIndex(shapes()->findText(QString::fromLatin1(shape)));
    }
    void set(const char* name, double value) { find<QDoubleSpinBox>(*panel, name)->setValue(value); }
    void offer(const std::string& text) {
        const std::string path = m_folder.filePath("poses.csv").toStdString();
        ASSERT_TRUE(writeFile(path, text));
        panel->setFileChooser(
            {{}, [path](QWidget*, const FileQuestion&) { return QString::fromStdString(path); }});
        click(*panel, "Choose file…");
    }
    bool says(const QString& words) {
        for (const QLabel* label : panel->findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(words)) {
                return true;
            }
        }
        return false;
    }
    void armAndWait() {
        armByClick();
        ASSERT_TRUE(wait([&] { return bench().drive().origin_rad().has_value(); }));
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(PathRunTest, shapesOfAMotorAreItsGenerators) {
    connectTo("sim:htm", 5.0);
    EXPECT_EQ(shapes()->count(), 6);
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    connectPlanar();
    EXPECT_EQ(shapes()->count(), 11);
}

TEST_F(PathRunTest, lineMovesBothAxesAndTheSetpointsOfBothCountFromItsEnd) {
    connectPlanar();
    armAndWait();
    choose("Line");
    set("Length", 2.0);
    set("Heading", 90.0);
    EXPECT_TRUE(says("Moves together: x, y."));
    const double y_m = latest("position.y");
    click(*panel, "Start");
    ASSERT_TRUE(wait([&] { return bench().drive().isRunning(); }));
    ASSERT_TRUE(wait([&] { return !bench().drive().isRunning(); }));
    EXPECT_TRUE(wait([&] { return std::abs(latest("position.y") - y_m - 2e-3) < 1e-4; }));
    EXPECT_TRUE(wait([&] { return std::abs(bench().drive().commanded("y") - 2e-3) < 5e-5; }));
    EXPECT_NEAR(bench().drive().commanded("x"), 0.0, 5e-5);
}

TEST_F(PathRunTest, tableIsReadAndFollowed) {
    connectPlanar();
    armAndWait();
    choose("Table of poses");
    set("Speed", 100.0);
    set("Acceleration", 1.0);
    offer("time_s,x_mm,y_mm\n0.5,1,0\n1,1,1\n");
    ASSERT_TRUE(wait([&] { return says("Travel time: 1.000 s"); }));
    const double x_m = latest("position.x");
    click(*panel, "Start");
    ASSERT_TRUE(wait([&] { return bench().drive().isRunning(); }));
    ASSERT_TRUE(wait([&] { return !bench().drive().isRunning(); }));
    EXPECT_TRUE(wait([&] { return std::abs(latest("position.x") - x_m - 1e-3) < 1e-4; }));
}

TEST_F(PathRunTest, tableBeyondAWindowOrOfAnotherDeviceIsRefused) {
    connectPlanar();
    armAndWait();
    choose("Table of poses");
    set("Speed", 1000.0);
    set("Acceleration", 100.0);
    set("Jerk", 0.0);
    offer("time_s,x_mm\n1,1\n5,60\n");
    ASSERT_TRUE(wait([&] { return says("Travel time: 5.000 s"); }));
    click(*panel, "Start");
    EXPECT_TRUE(wait([&] { return message().contains("row 2: axis x goes as far as"); }))
        << message().toStdString();
    EXPECT_FALSE(bench().drive().isRunning());
    offer("time_s,z_mm\n1,1\n5,6\n");
    EXPECT_TRUE(wait([&] { return says("the device has no axis 'z'"); }));
}

} // namespace
} // namespace halbench::app
