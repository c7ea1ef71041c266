#include "app/workspaces/tune/axes/axis_response_button.h"
#include "tests/app/workspaces/tune/axes/axis_model_fixture.h"
#include "tests/widgets/gui_fixture.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include <optional>

namespace halbench::app {
namespace {

class AxisResponseButtonTest : public widgets::GuiTest {
protected:
    AxisResponseButtonTest() {
        QObject::connect(&button, &AxisResponseButton::opened, [this](const auto& found) { plants = found; });
        QObject::connect(&button, &AxisResponseButton::failed, [this](const Error& each) { error = each; });
    }
    /// Presses it with a file of this text; true when it was taken or refused.
    bool open(const QByteArray& text) {
        const QString path = folder.filePath("response.json");
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        const auto chosen = [path](QWidget*, const FileQuestion&) { return path; };
        button.setFileChooser({chosen, chosen});
        plants.reset();
        error.reset();
        QTest::mouseClick(&button, Qt::LeftButton);
        constexpr int Patience_ms = 60000; // a busy machine
        return QTest::qWaitFor([this] { return plants || error; }, Patience_ms);
    }
    static QByteArray response(const QByteArray& device, const QByteArray& axis, const QByteArray& unit) {
        return R"({"schema": "halbench.axis-frequency/1", "sample_period_s": 0.001, "delay_samples": 1,
                   "device": {"model": ")" +
               device + R"("}, "axes": [{"axis": ")" + axis + R"(", "position_unit": ")" + unit +
               R"(", "effort_unit": "N", "gains": {"kp": 660, "ki": 1267, "kd": 39.8, "filter_s": 0.002}}],
                   "points": [{"frequency_hz": 5, "coherence": [0.99], "used": [true],
                               "loops": [{"re": -2, "im": -1}]}]})";
    }

    QTemporaryDir folder;
    AxisLoops loops;
    AxisResponseButton button{loops};
    std::optional<std::map<std::string, MeasuredPlant>> plants;
    std::optional<Error> error;
};

TEST_F(AxisResponseButtonTest, isHiddenWithoutFileChooser) {
    EXPECT_TRUE(button.isHidden());
    button.setFileChooser({{}, [](QWidget*, const FileQuestion&) { return QString(); }});
    EXPECT_FALSE(button.isHidden());
    QTest::mouseClick(&button, Qt::LeftButton); // no file was chosen
    EXPECT_FALSE(plants || error);
}

TEST_F(AxisResponseButtonTest, responseOfTheModelsAxesIsOpened) {
    loops.setModel(platenModelFile());
    ASSERT_TRUE(open(response("planar", "x", "m")));
    ASSERT_TRUE(plants) << error->message;
    EXPECT_EQ(plants->size(), 1U);
    EXPECT_EQ(plants->count("x"), 1U);
}

TEST_F(AxisResponseButtonTest, responseThatDoesNotFitIsRefusedWithTheReason) {
    ASSERT_TRUE(open(response("planar", "x", "m")));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->message, "no axes were identified");
    loops.setModel(platenModelFile());
    ASSERT_TRUE(open(response("stage", "x", "m")));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->message, "the response is of a device 'stage', the model is of a 'planar'");
    ASSERT_TRUE(open(response("planar", "x", "rad")));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->message, "axis x: the response is in rad/(N), the model in m/(N)");
    ASSERT_TRUE(open(response("planar", "z", "m")));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->message, "the response is of axes z, the model has x, y, phi");
}

TEST_F(AxisResponseButtonTest, fileOfAMotorIsRefused) {
    loops.setModel(platenModelFile());
    ASSERT_TRUE(open(R"({"schema": "halbench.frequency/1"})"));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::InvalidInput);
}

} // namespace
} // namespace halbench::app
