// The verification move has a second route: the headless program, with all imperfections of the motor.
#include "app/documents/result_documents.h"
#include "app/documents/text/json_value.h"
#include "app/workbench/shared_results.h"
#include "control/base/units.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QFile>

namespace halbench::app {
namespace {

class TuneSameAsBatchTest : public TunePanelTest {
protected:
    /// The published motor as it was identified on the device that is connected, as a file too.
    void identifyHere() {
        Provenance from;
        from.header = bench.beginResult("halbench.identification/1");
        const auto text = toJsonText(identificationDocument(from.header, publishedMotor()));
        ASSERT_TRUE(text);
        QFile file(model());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(*text));
        file.close();
        bench.setIdentification(publishedMotor(), from);
        ASSERT_TRUE(wait([&] { return canApply(); })) << verdict().toStdString();
    }
    QString model() const { return m_folder.filePath("model.json"); }

    /// What the headless program writes of the apply.
    JsonValue appliedByBatch(const QString& uri) {
        QProcess batch;
        batch.start(HALBENCH_PROGRAM,
                    {"tune", model(), "--apply", uri, "--out", m_folder.filePath("batch.json"), "--force"});
        EXPECT_TRUE(wait([&] { return batch.state() == QProcess::NotRunning; }));
        EXPECT_EQ(batch.exitCode(), 0) << batch.readAllStandardError().toStdString();
        QFile file(m_folder.filePath("batch.json"));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        const Result<JsonValue> document = parseJson(file.readAll().toStdString(), "batch.json");
        EXPECT_TRUE(document);
        const JsonValue* applied = document ? document->find("applied") : nullptr;
        EXPECT_NE(applied, nullptr);
        return applied == nullptr ? JsonValue() : *applied;
    }

    const widgets::Curve& drawn(std::size_t part, const std::string& label) const {
        for (const widgets::Curve& each : figure("Verification")->figure().panels.at(part).curves) {
            if (each.label == label) {
                return each;
            }
        }
        throw std::out_of_range(label);
    }

    /// Where what is drawn as measured is farthest from what is drawn as predicted.
    double farthest_rad() const {
        const widgets::Curve& measured = drawn(0, "measured");
        const widgets::Curve& predicted = drawn(0, "predicted");
        double farthest_rad = 0.0;
        for (std::size_t i = 0; i < measured.x.size(); ++i) {
            const auto after = std::lower_bound(predicted.x.begin(), predicted.x.end(), measured.x[i]);
            if (after == predicted.x.begin() || after == predicted.x.end()) {
                continue;
            }
            const auto next = static_cast<std::size_t>(after - predicted.x.begin());
            const double share_ratio =
                (measured.x[i] - predicted.x[next - 1]) / (predicted.x[next] - predicted.x[next - 1]);
            const double off_rad =
                measured.y[i] - std::lerp(predicted.y[next - 1], predicted.y[next], share_ratio);
            farthest_rad = std::abs(off_rad) > std::abs(farthest_rad) ? off_rad : farthest_rad;
        }
        return farthest_rad;
    }
};

TEST_F(TuneSameAsBatchTest, theVerificationMoveGivesTheSameNumbersForTheSameSeed) {
    const QString uri = "sim:htm?seed=4";
    connectMotor(uri, 0.0);
    identifyHere();
    const JsonValue batch = appliedByBatch(uri);
    ASSERT_TRUE(batch.isObject());
    verify();
    // Rounding of degrees alone is left: the samples are the same bits.
    constexpr double Rounding_deg = 1e-12;
    EXPECT_NEAR(radiansToDegrees(farthest_rad()),
                batch.find("agreement")->find("largest_difference_deg")->number(), Rounding_deg);
    const std::vector<double>& command_A = drawn(2, "measured").y;
    const auto [least, most] = std::minmax_element(command_A.begin(), command_A.end());
    EXPECT_EQ(std::max(-*least, *most), batch.find("verification")->find("peak_current_A")->number());
    const auto values = valuesNow();
    ASSERT_FALSE(batch.find("after")->items().empty());
    for (const JsonValue& after : batch.find("after")->items()) {
        EXPECT_EQ(values.at(after.find("name")->text()), after.find("value")->number());
    }
    // Another noise gives other numbers, so that these say something.
    const JsonValue other = appliedByBatch("sim:htm?seed=5");
    EXPECT_GT(std::abs(radiansToDegrees(farthest_rad()) -
                       other.find("agreement")->find("largest_difference_deg")->number()),
              Rounding_deg);
}

} // namespace
} // namespace halbench::app
