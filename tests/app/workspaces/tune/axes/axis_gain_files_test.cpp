#include "app/workspaces/tune/axes/axis_gain_files.h"
#include "app/workspaces/tune/axes/axis_loops.h"
#include "tests/app/workspaces/tune/axes/axis_model_fixture.h"
#include "tests/widgets/gui_fixture.h"

#include <QAbstractButton>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>

Q_DECLARE_METATYPE(halbench::app::AxisGainsFile)
Q_DECLARE_METATYPE(halbench::Error)

namespace halbench::app {
namespace {

/// Gains of the published platen, as the panel would save them; judged once.
const TuneAxesResult& recommendedGains() {
    static const TuneAxesResult result = [] {
        AxisLoops loops;
        loops.setModel(platenModelFile());
        for (const std::string& axis : loops.axes()) {
            loops.setAnswer(axis, answerAxis(*loops.question(axis)));
        }
        return loops.result(loops.axes()).value();
    }();
    return result;
}

class AxisGainFilesTest : public widgets::GuiTest {
protected:
    AxisGainFilesTest() {
        qRegisterMetaType<halbench::app::AxisGainsFile>(); // the spies keep them
        qRegisterMetaType<halbench::Error>();
        QObject::connect(&files, &AxisGainFiles::opened,
                         [this](const QString&, const AxisGainsFile& gains) { opened = gains; });
        QObject::connect(&files, &AxisGainFiles::failed, [this](const Error& error) { m_failure = error; });
    }
    void choose(const QString& path) {
        const auto chosen = [path](QWidget*, const FileQuestion&) { return path; };
        files.setFileChooser({chosen, chosen});
    }
    QAbstractButton* button(const char* name) {
        const auto all = files.findChildren<QAbstractButton*>();
        const auto found = std::find_if(all.begin(), all.end(), [&](const QAbstractButton* each) {
            return each->accessibleName() == QString::fromUtf8(name);
        });
        return found == all.end() ? nullptr : *found;
    }
    void press(const char* name) { QTest::mouseClick(button(name), Qt::LeftButton); }

    QTemporaryDir folder;
    Result<JsonValue> document = axisGainsDocument({}, recommendedGains());
    AxisGainFiles files{[this] { return document; }};
    std::optional<AxisGainsFile> opened;
    std::optional<Error> m_failure;
};

TEST_F(AxisGainFilesTest, buttonsAreHiddenWithoutFileChooser) {
    EXPECT_TRUE(button("Save gains\u2026")->isHidden());
    EXPECT_TRUE(button("Open gains\u2026")->isHidden());
    choose(folder.filePath("gains.json"));
    EXPECT_FALSE(button("Save gains\u2026")->isHidden());
    EXPECT_FALSE(button("Open gains\u2026")->isHidden());
}

TEST_F(AxisGainFilesTest, onlyUsableButtonsAreEnabled) {
    files.setUsable(true, false);
    EXPECT_TRUE(button("Open gains\u2026")->isEnabled());
    EXPECT_FALSE(button("Save gains\u2026")->isEnabled());
}

TEST_F(AxisGainFilesTest, savedGainsAreThoseThatAreOpened) {
    choose(folder.filePath("gains.json"));
    QSignalSpy saved(&files, &AxisGainFiles::saved);
    press("Save gains\u2026");
    ASSERT_TRUE(saved.count() > 0 || saved.wait());
    QSignalSpy wasOpened(&files, &AxisGainFiles::opened);
    press("Open gains\u2026");
    ASSERT_TRUE(wasOpened.count() > 0 || wasOpened.wait());
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->axes, (std::vector<std::string>{"x", "y", "phi"}));
    // resources/help/planar-theory.md section 9: 0.64 (30^2 + 4.4 30) N/m; single precision of the board.
    EXPECT_NEAR(opened->gains.at(0).law.gains.proportional, 660.48, 1e-3);
}

TEST_F(AxisGainFilesTest, noChosenFileIsNoAct) {
    choose({});
    QSignalSpy saved(&files, &AxisGainFiles::saved);
    press("Save gains\u2026");
    press("Open gains\u2026");
    EXPECT_EQ(saved.count(), 0);
    EXPECT_FALSE(opened);
    EXPECT_FALSE(m_failure);
}

TEST_F(AxisGainFilesTest, gainsThatAreNotThereAreNotSaved) {
    document = failure(ErrorCode::Refused, "axis y has no gains", "Choose a method.");
    const QString path = folder.filePath("gains.json");
    choose(path);
    press("Save gains\u2026");
    ASSERT_TRUE(m_failure);
    EXPECT_EQ(m_failure->message, "axis y has no gains");
    EXPECT_FALSE(QFile::exists(path));
}

TEST_F(AxisGainFilesTest, fileThatHoldsNoGainsIsAnError) {
    const QString path = folder.filePath("notes.json");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({"schema": "halbench.identification/1"})");
    file.close();
    choose(path);
    QSignalSpy failed(&files, &AxisGainFiles::failed);
    press("Open gains\u2026");
    ASSERT_TRUE(failed.count() > 0 || failed.wait());
    EXPECT_EQ(m_failure->code, ErrorCode::InvalidInput);
    EXPECT_FALSE(opened);
}

TEST_F(AxisGainFilesTest, messageNamesAxesThatKeepTheirGains) {
    EXPECT_EQ(AxisGainFiles::openedMessage("g.json", {}).severity, widgets::Severity::Information);
    const widgets::Message message = AxisGainFiles::openedMessage("g.json", {"y", "phi"});
    EXPECT_EQ(message.severity, widgets::Severity::Warning);
    EXPECT_TRUE(message.remedy.contains("y, phi")) << message.remedy.toStdString();
}

} // namespace
} // namespace halbench::app
