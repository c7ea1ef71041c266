#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/design_table.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QFile>
#include <QLineEdit>
#include <QTableWidget>

namespace halbench::app {
namespace {

/// The designs page of the Tune panel, by keyboard and mouse.
class TuneDesignsTest : public TunePanelTest {
protected:
    void SetUp() override {
        TunePanelTest::SetUp();
        bench.setIdentification(publishedMotor());
        ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
        click(panel, "Designs");
    }

    QTableWidget& table() const { return *panel.findChild<DesignTable*>()->findChild<QTableWidget*>(); }
    QString cell(int row, const QString& heading) const {
        for (int column = 0; column < table().columnCount(); ++column) {
            if (table()
                    .horizontalHeaderItem(column)
                    ->text()
                    .replace(QLatin1Char('\n'), QLatin1Char(' '))
                    .startsWith(heading)) {
                return table().item(row, column) == nullptr ? QString() : table().item(row, column)->text();
            }
        }
        ADD_FAILURE() << heading.toStdString();
        return {};
    }
    void key(int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&table(), static_cast<Qt::Key>(code), modifiers);
    }
    /// Keeps what is proposed under this name, typed into the editor that opens.
    void keepAs(const QString& name) {
        const int rows = table().rowCount();
        click(panel, "Save design");
        ASSERT_EQ(table().rowCount(), rows + 1);
        auto* editor = table().findChild<QLineEdit*>();
        ASSERT_NE(editor, nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
        ASSERT_TRUE(wait([&] { return panel.savedDesigns().back().name == name.toStdString(); }));
    }
};

// A message says what is possible now: what it speaks of must be in reach.
TEST_F(TuneDesignsTest, aMessageCoversNoButton) {
    prepare();
    verify();
    click(panel, "Keep");
    const auto* bar = panel.findChild<widgets::MessageBar*>();
    ASSERT_TRUE(bar->isVisible());
    const auto frameOf = [this](const QWidget& widget) {
        return widget.visibleRegion().boundingRect().translated(widget.mapTo(&panel, QPoint()));
    };
    const auto covered = [&] {
        QStringList names;
        for (const auto* each : panel.findChildren<QAbstractButton*>()) {
            if (each->isVisible() && !bar->isAncestorOf(each) && frameOf(*each).intersects(frameOf(*bar))) {
                names << each->text() + each->accessibleName();
            }
        }
        return names.join(", ").toStdString();
    };
    for (const int width_px : {panel.minimumSizeHint().width(), 720, 1100, 1600}) {
        panel.resize(width_px, 640);
        for (const char* page : {"Designs", "Numbers", "Disturbance", "Small step", "Verification"}) {
            if (isEnabled(panel, page)) {
                click(panel, page);
            }
            QCoreApplication::processEvents();
            EXPECT_EQ(covered(), "") << width_px << ", " << page;
        }
    }
}

TEST_F(TuneDesignsTest, aKeptDesignStandsBesideTheProposedOneWithItsFiguresAndCurves) {
    EXPECT_EQ(table().rowCount(), 1);
    EXPECT_EQ(cell(0, "K_P"), "40");
    EXPECT_EQ(cell(0, "Closed loop"), "stable");
    keepAs("stiff");
    choose("Source of the gains", "Method: LQR");
    ASSERT_TRUE(wait([&] { return bench.design()->method == "lqr"; }));
    EXPECT_EQ(cell(0, "Method"), "LQR");
    EXPECT_EQ(cell(1, "Method"), "recommended");
    EXPECT_EQ(cell(1, "K_P"), "40");
    EXPECT_EQ(cell(1, "Phase margin"), "37.9"); // htm-theory.md 8.4
    EXPECT_EQ(cell(1, "Gain margin"), "4.21");
    EXPECT_NE(cell(0, "Bandwidth"), cell(1, "Bandwidth"));
    EXPECT_FALSE(curve("Open loop", "stiff").empty());
    EXPECT_FALSE(curve("Predicted step of", "stiff").empty());
    table().setCurrentCell(1, 0);
    table().item(1, 0)->setCheckState(Qt::Unchecked);
    EXPECT_TRUE(wait([&] { return curve("Open loop", "stiff").empty(); }));
}

TEST_F(TuneDesignsTest, aKeptDesignIsTakenUpAgainWithEveryDigit) {
    const control::PositionLaw law = bench.design()->law;
    keepAs("stiff");
    choose("Source of the gains", "Preset: published");
    ASSERT_TRUE(wait([&] { return bench.design()->law.gains.proportional == 10.0; }));
    table().setCurrentCell(1, 0);
    click(panel, "Use this design");
    ASSERT_TRUE(wait([&] { return bench.design()->law == law; }));
    EXPECT_EQ(panel.findChild<TuneForm*>()->origin(), TuneForm::Origin::Edited);
}

TEST_F(TuneDesignsTest, theListIsWorkedOnByKeyboardAndTakenBack) {
    keepAs("one");
    keepAs("two");
    table().setFocus();
    table().setCurrentCell(1, 0);
    key(Qt::Key_Delete);
    ASSERT_EQ(panel.savedDesigns().size(), 1U);
    key(Qt::Key_Z, Qt::ControlModifier);
    ASSERT_EQ(panel.savedDesigns().size(), 2U);
    EXPECT_EQ(panel.savedDesigns().front().name, "one");
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(panel.savedDesigns().size(), 1U);
    table().setCurrentCell(0, 0);
    EXPECT_FALSE(isEnabled(panel, "Remove")); // what is proposed is nothing of the list
    EXPECT_FALSE(isEnabled(panel, "Use this design"));
}

TEST_F(TuneDesignsTest, aNameThatIsTakenIsRefusedInWords) {
    keepAs("one");
    keepAs("two");
    table().item(2, 0)->setText("one");
    ASSERT_TRUE(wait([&] { return !message().isEmpty(); }));
    EXPECT_TRUE(message().contains("one")) << message().toStdString();
    EXPECT_EQ(panel.savedDesigns().back().name, "two");
    EXPECT_EQ(table().item(2, 0)->text(), "two");
}

TEST_F(TuneDesignsTest, aDesignOfAnotherMotorIsJudgedAnewForThisOne) {
    keepAs("stiff");
    const QString before = cell(1, "Phase margin");
    IdentifyResult stronger = publishedMotor();
    stronger.ratios["phi_over_J"].value = 2.0 * *stronger.ratios["phi_over_J"].value;
    stronger.torqueConstant.value = 2.0 * *stronger.torqueConstant.value;
    bench.setIdentification(stronger);
    EXPECT_TRUE(
        wait([&] { return !cell(1, "Phase margin").isEmpty() && cell(1, "Phase margin") != before; }));
}

TEST_F(TuneDesignsTest, aDesignWithoutFiguresSaysWhy) {
    keepAs(
        "stiff"); // the others as a project may hold them: gains that no loop can have, and no gains at all
    auto document = parseJson(panel.savedDesigns().back().document, "test");
    ASSERT_TRUE(document);
    JsonValue gains = *document->find("gains");
    JsonValue kp = *gains.find("kp");
    document->set("gains", gains.set("kp", kp.set("value", -1.0)));
    panel.setSavedDesigns({keptDesign("mad", *toJsonText(*document)), keptDesign("torn", "{")});
    EXPECT_EQ(cell(2, "Closed loop"), "not assessed: project entry cannot be read");
    ASSERT_TRUE(wait([&] { return cell(1, "Closed loop") != "not assessed yet"; }));
    EXPECT_TRUE(cell(1, "Closed loop").contains("K_P = -1")) << cell(1, "Closed loop").toStdString();
    EXPECT_EQ(cell(1, "Phase margin"), QString());
    EXPECT_GT(table().columnSpan(1, 1), 1); // across the figures that are not there
    EXPECT_EQ(table().columnSpan(0, 1), 1);
    type("gain.kp", "0");
    EXPECT_TRUE(wait([&] { return cell(0, "Closed loop").startsWith("not assessed: "); }))
        << cell(0, "Closed loop").toStdString();
}

// As tune --gains: the file's gains are proposed, judged like any others, and what is odd of them is said.
TEST_F(TuneDesignsTest, gainsOfAFileBecomeTheProposedOnesAndTheirDeviceIsNamed) {
    connectMotor("sim:htm?seed=4", 0.0);
    const QString path = m_folder.filePath("other.json");
    const auto writeGains = [&](const QByteArray& id, const QByteArray& proportional) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("{\"schema\": \"halbench.gains/1\", \"form\": \"parallel\", \"sample_period_s\": 0.01, "
                   "\"device\": {\"model\": \"htm\", \"id\": \"" +
                   id +
                   "\", \"firmware\": \"x\", \"simulated\": true, \"overrides\": {}}, "
                   "\"gains\": {\"kp\": {\"value\": " +
                   proportional + "}, \"ki\": {\"value\": 50}, \"kd\": {\"value\": 1.2}}}");
    };
    panel.setFileChooser({{}, [&](QWidget*, const FileQuestion&) { return path; }});
    writeGains("B2", "35");
    click(panel, "Open gains\u2026");
    ASSERT_TRUE(wait([&] { return bench.design() && bench.design()->law.gains.proportional == 35.0; }));
    EXPECT_EQ(bench.design()->law.gains.derivative, 1.2);
    EXPECT_TRUE(message().contains("other.json")) << message().toStdString();
    const auto& told = panel.findChild<widgets::MessageBar*>()->message();
    EXPECT_EQ(told.severity, widgets::Severity::Warning);
    EXPECT_TRUE(told.remedy.contains("B2")) << told.remedy.toStdString();
    writeGains("B2", "1e999"); // is no number
    click(panel, "Open gains\u2026");
    ASSERT_TRUE(wait([&] {
        return panel.findChild<widgets::MessageBar*>()->message().severity == widgets::Severity::Error;
    }));
    EXPECT_EQ(bench.design()->law.gains.proportional, 35.0);
}

} // namespace
} // namespace halbench::app
