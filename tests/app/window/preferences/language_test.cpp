#include "app/window/preferences/language.h"
#include "tests/app/window/window_test.h"

#include <QMenuBar>
#include <QSettings>
#include <QToolButton>

namespace halbench::app {
namespace {

class LanguageTest : public WindowTest {
protected:
    ~LanguageTest() override { QLocale::setDefault(QLocale::c()); }

    QAction* action(const QString& text) {
        for (auto* one : window->findChildren<QAction*>()) {
            if (one->text().remove('&') == text) {
                return one;
            }
        }
        return nullptr;
    }
};

TEST_F(LanguageTest, isTheWishThenTheSystemsThenEnglish) {
    EXPECT_EQ(chosenLanguage("de", {"zh-Hans-CN"}), "de");
    EXPECT_EQ(chosenLanguage("", {"fr-FR", "de-AT", "en-GB"}), "de");
    EXPECT_EQ(chosenLanguage("", {"zh-Hans-CN"}), "zh_CN");
    EXPECT_EQ(chosenLanguage("", {"zh-TW", "fr"}), "en"); // traditional Chinese is another script
    EXPECT_EQ(chosenLanguage("klingon", {}), "en");
}

TEST_F(LanguageTest, numbersAreWrittenAsTheSystemDoesWhenItSpeaksTheLanguage) {
    EXPECT_EQ(localeOf("de", QLocale("de_AT")).name(), "de_AT");
    EXPECT_EQ(localeOf("de", QLocale("en_US")).decimalPoint(), ',');
    EXPECT_EQ(localeOf("en", QLocale("de_DE")).decimalPoint(), '.');
    EXPECT_EQ(localeOf("zh_CN", QLocale("zh_TW")).country(), QLocale::China);
}

TEST_F(LanguageTest, theWindowSpeaksIt) {
    EXPECT_EQ(spokenLanguage(), "en");
    for (const char* one : {"zh_CN", "en", "de"}) {
        speak(application, one);
        EXPECT_EQ(spokenLanguage(), one);
    }
    open();
    EXPECT_NE(action("Datei"), nullptr);
    EXPECT_EQ(QLocale().decimalPoint(), ',');
}

TEST_F(LanguageTest, theDocksSpeakItToo) {
    speak(application, "de");
    open();
    QStringList helps;
    for (const QToolButton* button : window->findChildren<QToolButton*>()) {
        helps << button->toolTip();
    }
    EXPECT_TRUE(helps.contains("Gruppe ablösen"));
    EXPECT_TRUE(helps.contains("Alle Reiter anzeigen"));
    for (const char* words : {"Detach", "Close", "Close Others"}) { // of the menu of a tab
        EXPECT_NE(QCoreApplication::translate("ads::CDockWidgetTab", words), QLatin1String(words));
    }
}

TEST_F(LanguageTest, aPluralHasItsOwnFormInEveryLanguage) {
    const char* const context = "halbench::app::ParametersPanel";
    const auto said = [&](int count) {
        return QCoreApplication::translate(context, "%n value(s) written and read back.", nullptr, count);
    };
    speak(application, "en");
    EXPECT_EQ(said(1), "1 value written and read back.");
    EXPECT_EQ(said(2), "2 values written and read back.");
    speak(application, "de"); // the last one wins
    EXPECT_EQ(said(1), "1 Wert geschrieben und zurückgelesen.");
}

TEST_F(LanguageTest, theMenuKeepsTheChoiceForTheNextStart) {
    open();
    ASSERT_NE(action("Deutsch"), nullptr);
    action("Deutsch")->trigger();
    EXPECT_EQ(loadPreferences().language, "de");
    auto* message = window->findChild<widgets::MessageBar*>("window_message");
    EXPECT_TRUE(message->isVisible()); // it says when the words change
    QSettings().remove("language");
}

} // namespace
} // namespace halbench::app
