#include "app/documents/result_documents.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/design_comparison.h"
#include "app/workspaces/tune/design_table.h"
#include "app/workspaces/tune/tune_session.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "tests/app/workspaces/published_motor.h"

#include <QStringList>
#include <QTableWidget>

namespace halbench::app {
namespace {

class DesignComparisonTest : public PanelTest {
protected:
    void identify() {
        bench.setIdentification(publishedMotor());
        session.readConditions({});
    }
    std::string documentOf(double proportional) const {
        TuneResult design;
        design.method = "edited";
        design.law.gains.proportional = proportional;
        design.law.gains.integral = 20.0;
        design.law.gains.derivative = 2.0;
        design.conditions = session.conditions();
        ResultHeader header;
        header.schema = "halbench.gains/1";
        return *toJsonText(gainsDocument(header, design));
    }
    QStringList drawn() const {
        QStringList names;
        for (const NamedLoop& loop : designs.drawnLoops()) {
            names << QString::fromStdString(loop.name);
        }
        return names;
    }

    TuneSession session{bench};
    DesignTable table;
    DesignComparison designs{bench, session, table};
};

TEST_F(DesignComparisonTest, savedDesignsAreJudgedOnceThereIsAMotor) {
    designs.restore({keptDesign("calm", documentOf(20.0)), keptDesign("torn", "{")});
    EXPECT_TRUE(drawn().isEmpty());
    identify(); // with the conditions
    ASSERT_TRUE(wait([&] { return drawn() == QStringList("calm"); }));
    designs.judgeAnew();
    EXPECT_TRUE(drawn().isEmpty()) << "until it is judged again";
    EXPECT_TRUE(wait([&] { return drawn() == QStringList("calm"); }));
}

TEST_F(DesignComparisonTest, lawThatIsSavedAlreadyIsNotSavedAgain) {
    const std::string document = documentOf(20.0);
    const LoopLaw law = keptDesign("", document).gains->loopLaw();
    EXPECT_EQ(designs.adoptLaw("kept on A", document, law), "kept on A");
    EXPECT_EQ(designs.adoptLaw("kept on B", document, law), "kept on A");
    EXPECT_EQ(designs.adoptLaw("kept on B", "another document", law), "kept on A") << "the same law";
    EXPECT_EQ(designs.adoptLaw("kept on A", documentOf(30.0), LoopLaw{}), "kept on A 2");
    EXPECT_EQ(designs.all().size(), 2U);
}

TEST_F(DesignComparisonTest, designIsTakenUpByItsName) {
    designs.restore({keptDesign("calm", documentOf(20.0)), keptDesign("torn", "{")});
    QStringList taken;
    QObject::connect(&designs, &DesignComparison::takenUp, &designs,
                     [&](const LoopLaw& law, const QString& name) {
                         taken << name << QString::number(law.law.gains.proportional);
                     });
    designs.takeUp("torn"); // cannot be read
    designs.takeUp("gone");
    EXPECT_TRUE(taken.isEmpty());
    designs.takeUp("calm");
    EXPECT_EQ(taken, QStringList({"calm", "20"}));
}

TEST_F(DesignComparisonTest, refusedNameIsToldAndTheOldOneStays) {
    designs.restore({keptDesign("calm", documentOf(20.0)), keptDesign("fast", documentOf(30.0))});
    std::optional<Error> failed;
    QObject::connect(&designs, &DesignComparison::failed, &designs,
                     [&](const Error& error) { failed = error; });
    Q_EMIT table.renameRequested(1, "calm");
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->code, ErrorCode::InvalidInput);
    EXPECT_EQ(designs.all()[1].name, "fast");
    Q_EMIT table.removeRequested(0);
    EXPECT_EQ(designs.all().size(), 1U);
    Q_EMIT table.undoRequested();
    EXPECT_EQ(designs.all().size(), 2U);
}

TEST_F(DesignComparisonTest, proposedGainsAreSavedUnderTheirMethod) {
    identify();
    session.ask(GainSource{"recommended"}, nullptr);
    ASSERT_TRUE(wait([&] { return session.proposed().has_value(); }));
    Q_EMIT table.keepRequested();
    ASSERT_EQ(designs.all().size(), 1U);
    EXPECT_EQ(designs.all()[0].name, "recommended");
    EXPECT_EQ(drawn(), QStringList("recommended")) << "its judgement is known";
}

} // namespace
} // namespace halbench::app
