#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/number_text.h"
#include "widgets/theme/theme_style.h"

#include <QLineEdit>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

namespace halbench::widgets {
namespace {

/// A field with the focus in a window; what is typed is typed by keys.
class QuantityEditTest : public GuiTest {
protected:
    void SetUp() override {
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        edit = new QuantityEdit(&window);
        edit->setFormat({QStringLiteral("°"), -36000.0, 36000.0, 1.0, 2});
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        edit->setFocus();
    }
    void TearDown() override { QLocale::setDefault(before); }
    void type(const QString& text) {
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClicks(edit, text);
    }
    bool isRed() const { return roleOf(*edit) == Role::Bad; }

    QLocale before;
    QWidget window;
    QuantityEdit* edit = nullptr;
};

TEST_F(QuantityEditTest, lettersStayToBeSeenAndAreNamed) {
    type(QStringLiteral("12x"));
    EXPECT_TRUE(edit->findChild<QLineEdit*>()->text().startsWith(QStringLiteral("12x"))) << "not swallowed";
    EXPECT_TRUE(isRed());
    EXPECT_TRUE(edit->problem().startsWith(QStringLiteral("'x'"))) << edit->problem().toStdString();
    EXPECT_TRUE(edit->problem().contains(edit->allowedText()));
    EXPECT_EQ(QToolTip::text(), bubbleOf(edit->problem())) << "beside the field, at once";
    EXPECT_EQ(edit->accessibleDescription(), edit->problem());
    QTest::keyClick(edit, Qt::Key_Backspace);
    EXPECT_TRUE(edit->problem().isEmpty());
    EXPECT_FALSE(isRed());
    EXPECT_EQ(edit->accessibleDescription(), edit->rangeText());
}

TEST_F(QuantityEditTest, theDecimalSignOfAnotherLanguageIsNamedAsTheCause) {
    type(QStringLiteral("12,5"));
    EXPECT_TRUE(edit->problem().startsWith(QStringLiteral("','"))) << edit->problem().toStdString();
    EXPECT_TRUE(edit->problem().contains(QStringLiteral("Use '.'"))) << edit->problem().toStdString();
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    type(QStringLiteral("12,5"));
    EXPECT_TRUE(edit->problem().isEmpty());
    type(QStringLiteral("1.500")); // 1500 or 1,5
    EXPECT_TRUE(edit->problem().startsWith(QStringLiteral("'.'"))) << edit->problem().toStdString();
    EXPECT_TRUE(edit->problem().contains(QStringLiteral("Use ','"))) << edit->problem().toStdString();
}

TEST_F(QuantityEditTest, aWordMayStandForTheLeastValue) {
    edit->setFormat({QStringLiteral("s"), 0.0, 10.0, 0.5, 1});
    edit->setSpecialValueText(QStringLiteral("automatic"));
    edit->setQuantity(0.0);
    const auto* line = edit->findChild<QLineEdit*>();
    EXPECT_EQ(line->text(), QStringLiteral("automatic"));
    EXPECT_TRUE(edit->problem().isEmpty());
    const QSignalSpy edited(edit, &QuantityEdit::edited);
    const QSignalSpy refused(edit, &QuantityEdit::refused);
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(edited.count(), 0);
    type(QStringLiteral("2.5"));
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(edit->value(), 2.5);
    type(QStringLiteral("0"));
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(line->text(), QStringLiteral("automatic"));
    EXPECT_EQ(edited.count(), 2);
    EXPECT_EQ(refused.count(), 0);
    type(QStringLiteral("auto"));
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(refused.count(), 1) << "half a word is no number";
    EXPECT_FALSE(edit->problem().isEmpty());
}

TEST_F(QuantityEditTest, whatIsHalfTypedIsNoMistakeYet) {
    for (const char* text : {"", "-", "1e", "1e-", "12.", "12 d", "12 de", "12 deg", "12 °"}) {
        type(QString::fromUtf8(text));
        EXPECT_TRUE(edit->problem().isEmpty()) << text << ": " << edit->problem().toStdString();
    }
}

TEST_F(QuantityEditTest, whatMoreDigitsCannotMendIsSaidAtOnce) {
    for (const char* text : {"40000", "-36001"}) {
        type(QString::fromUtf8(text));
        EXPECT_EQ(edit->problem(), edit->allowedText()) << text;
    }
    edit->setFormat({QStringLiteral("A"), 10.0, 20.0, 1.0, 2});
    type(QStringLiteral("1")); // 15 begins so
    EXPECT_TRUE(edit->problem().isEmpty()) << edit->problem().toStdString();
    type(QStringLiteral("-5"));
    EXPECT_FALSE(edit->problem().isEmpty());
}

TEST_F(QuantityEditTest, aTextThatWasRefusedIsNeverReadAnotherWay) {
    struct Case {
        QLocale locale;
        const char* text; // with what separates thousands there
    };
    for (const Case& typed : {Case{QLocale(QLocale::English, QLocale::UnitedStates), "1,5"},
                              Case{QLocale(QLocale::German, QLocale::Germany), "1.500"}}) {
        QLocale::setDefault(typed.locale);
        edit->setLocale(typed.locale);
        edit->setQuantity(30.0);
        edit->setFocus();
        QSignalSpy edits(edit, &QuantityEdit::edited);
        type(QString::fromUtf8(typed.text));
        edit->clearFocus();
        EXPECT_EQ(edit->value(), 30.0) << typed.text;
        EXPECT_EQ(edits.count(), 0) << typed.text;
    }
}

TEST_F(QuantityEditTest, theUnitMayBeTyped) {
    type(QStringLiteral("12 deg"));
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(edit->value(), 12.0);
}

TEST_F(QuantityEditTest, anArrowKeyTakesTheTextBackAndTheNextOneSteps) {
    type(QStringLiteral("12x"));
    QTest::keyClick(edit, Qt::Key_Up);
    EXPECT_TRUE(edit->problem().isEmpty());
    EXPECT_FALSE(isRed());
    EXPECT_EQ(edit->text(), QString::fromUtf8("0.00\u00a0°"));
    QTest::keyClick(edit, Qt::Key_Up);
    EXPECT_EQ(edit->value(), 1.0);
}

TEST_F(QuantityEditTest, enterSaysWhyItWasRefusedAndLeavingTakesTheTextBack) {
    QSignalSpy refusals(edit, &QuantityEdit::refused);
    type(QStringLiteral("40000"));
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(refusals.count(), 1);
    EXPECT_TRUE(isRed());
    EXPECT_EQ(edit->problem(), edit->allowedText()) << "only the limits are what is wrong";
    edit->clearFocus();
    EXPECT_FALSE(isRed()) << "it shows the number before";
    EXPECT_EQ(edit->value(), 0.0);
}

TEST_F(QuantityEditTest, aNumberThatIsOptionalIsJudgedByTheSameWords) {
    OptionalNumberEdit optional;
    for (const char* text : {"12,5", "1x", "1 2"}) {
        optional.clear();
        QTest::keyClicks(&optional, text);
        EXPECT_EQ(optional.problem(), numberProblem(text)) << text;
        EXPECT_FALSE(optional.problem().isEmpty()) << text;
    }
}

} // namespace
} // namespace halbench::widgets
