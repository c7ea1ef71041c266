#include "tests/widgets/gui_fixture.h"
#include "widgets/language/phrasebook.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QTranslator>

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

/// A language of few words, made for these tests.
class FewWords : public QTranslator {
public:
    QString translate(const char* context, const char* source, const char*, int) const override {
        return QLatin1String(context) == QLatin1String("Phrases") ? m_words.value(QString::fromUtf8(source))
                                                                  : QString();
    }
    bool isEmpty() const override { return false; }

private:
    QHash<QString, QString> m_words = {
        {"the device has no parameter '{}'", "Parameter „{}“ fehlt"},
        {"a move of {} s is out of range", "{} s gehen nicht"},
        {"the board cannot be armed: {}", "keine Freigabe: {}"},
        {"current above its limit", "zu viel Strom"},
        {"a bandwidth of {} Hz is not possible with this motor at {} Hz sampling and {} samples of delay",
         "bei {1} Hz: {0} Hz"},
        {"the board stopped", "gestoppt"},
        {"Nothing was armed. Use a shorter run or less current, or let the motor cool.", "Abkühlen lassen!"},
        {"remove the cause, then release the stop", "Ursache finden"},
        {", the device clock is fast by {} +- {} ppm", ", Uhr: {} +- {}"},
        {"off", "aus"},
        {"orientations that are missing most: {} ({})", "Es fehlen: {} ({})"},
        {"alpha {}, beta {}, gamma {} deg", "alpha {}, beta {}, gamma {} Grad"},
    };
};

class PhrasebookTest : public GuiTest {
protected:
    void SetUp() override {
        GuiTest::SetUp();
        QLocale::setDefault(QLocale(QLocale::German));
        QCoreApplication::installTranslator(&words);
    }
    void TearDown() override {
        QCoreApplication::removeTranslator(&words);
        QLocale::setDefault(QLocale::c());
    }

    static std::string said(const char* english) { return inWords(std::string(english)).toStdString(); }

    FewWords words;
};

TEST_F(PhrasebookTest, saysAPhraseInTheUsersLanguage) {
    EXPECT_EQ(said("the board stopped"), "gestoppt");
}

TEST_F(PhrasebookTest, saysEveryTextOfAListThatIsFilledIn) {
    EXPECT_EQ(said("orientations that are missing most: alpha 1, beta 2, gamma 3 deg; alpha 4, beta 5, gamma "
                   "6 deg (the board stopped)"),
              "Es fehlen: alpha 1, beta 2, gamma 3 Grad; alpha 4, beta 5, gamma 6 Grad (gestoppt)");
    EXPECT_EQ(said("orientations that are missing most: alpha 1, beta 2, gamma 3 deg; another (the board "
                   "stopped)"),
              "Es fehlen: alpha 1, beta 2, gamma 3°; another (gestoppt)");
}

TEST_F(PhrasebookTest, fillsInNumbersWithTheSignOfTheLanguage) {
    EXPECT_EQ(said("a move of 0.01 s is out of range"), "0,01 s gehen nicht");
    EXPECT_EQ(said("a move of -1.5e-07 s is out of range"), "-1,5e-7 s gehen nicht");
}

TEST_F(PhrasebookTest, keepsWhatStandsInQuotes) {
    EXPECT_EQ(said("the device has no parameter 'off'"), "Parameter „off“ fehlt");
    EXPECT_EQ(said("the device has no parameter '1.5'"), "Parameter „1.5“ fehlt");
}

TEST_F(PhrasebookTest, looksUpWhatIsFilledIn) {
    EXPECT_EQ(said("the board cannot be armed: current above its limit"), "keine Freigabe: zu viel Strom");
}

TEST_F(PhrasebookTest, followsTheOrderOfTheTranslationAndMayLeaveOut) {
    EXPECT_EQ(said("a bandwidth of 90 Hz is not possible with this motor at 100 Hz sampling "
                   "and 1 samples of delay"),
              "bei 100 Hz: 90 Hz");
}

TEST_F(PhrasebookTest, looksUpEachOfSeveralSentences) {
    EXPECT_EQ(said("the board stopped. remove the cause, then release the stop"), "gestoppt. Ursache finden");
    EXPECT_EQ(
        said(
            "Nothing was armed. Use a shorter run or less current, or let the motor cool. the board stopped"),
        "Abkühlen lassen. gestoppt");
}

TEST_F(PhrasebookTest, looksUpASentenceBehindItsPlace) {
    EXPECT_EQ(said("motor.toml:3:1: the board stopped"), "motor.toml:3:1: gestoppt");
    EXPECT_EQ(said("tcp:127.0.0.1:1: value: the board stopped"), "tcp:127.0.0.1:1: value: gestoppt");
}

TEST_F(PhrasebookTest, looksUpWhatWasAddedToASentence) {
    EXPECT_EQ(said("the board stopped, the device clock is fast by 0.5 +- 0.1 ppm"),
              "gestoppt, Uhr: 0,5 \u00b1 0,1");
}

TEST_F(PhrasebookTest, leavesUnknownWordsAsTheyAre) {
    EXPECT_EQ(said("Drehzahl Spindel 2"), "Drehzahl Spindel 2");
    EXPECT_EQ(said(""), "");
    EXPECT_FALSE(isInPhrasebook("Drehzahl Spindel 2"));
    EXPECT_TRUE(isInPhrasebook("Angle error map, cosine of order 4"));
}

TEST(Phrasebook, writesPlusMinusAsASignOnTheScreen) {
    EXPECT_EQ(inWords(QStringLiteral("friction holds the rotor within +-8.2 deg of the reference")),
              QStringLiteral("friction holds the rotor within \u00b18.2\u00b0 of the reference"));
    EXPECT_EQ(inWords(QStringLiteral("'a+-1.csv' not found")), QStringLiteral("'a+-1.csv' not found"));
}

TEST(Phrasebook, writesDegreesAsASignOnTheScreen) {
    EXPECT_EQ(inWords(QStringLiteral("Gains read in degrees: 10 A/deg, 0.1 A/(deg s)")),
              QStringLiteral("Gains read in degrees: 10 A/\u00b0, 0.1 A/(\u00b0\u00b7s)"));
    EXPECT_EQ(inWords(QStringLiteral("the coils would reach 91 degC, 10 A/rad, 0.1 A/(rad s)")),
              QStringLiteral("the coils would reach 91 \u00b0C, 10 A/rad, 0.1 A/(rad\u00b7s)"));
    EXPECT_EQ(inWords(QStringLiteral("amplitude_deg=100 and 'sim/deg.csv'")),
              QStringLiteral("amplitude_deg=100 and 'sim/deg.csv'"));
}

TEST(Phrasebook, speaksEnglishLetterByLetterWithoutATranslator) {
    for (const char* text :
         {"the device has no parameter 'gain.kq'", "a move of 0.01 s is out of range",
          "the board cannot be armed: current above its limit",
          "parameter 'gain.kp' = 1e9 A/rad is out of range",
          "the board stopped. remove the cause, then release the stop", "no words of ours"}) {
        EXPECT_EQ(inWords(std::string(text)).toStdString(), text);
    }
}

} // namespace
} // namespace halbench::widgets
