#include "app/documents/result_documents.h"
#include "app/window/docks/dock_layout.h"
#include "app/window/project/project_file.h"
#include "app/wizards/identify_panel.h"
#include "app/workbench/shared_results.h"
#include "app/workbench/wall_clock.h"
#include "app/workspaces/tune/loop/gain_editor.h"
#include "app/workspaces/tune/loop/tune_form.h"
#include "app/workspaces/tune/tune_panel.h"
#include "tests/app/window/window_test.h"
#include "tests/app/workspaces/published_motor.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/verdict_view.h"

#include <QComboBox>
#include <QDateTime>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {
namespace {

/// The same motor with another damping: a model that contradicts itself is refused.
IdentifyResult withDamping(IdentifyResult motor, double damping) {
    const auto set = [](control::Estimate& estimate, double value) {
        estimate.value = value;
        estimate.interval95 = std::pair(0.99 * value, 1.01 * value);
    };
    set(motor.viscousDamping, damping);
    set(motor.ratios["c_over_J"], damping / *motor.inertia.value);
    return motor;
}

/// What an engineer did in one window is there again in the next.
class ProjectWorkTest : public WindowTest {
protected:
    QString path(const char* file = "motor.toml") const { return folder.filePath(file); }

    static ResultHeader header() {
        ResultHeader made;
        made.schema = "halbench.identification/1";
        made.device = devices::DeviceInfo{"serial:/dev/ttyACM0", "htm", "htm-0042", "FW-1.2", "", false, {}};
        made.started = "2026-05-04T03:02:01Z";
        made.software = "0.9.0";
        return made;
    }

    /// As the Identify panel ends.
    void identify() {
        window->bench().setIdentification(publishedMotor(), {header(), ResultOrigin::Measured});
        ASSERT_TRUE(wait([&] { return window->bench().design().has_value(); }));
    }

    void saveAs(const QString& path) {
        QTest::qWait(0);
        window->close(); // collects the project
        bool isSaved = false;
        window->project().save(path.toStdString(),
                               [&](const Result<void>& written) { isSaved = written.has_value(); });
        ASSERT_TRUE(wait([&] { return isSaved; }));
    }

    QByteArray content(const QString& path) const {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }

    template <typename Panel>
    Panel* panel(const char* id) {
        return qobject_cast<Panel*>(window->docks().panel(id));
    }

    static std::string text(const IdentifyResult& result, const ResultHeader& header) {
        return toJsonText(identificationDocument(header, result)).value();
    }

    static QString message(const QWidget& panel) {
        return panel.findChild<widgets::MessageBar*>()->message().text;
    }

    QTemporaryDir folder;
};

TEST_F(ProjectWorkTest, theIdentifiedMotorComesBackWithEveryNumberAndWhereItIsFrom) {
    open();
    identify();
    saveAs(path());
    open();
    window->openProject(path());
    ASSERT_TRUE(window->bench().identification());
    EXPECT_EQ(text(*window->bench().identification(), window->bench().provenance().header),
              text(publishedMotor(), header()));
    auto* identify = panel<IdentifyPanel>("identify");
    EXPECT_TRUE(message(*identify).contains(localDate("2026-05-04T03:02:01Z")));
    EXPECT_TRUE(message(*identify).contains("htm-0042"));
    EXPECT_GT(identify->findChild<widgets::EstimateTable*>()->rowCount(), 0);
    const auto labels = identify->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text().contains("FW-1.2") && label->text().contains("0.9.0");
    }));
    EXPECT_EQ(session().state(), SessionState::Disconnected); // a file moves nothing
}

TEST_F(ProjectWorkTest, tuneGoesOnWithTheGainsOfTheProjectAndDesignsNoOthers) {
    open();
    identify();
    auto* kp = panel<TunePanel>("tune")->findChild<GainEditor*>()->findChildren<QLineEdit*>().front();
    panel<TunePanel>("tune")->show();
    kp->setFocus();
    QTest::keyClick(kp, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(kp, "1.75");
    QTest::keyClick(kp, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return window->bench().design()->method == "edited"; }));
    const control::PositionLaw law = window->bench().design()->law;
    saveAs(path());
    const QByteArray first = content(path());
    open();
    window->openProject(path());
    ASSERT_TRUE(wait([&] { return window->bench().design().has_value(); }));
    EXPECT_EQ(window->bench().design()->law.gains.proportional, law.gains.proportional);
    EXPECT_EQ(window->bench().design()->law.gains.derivative, law.gains.derivative);
    EXPECT_EQ(window->bench().design()->method, "edited");
    EXPECT_TRUE(message(*panel<TunePanel>("tune")).contains("edited"));
    saveAs(path("again.toml"));
    const auto withoutLayout = [](const QByteArray& whole) { return whole.mid(whole.indexOf("[[design]]")); };
    EXPECT_EQ(withoutLayout(content(path("again.toml"))), withoutLayout(first)); // to the byte
}

TEST_F(ProjectWorkTest, gainsCarryTheTimeWhenTheyWereFoundAlsoAfterTheProjectWasOpened) {
    open();
    QDateTime now = QDateTime::fromString("2026-05-06T07:08:09Z", Qt::ISODate);
    window->bench().setWallClock([&now] { return now; });
    identify();
    const auto started = [this] { return window->bench().designHeader().started; };
    EXPECT_EQ(started(), "2026-05-06T07:08:09Z");
    saveAs(path());
    EXPECT_TRUE(content(path()).contains("2026-05-06T07:08:09Z"));
    open();
    window->openProject(path());
    ASSERT_TRUE(wait([&] { return window->bench().design().has_value(); }));
    EXPECT_EQ(started(), "2026-05-06T07:08:09Z");
}

TEST_F(ProjectWorkTest, theGivenConstantsComeBackAndANewProjectHasNone) {
    open();
    panel<IdentifyPanel>("identify")->setGiven({{"J", 5.5e-4}, {"Kf", 0.0}});
    saveAs(path());
    open();
    EXPECT_TRUE(panel<IdentifyPanel>("identify")->given().empty());
    window->openProject(path());
    EXPECT_EQ(panel<IdentifyPanel>("identify")->given(),
              (std::map<std::string, double>{{"J", 5.5e-4}, {"Kf", 0.0}}));
}

TEST_F(ProjectWorkTest, choosingAMethodDesignsAnewAndTheProjectTakesIt) {
    open();
    identify();
    saveAs(path());
    open();
    window->openProject(path());
    ASSERT_TRUE(wait([&] { return window->bench().design().has_value(); }));
    EXPECT_TRUE(window->bench().isDesignFromProject());
    auto* tune = panel<TunePanel>("tune");
    auto* origin = tune->findChild<TuneForm*>()->findChild<QComboBox*>();
    origin->setFocus();
    QTest::keyClick(origin, Qt::Key_Down);
    ASSERT_TRUE(wait([&] { return !window->bench().isDesignFromProject(); }));
    EXPECT_TRUE(message(*tune).isEmpty());
    const std::string method = window->bench().design()->method;
    EXPECT_NE(method, "recommended");
    saveAs(path());
    EXPECT_TRUE(content(path()).contains(QByteArray::fromStdString("\\\"method\\\": \\\"" + method)));
}

TEST_F(ProjectWorkTest, designsKeptUnderANameAreThereAgainBesideTheOneInUse) {
    open();
    identify();
    const std::string document =
        toJsonText(gainsDocument(window->bench().designHeader(), *window->bench().design())).value();
    auto* tune = panel<TunePanel>("tune");
    tune->setSavedDesigns({keptDesign("calm", document), keptDesign("strange", "no JSON")});
    saveAs(path());
    const auto saved = loadProject(path().toStdString());
    ASSERT_TRUE(saved);
    ASSERT_EQ(saved->designs.size(), 3U);
    EXPECT_EQ(saved->designs.back().name, "in use");
    open();
    window->openProject(path());
    const auto& kept = panel<TunePanel>("tune")->savedDesigns();
    ASSERT_EQ(kept.size(), 2U);
    EXPECT_EQ(kept[0].name, "calm");
    EXPECT_EQ(kept[0].document, document); // to the byte
    EXPECT_TRUE(kept[0].gains);
    EXPECT_FALSE(kept[1].gains);
    EXPECT_EQ(kept[1].document, "no JSON");
}

TEST_F(ProjectWorkTest, gainsInUseThatCannotBeReadStayBesideThoseDesignedInTheirPlace) {
    open();
    identify();
    saveAs(path());
    Project project = *loadProject(path().toStdString());
    ASSERT_EQ(project.designs.size(), 1U);
    project.designs[0].document = "from a newer version";
    ASSERT_TRUE(saveProject(project, path("newer.toml").toStdString()));
    open();
    window->openProject(path("newer.toml"));
    ASSERT_TRUE(wait([&] { return window->bench().design().has_value(); }));
    saveAs(path("again.toml"));
    const auto again = loadProject(path("again.toml").toStdString());
    ASSERT_TRUE(again);
    ASSERT_EQ(again->designs.size(), 2U);
    EXPECT_EQ(again->designs[0].document, "from a newer version");
    EXPECT_NE(again->designs[0].name, "in use");
    EXPECT_EQ(again->designs[1].name, "in use");
}

TEST_F(ProjectWorkTest, aModelThatCannotBeReadIsSaidAndStaysInTheProject) {
    Project project;
    project.models = {{"htm 1", "{\"schema\": \"halbench.identification/7\"}"}};
    project.designs = {{"slow", "no JSON"}};
    ASSERT_TRUE(saveProject(project, path().toStdString()));
    open();
    window->openProject(path());
    EXPECT_FALSE(window->bench().identification());
    const auto bars = window->findChildren<widgets::MessageBar*>();
    EXPECT_TRUE(std::any_of(bars.begin(), bars.end(), [](const widgets::MessageBar* bar) {
        return bar->isVisible() && bar->message().text.contains("htm 1") &&
               bar->message().text.contains("slow");
    }));
    saveAs(path("again.toml"));
    const auto again = loadProject(path("again.toml").toStdString());
    ASSERT_TRUE(again);
    EXPECT_EQ(again->models, project.models);
    EXPECT_EQ(again->designs, project.designs);
}

TEST_F(ProjectWorkTest, aSecondIdentificationIsKeptBesideTheFirst) {
    open();
    identify();
    IdentifyResult warm = publishedMotor();
    warm = withDamping(warm, 1.1e-3);
    window->bench().setIdentification(warm, {header(), ResultOrigin::Measured});
    window->bench().setIdentification(warm, {header(), ResultOrigin::File}); // the same once more
    saveAs(path());
    const auto saved = loadProject(path().toStdString());
    ASSERT_TRUE(saved);
    ASSERT_EQ(saved->models.size(), 2U);
    EXPECT_EQ(saved->models[0].name, "htm 1");
    EXPECT_EQ(saved->models[1].name, "htm 2");
    EXPECT_EQ(saved->models[1].document, text(warm, header()));
}

TEST_F(ProjectWorkTest, theErrorOfADamagedProjectNamesItsFormAndGoesWithTheNextOneThatOpens) {
    open();
    QFile damaged(path("damaged.toml"));
    ASSERT_TRUE(damaged.open(QFile::WriteOnly));
    damaged.write("schema = \n");
    damaged.close();
    const auto complaint = [&] {
        for (const auto* bar : window->findChildren<widgets::MessageBar*>()) {
            if (bar->isVisibleTo(window.get()) && bar->message().text.contains("damaged.toml")) {
                return bar->message().remedy;
            }
        }
        return QString();
    };
    window->openProject(path("damaged.toml"));
    window->project().finishWriting();
    EXPECT_TRUE(complaint().contains("the help shows the form of the files")) << complaint().toStdString();
    ASSERT_TRUE(saveProject(Project(), path().toStdString()));
    window->openProject(path());
    window->project().finishWriting();
    EXPECT_TRUE(complaint().isEmpty()) << complaint().toStdString();
}

TEST_F(ProjectWorkTest, aNewProjectHasNoMotorOfTheOldOne) {
    open();
    identify();
    window->project().startNew();
    window->openProject(path("missing.toml")); // refused: what is open stays
    EXPECT_TRUE(window->bench().identification());
    Project empty;
    ASSERT_TRUE(saveProject(empty, path().toStdString()));
    window->openProject(path());
    window->project().finishWriting(); // what was open is kept first
    EXPECT_FALSE(window->bench().identification());
    EXPECT_FALSE(window->bench().design());
    EXPECT_NE(content(path()).size(), 0);
}

TEST_F(ProjectWorkTest, theViewThatWasSavedIsTheOneThatOpens) {
    open();
    window->docks().setPerspective(Perspective::Tune);
    window->docks().docks().value("log")->toggleView(false);
    saveAs(path());
    open();
    window->docks().setPerspective(Perspective::Field);
    window->openProject(path());
    EXPECT_EQ(window->docks().perspective(), Perspective::Tune);
    EXPECT_TRUE(window->docks().docks().value("log")->isClosed());
    EXPECT_FALSE(window->docks().docks().value("tune")->isClosed());
    EXPECT_EQ(window->preferences().perspective, "tune");
    Project none = window->project().project(); // as written by hand, without a view
    none.perspective.clear();
    none.layouts.clear();
    ASSERT_TRUE(saveProject(none, path("none.toml").toStdString()));
    window->docks().setPerspective(Perspective::Record);
    window->openProject(path("none.toml"));
    EXPECT_EQ(window->docks().perspective(), Perspective::Record);
}

TEST_F(ProjectWorkTest, aCrashLosesNoIdentificationThatWasAutosaved) {
    QStandardPaths::setTestModeEnabled(true);
    open();
    identify();
    saveAs(path());
    IdentifyResult warm = publishedMotor();
    warm = withDamping(warm, 1.1e-3);
    window->bench().setIdentification(warm, {header(), ResultOrigin::Measured});
    window->close(); // autosaves, as the timer does; nothing is saved
    open();          // the next start
    window->openProject(path());
    ASSERT_TRUE(window->bench().identification());
    EXPECT_EQ(window->bench().identification()->viscousDamping.value, 1.1e-3);
    EXPECT_TRUE(window->isWindowModified()); // it is still not saved
}

} // namespace
} // namespace halbench::app
