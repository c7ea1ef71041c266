// Gains with weights and filters in the Tune panel: shown, kept, compared, written, applied.
#include "app/documents/filtered_gains.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/design_table.h"
#include "app/workspaces/tune/loop/filter_editor.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QCheckBox>
#include <QFile>
#include <QSlider>
#include <QTableWidget>
#include <QTextStream>

#include <algorithm>

namespace halbench::app {
namespace {

constexpr const char* Shaping = R"("filter_s": {"value": 0.002}, "setpoint_weights": {"b": 0.6, "c": 0},
  "filters": [{"kind": "notch", "frequency_rad_s": 180, "depth_ratio": 0.1, "damping_ratio": 0.5}])";

class TuneFiltersTest : public TunePanelTest {
protected:
    void SetUp() override {
        TunePanelTest::SetUp();
        panel.setFileChooser({[this](QWidget*, const FileQuestion&) { return m_saved; },
                              [this](QWidget*, const FileQuestion&) { return gainsPath(); }});
        connectMotor("sim:htm?seed=4", 0.0);
        bench.setIdentification(publishedMotor());
        ASSERT_TRUE(wait([&] { return canApply(); })) << verdict().toStdString();
    }

    void write(const QString& shaping) {
        QFile file(gainsPath());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        QTextStream(&file)
            << R"({"schema": "halbench.gains/1", "form": "parallel", "sample_period_s": 0.01, "method": "mine",
            "gains": {"kp": {"value": 38}, "ki": {"value": 50}, "kd": {"value": 1.3})"
            << (shaping.isEmpty() ? QString() : ", " + shaping) << "}}";
    }
    void open(const QString& shaping = Shaping) {
        write(shaping);
        click(panel, "Open gains\u2026");
        ASSERT_TRUE(wait([&] { return isFiltered() == !shaping.isEmpty() && shown("gain.kp") == 38.0; }))
            << message().toStdString();
    }
    bool isFiltered() const { return bench.design() && bench.design()->filtered.has_value(); }
    QString outlook() const {
        for (const auto* label : panel.findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains("cannot be applied:")) {
                return label->text();
            }
        }
        return {};
    }
    QAction* undo() const { return panel.historyActions().front(); }
    QAction* redo() const { return panel.historyActions().back(); }

    QString m_saved;
};

// Opened, judged with every filter, and for a board whose law has them; not in small steps.
TEST_F(TuneFiltersTest, gainsOfAFileAreShownWithTheirFiltersAndCanBeApplied) {
    open();
    EXPECT_TRUE(wait([&] { return canApply(); })) << verdict().toStdString();
    EXPECT_TRUE(outlook().isEmpty()) << outlook().toStdString();
    const auto ticks = panel.findChildren<QCheckBox*>();
    const auto found = std::find_if(ticks.begin(), ticks.end(),
                                    [](const QCheckBox* tick) { return tick->text() == "Apply gradually"; });
    ASSERT_NE(found, ticks.end());
    QCheckBox* inSteps = *found;
    inSteps->click();
    EXPECT_FALSE(canApply());
    EXPECT_TRUE(outlook().contains("cannot be applied gradually")) << outlook().toStdString();
    inSteps->click();
    EXPECT_TRUE(canApply());
    EXPECT_EQ(shown("weight.b"), 0.6);
    EXPECT_NEAR(shown("filter1.1"), 0.1, 1e-12);
    const auto& design = *bench.design();
    EXPECT_EQ(design.filtered->filters.size(), 1U);
    EXPECT_FALSE(design.robust.gainMargin_ratio == std::nullopt);
    ASSERT_TRUE(design.disturbance && design.predicted.largeStep && design.predicted.step);
    // Every page has its picture, with bands.
    const std::string band = "5-95 % band (motor uncertainty)";
    EXPECT_FALSE(curve("Open loop", band).empty());
    EXPECT_TRUE(wait([&] { return !curve("Predicted step with", band).empty(); }));
    click(panel, "Disturbance");
    ASSERT_NE(figure("Load step equal to 0.5 A"), nullptr);
    EXPECT_FALSE(curve("Load step equal to 0.5 A", band).empty());
    // Back to a plain law.
    choose("Source of the gains", "Method: recommended");
    EXPECT_TRUE(wait([&] { return canApply(); }));
    EXPECT_TRUE(outlook().isEmpty());
    EXPECT_FALSE(isFiltered());
}

TEST_F(TuneFiltersTest, aKeptOneComesBackFromTheProjectAndIsCompared) {
    open();
    click(panel, "Designs");
    click(panel, "Save design");
    const KeptDesign kept = panel.savedDesigns().back();
    ASSERT_TRUE(kept.gains && kept.gains->filtered);
    EXPECT_EQ(*kept.gains->filtered, *bench.design()->filtered);
    const double margin_deg = bench.design()->predicted.margins.phaseMargin_deg;
    open({}); // the same gains without
    EXPECT_GT(bench.design()->predicted.margins.phaseMargin_deg, margin_deg + 1.0);
    panel.setSavedDesigns({keptDesign("notched", kept.document)});
    auto& table = *panel.findChild<DesignTable*>()->findChild<QTableWidget*>();
    ASSERT_TRUE(wait([&] { return table.item(1, 1)->text() == "stable"; }))
        << table.item(1, 1)->text().toStdString();
    EXPECT_EQ(table.item(1, 2)->text(), widgets::numberText(margin_deg, 3));
    bool isSaid = false;
    for (int column = 0; column < table.columnCount(); ++column) {
        isSaid |= table.item(1, column)->text().contains("with filters");
    }
    EXPECT_TRUE(isSaid);
    table.setCurrentCell(1, 0);
    click(panel, "Use this design");
    EXPECT_TRUE(wait([&] { return isFiltered(); }));
    EXPECT_TRUE(wait([&] { return canApply(); }));
    EXPECT_FALSE(curve("Open loop", "notched").empty());
}

TEST_F(TuneFiltersTest, isSavedAsGainsThatReadBackAndAsC) {
    open();
    m_saved = m_folder.filePath("out.json");
    click(panel, "Save gains\u2026");
    ASSERT_TRUE(wait([&] { return message().startsWith("Saved as"); })) << message().toStdString();
    const auto again = readFilteredGains(m_saved.toStdString());
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->loopLaw(), LoopLaw(bench.design()->law, bench.design()->filtered));
    m_saved = m_folder.filePath("law.c");
    click(panel, "Save gains\u2026");
    ASSERT_TRUE(wait([&] { return QFile::exists(m_saved); })) << message().toStdString();
    QFile file(m_saved);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("FILTERS[SECTIONS]"));
}

// Edited like a gain: judged at once, taken back and done again.
TEST_F(TuneFiltersTest, weightsAndFiltersAreEditedTakenBackAndDoneAgain) {
    open({});
    click(panel, "Weights and filters");
    type("weight.b", "0.5");
    ASSERT_TRUE(wait([&] { return isFiltered(); }));
    EXPECT_EQ(bench.design()->filtered->proportionalWeight, 0.5);
    EXPECT_EQ(undo()->text(), "&Undo: Edit Set-point weight b (P)");
    click(panel, "Add a filter");
    ASSERT_TRUE(wait([&] { return isFiltered() && bench.design()->filtered->filters.size() == 1; }));
    EXPECT_TRUE(wait([&] { return canApply(); })) << "this board has filters";
    undo()->trigger();
    ASSERT_TRUE(wait([&] { return isFiltered() && bench.design()->filtered->filters.empty(); }));
    undo()->trigger();
    EXPECT_TRUE(wait([&] { return canApply(); })) << "the gains of the file alone";
    EXPECT_FALSE(isFiltered());
    EXPECT_EQ(shown("gain.kp"), 38.0);
    redo()->trigger();
    redo()->trigger();
    EXPECT_TRUE(wait([&] { return isFiltered() && bench.design()->filtered->filters.size() == 1; }));
    type("gain.kp", "30"); // the filters stay around other gains
    EXPECT_TRUE(wait([&] { return isFiltered() && bench.design()->filtered->gains.proportional == 30.0; }));
}

TEST_F(TuneFiltersTest, whatIsOpenedAndAddedIsScrolledIntoSight) {
    panel.resize(900, 480);
    click(panel, "Weights and filters");
    EXPECT_TRUE(wait([&] { return isWhole(panel, "Add a filter"); }));
    for (int i = 0; i < 3; ++i) {
        click(panel, "Add a filter");
        EXPECT_TRUE(wait([&] { return isWhole(panel, "Add a filter"); })) << i;
    }
}

TEST_F(TuneFiltersTest, whatIsNoFilterIsSaidInPlace) {
    open();
    type("filter1.1", "7");
    EXPECT_TRUE(wait([&] { return verdict().contains("Filter 1: Depth"); })) << verdict().toStdString();
    EXPECT_FALSE(canApply());
    type("filter1.1", "0.5");
    EXPECT_TRUE(wait([&] { return isFiltered(); }));
}

// The sliders move the loop that is drawn: with its filters.
TEST_F(TuneFiltersTest, theSlidersMoveTheFilteredLoop) {
    open();
    const auto before = bench.design()->predicted.margins;
    for (auto* slider : panel.findChildren<QSlider*>()) {
        if (slider->accessibleName().startsWith("Speed")) {
            slider->setFocus();
            QTest::keyClick(slider, Qt::Key_Left);
        }
    }
    ASSERT_TRUE(wait([&] {
        return isFiltered() &&
               *bench.design()->predicted.margins.gainCrossover_rad_s < 0.99 * *before.gainCrossover_rad_s;
    }));
    EXPECT_NEAR(bench.design()->predicted.margins.phaseMargin_deg, before.phaseMargin_deg, 0.01);
    EXPECT_EQ(bench.design()->filtered->filters.size(), 1U);
}

} // namespace
} // namespace halbench::app
