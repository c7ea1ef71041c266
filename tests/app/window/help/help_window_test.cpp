#include "app/window/docks/panels.h"
#include "app/window/help/help_pages.h"
#include "app/window/help/help_text.h"
#include "app/window/help/help_window.h"
#include "app/window/preferences/language.h"
#include "tests/app/window/window_test.h"

#include <QImage>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextDocument>
#include <QUrl>

namespace halbench::app {
namespace {

class HelpWindowTest : public WindowTest {
protected:
    ~HelpWindowTest() override { QLocale::setDefault(QLocale::c()); }

    static HelpText& textOf(const HelpWindow& help) { return *help.findChild<HelpText*>(); }
    /// What stands where the page was opened.
    static QString place(const HelpWindow& help) { return textOf(help).textCursor().block().text(); }
    static QString firstLine(const HelpWindow& help) { return textOf(help).document()->firstBlock().text(); }

    /// The headings of a page, read a second way.
    static QStringList headings(const QString& markdown) {
        QStringList found;
        for (const QString& line : markdown.split('\n')) {
            if (line.startsWith('#')) {
                found << QString(line).remove(QRegularExpression("^#+ ")).remove('`');
            }
        }
        return found;
    }
};

struct PanelPlace {
    const char* panel;
    const char* page;
    const char* heading; ///< in English; empty: the whole page
};

constexpr PanelPlace Places[] = {{"devices", "monitor.md", "Devices"},
                                 {"signals", "monitor.md", "Plots"},
                                 {"recordings", "monitor.md", "Recordings"},
                                 {"monitor", "monitor.md", "Plots"},
                                 {"spectrum", "monitor.md", "Spectrum"},
                                 {"xy", "monitor.md", "XY"},
                                 {"field", "monitor.md", "Field"},
                                 {"drive", "monitor.md", "Drive"},
                                 {"parameters", "monitor.md", "Parameters"},
                                 {"configuration", "monitor.md", "Configuration"},
                                 {"record", "monitor.md", "Recording"},
                                 {"identify", "identification.md", "7. In the window"},
                                 {"calibrate", "identification.md", "6. Calibrations"},
                                 {"frequency", "identification.md", "8. Frequency response"},
                                 {"relay", "identification.md", "9. Relay experiment"},
                                 {"tune", "tuning.md", "In the window"},
                                 {"log", "monitor.md", "Stop, faults, a device that fails"},
                                 {"derived", "monitor.md", "Derived signals"},
                                 {"monitor2", "monitor.md", "Further monitors"},
                                 {"monitor3", "monitor.md", "Further monitors"},
                                 {"notes", "projects.md", ""},
                                 {"coverage", "monitor.md", "Coverage"},
                                 {"estimators", "monitor.md", "Estimators"},
                                 {"angle_error", "monitor.md", "Angle error"}};

TEST_F(HelpWindowTest, everyPanelsHelpIsTheSameSectionInEveryLanguage) {
    for (const Language& language : languages()) {
        speak(application, language.id);
        const std::vector<PanelSpec> specs = panelSpecs();
        ASSERT_EQ(specs.size(), std::size(Places));
        for (const PanelPlace& expected : Places) {
            const auto spec = std::find_if(specs.begin(), specs.end(),
                                           [&](const PanelSpec& one) { return one.id == expected.panel; });
            ASSERT_NE(spec, specs.end()) << expected.panel;
            const QString own = helpText(expected.page, language.id);
            const QStringList shown = headings(own.isEmpty() ? helpText(expected.page) : own);
            const int index = headings(helpText(expected.page)).indexOf(expected.heading);
            ASSERT_EQ(index < 0, *expected.heading == '\0') << expected.panel;
            HelpWindow help(spec->helpAddress);
            help.show();
            EXPECT_EQ(place(help), index < 0 ? firstLine(help) : shown.at(index))
                << expected.panel << ' ' << language.id.toStdString();
        }
    }
}

TEST_F(HelpWindowTest, theSectionStandsAtTheTop) {
    for (const Language& language : languages()) {
        speak(application, language.id);
        HelpWindow help("monitor.md#drive");
        help.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
        const HelpText& text = textOf(help);
        EXPECT_GT(text.verticalScrollBar()->value(), 0);
        EXPECT_LT(text.cursorRect().top(), text.viewport()->height() / 4) << language.id.toStdString();
    }
}

TEST_F(HelpWindowTest, aPageOfTheWindowIsInItsLanguage) {
    speak(application, "de");
    EXPECT_EQ(firstLine(HelpWindow("index.md")), "Halbench: Hilfe");
    speak(application, "zh_CN");
    EXPECT_EQ(firstLine(HelpWindow("projects.md")), QString::fromUtf8("项目"));
}

TEST_F(HelpWindowTest, aPageInEnglishOnlySaysSoInTheLanguageOfTheWindow) {
    speak(application, "en");
    const QString title = firstLine(HelpWindow("protocol.md"));
    speak(application, "de");
    const HelpWindow help("protocol.md");
    EXPECT_EQ(firstLine(help), "Diese Seite ist nur auf Englisch verfügbar.");
    EXPECT_EQ(textOf(help).document()->firstBlock().next().text(), title);
}

TEST_F(HelpWindowTest, linksLeadOnInTheLanguageAndIntoPagesThatAreInEnglishOnly) {
    speak(application, "de");
    HelpWindow help("index.md");
    Q_EMIT textOf(help).anchorClicked(QUrl("../command-line.md"));
    EXPECT_EQ(firstLine(help), "Diese Seite ist nur auf Englisch verfügbar.");
    Q_EMIT textOf(help).anchorClicked(QUrl("projects.md#mehrere-fenster")); // as the page itself calls it
    EXPECT_EQ(place(help), "Mehrere Fenster");
    Q_EMIT textOf(help).anchorClicked(QUrl("projects.md#nothing-is-lost")); // as an English page calls it
    EXPECT_EQ(place(help), "Nichts geht verloren");
    speak(application, "zh_CN");
    HelpWindow chinese("index.md");
    Q_EMIT textOf(chinese).anchorClicked(QUrl(QString::fromUtf8("projects.md#多个窗口")));
    EXPECT_EQ(place(chinese), QString::fromUtf8("多个窗口"));
}

TEST_F(HelpWindowTest, picturesAreThereAndNoWiderThanTheText) {
    for (const Language& language : languages()) {
        speak(application, language.id);
        HelpWindow help("monitor.md");
        help.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
        const QTextDocument& page = *textOf(help).document();
        int count = 0;
        for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
            for (auto part = block.begin(); !part.atEnd(); ++part) {
                const QTextImageFormat format = part.fragment().charFormat().toImageFormat();
                if (format.isValid()) {
                    const QVariant found = page.resource(QTextDocument::ImageResource, QUrl(format.name()));
                    const auto picture = found.value<QImage>();
                    EXPECT_FALSE(picture.isNull()) << format.name().toStdString();
                    EXPECT_LE(picture.width() / picture.devicePixelRatio(), textOf(help).viewport()->width());
                    ++count;
                }
            }
        }
        EXPECT_EQ(count, 7) << language.id.toStdString();
    }
}

TEST_F(HelpWindowTest, emphasisIsReadAsSuchInEveryLanguage) {
    for (const Language& language : languages()) {
        for (const char* page : {"index.md", "monitor.md", "identification.md", "tuning.md", "projects.md"}) {
            QTextDocument english;
            english.setMarkdown(helpText(page));
            QTextDocument shown;
            shown.setMarkdown(helpText(page, language.id));
            if (!shown.isEmpty()) { // a mark that is not read as one stays in the text
                EXPECT_EQ(shown.toPlainText().count('*'), english.toPlainText().count('*'))
                    << page << ' ' << language.id.toStdString();
                EXPECT_EQ(headingsOf(shown).size(), headingsOf(english).size());
            }
        }
    }
}

} // namespace
} // namespace halbench::app
