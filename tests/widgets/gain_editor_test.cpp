#include "tests/widgets/gui_fixture.h"
#include "widgets/gain_editor.h"
#include "widgets/quantity_edit.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QtTest/QTest>

#include <cmath>

namespace halbench::widgets {
namespace {

using QuantityEditTest = GuiTest;
using GainEditorTest = GuiTest;

void type(QuantityEdit& edit, const char* text) {
    edit.selectAll();
    QTest::keyClicks(&edit, QString::fromUtf8(text));
    QTest::keyClick(&edit, Qt::Key_Return);
}

TEST_F(QuantityEditTest, takesTheUsersNotationTheProgrammersAndTheUnit) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    QuantityEdit edit;
    edit.setLocale(QLocale());
    edit.setFormat({QStringLiteral("A"), -4.0, 4.0, 0.1, 3});
    type(edit, "1,5");
    EXPECT_EQ(edit.value(), 1.5);
    type(edit, "-2.25");
    EXPECT_EQ(edit.value(), -2.25);
    EXPECT_EQ(edit.text(), QStringLiteral("-2,250\u00a0A"));
    QLocale::setDefault(before);
}

TEST_F(QuantityEditTest, isAlwaysFiniteAndInsideItsLimits) {
    QuantityEdit edit;
    edit.setFormat({QStringLiteral("A"), -4.0, 4.0, 0.1, 3});
    QSignalSpy edits(&edit, &QuantityEdit::edited);
    for (const char* text : {"nan", "inf", "-inf", "1e999", "99", "", "--1", "e"}) {
        type(edit, text);
        EXPECT_TRUE(std::isfinite(edit.value())) << text;
        EXPECT_LE(std::abs(edit.value()), 4.0) << text;
    }
    int position = 0;
    QString nan = QStringLiteral("nan");
    EXPECT_EQ(edit.validate(nan, position), QValidator::Invalid);
}

TEST_F(QuantityEditTest, onlyTheUserEdits) {
    QuantityEdit edit;
    edit.setFormat({QStringLiteral("A"), -4.0, 4.0, 0.1, 3});
    QSignalSpy edits(&edit, &QuantityEdit::edited);
    edit.setQuantity(1.0);
    EXPECT_EQ(edits.count(), 0);
    QTest::keyClick(&edit, Qt::Key_Up);
    EXPECT_EQ(edits.count(), 1);
    EXPECT_NEAR(edit.value(), 1.1, 1e-12);
    QTest::keyClick(&edit, Qt::Key_PageDown);
    EXPECT_NEAR(edit.value(), 0.1, 1e-12);
    EXPECT_FALSE(edit.toolTip().isEmpty());
}

control::PidGains gains(double p, double i, double d) {
    control::PidGains result;
    result.proportional = p;
    result.integral = i;
    result.derivative = d;
    return result;
}

TEST_F(GainEditorTest, comparesTheEditedWithTheDevices) {
    GainEditor editor;
    ASSERT_TRUE(editor.setDeviceGains(gains(10.0, 0.1, 0.0)));
    ASSERT_TRUE(editor.setEditedGains(gains(10.0, 0.1, 0.0)));
    EXPECT_FALSE(editor.isChanged());
    QSignalSpy edits(&editor, &GainEditor::edited);
    auto* kp = editor.findChild<QuantityEdit*>();
    type(*kp, "40");
    EXPECT_EQ(edits.count(), 1);
    EXPECT_EQ(editor.editedGains().proportional, 40.0);
    EXPECT_TRUE(editor.isChanged());
}

TEST_F(GainEditorTest, turningTheUnitNeitherChangesNorRoundsTheGains) {
    GainEditor editor;
    const control::PidGains exact = gains(40.0 / 3.0, 60.0 / 7.0, 1.4 / 3.0);
    ASSERT_TRUE(editor.setDeviceGains(exact));
    ASSERT_TRUE(editor.setEditedGains(exact));
    QSignalSpy edits(&editor, &GainEditor::edited);
    editor.setAngleUnit(AngleUnit::Degree);
    editor.setAngleUnit(AngleUnit::Radian);
    EXPECT_EQ(edits.count(), 0);
    EXPECT_EQ(editor.editedGains().proportional, exact.proportional);
    EXPECT_EQ(editor.editedGains().derivative, exact.derivative);
    EXPECT_FALSE(editor.isChanged());
}

TEST_F(GainEditorTest, gainsPerDegreeAreTypedAsSuch) {
    GainEditor editor;
    editor.setAngleUnit(AngleUnit::Degree);
    auto* kp = editor.findChild<QuantityEdit*>();
    EXPECT_TRUE(kp->suffix().contains(QStringLiteral("A/deg")));
    type(*kp, "10");
    // resources/help/htm-theory.md section 10, 12; the figure has six digits
    EXPECT_NEAR(editor.editedGains().proportional, 572.958, 5e-4);
}

TEST_F(GainEditorTest, showsAnyFormInTheParallelOneOrRefuses) {
    GainEditor editor;
    control::PidGains standard;
    standard.form = control::PidForm::Standard;
    standard.proportional = 10.0;
    standard.integral = 2.0;   // T_i: K_I = K/T_i = 5
    standard.derivative = 0.1; // T_d: K_D = K T_d = 1
    ASSERT_TRUE(editor.setEditedGains(standard));
    EXPECT_DOUBLE_EQ(editor.editedGains().integral, 5.0);
    EXPECT_DOUBLE_EQ(editor.editedGains().derivative, 1.0);
    standard.proportional = std::nan("");
    EXPECT_EQ(editor.setEditedGains(standard).error().code, ErrorCode::NotFinite);
    EXPECT_DOUBLE_EQ(editor.editedGains().integral, 5.0);
}

TEST_F(GainEditorTest, isNamedForThoseWhoListen) {
    GainEditor editor;
    for (const QuantityEdit* edit : editor.findChildren<QuantityEdit*>()) {
        EXPECT_FALSE(edit->accessibleName().isEmpty());
        EXPECT_FALSE(edit->toolTip().isEmpty());
    }
}

} // namespace
} // namespace halbench::widgets
