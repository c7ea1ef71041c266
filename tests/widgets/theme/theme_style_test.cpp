#include "tests/widgets/gui_fixture.h"
#include "widgets/theme/theme_proxy.h"
#include "widgets/theme/theme_sheet.h"
#include "widgets/theme/theme_style.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontMetricsF>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolBar>
#include <QToolButton>
#include <QtTest/QTest>

#include <memory>

namespace halbench::widgets {
namespace {

using ThemeStyle = GuiTest;

bool hasPixelLike(const QImage& image, const QColor& colour) {
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixelColor(x, y) == colour) {
                return true;
            }
        }
    }
    return false;
}

TEST_F(ThemeStyle, dressesTheWholeApplicationAnewAtRunTime) {
    QLabel label(QStringLiteral("word"));
    label.ensurePolished();
    for (const char* name : {"dark", "light"}) {
        dress(name);
        const Theme theme = loadTheme(name).value();
        EXPECT_EQ(currentTheme().name, name);
        EXPECT_EQ(label.palette().color(QPalette::WindowText), theme.text);
        EXPECT_EQ(qApp->palette().color(QPalette::Disabled, QPalette::Text), theme.disabled);
        EXPECT_EQ(qApp->palette().color(QPalette::PlaceholderText), theme.muted);
        EXPECT_EQ(qApp->palette().color(QPalette::ToolTipText), theme.text);
        EXPECT_EQ(qApp->palette().color(QPalette::Link), theme.accent);
    }
}

TEST_F(ThemeStyle, rowsOfADropDownListAreAsHighAsThoseOfTables) {
    QComboBox box;
    box.addItems({"Idle", "Current", "Position"});
    box.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
    box.showPopup();
    constexpr int AboutTheLetters_px = 9; // rows of 26 px with letters of 17
    for (int row = 0; row < box.count(); ++row) {
        EXPECT_GE(box.view()->visualRect(box.model()->index(row, 0)).height(),
                  box.fontMetrics().height() + AboutTheLetters_px);
    }
    box.hidePopup();
}

TEST_F(ThemeStyle, aToolBarThatIsTooNarrowShowsThatItHasMore) {
    QWidget panel;
    QToolBar bar(&panel);
    for (const char* words : {"Follow", "Show all", "Cursors", "Marker"}) {
        bar.addAction(QLatin1String(words));
    }
    bar.setGeometry(0, 0, bar.sizeHint().width() / 2, bar.sizeHint().height());
    panel.resize(bar.size());
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    const auto* more = bar.findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    ASSERT_TRUE(more->isVisible());
    EXPECT_GE(more->width(), 20); // large enough to be hit
    const QImage inside = panel.grab(more->geometry().adjusted(2, 2, -2, -2)).toImage();
    EXPECT_TRUE(hasPixelLike(inside, loadTheme("light").value().text)); // a mark stands in it
    EXPECT_EQ(bar.widgetForAction(bar.actions().back())->isVisible(), false);
    EXPECT_EQ(more->menu()->actions().back(), bar.actions().back());
}

TEST_F(ThemeStyle, whatWasBuiltUndressedIsDressedAsIfItHadNotBeen) {
    dress("dark");
    QPushButton before(QStringLiteral("word"));
    before.ensurePolished();
    std::unique_ptr<QPushButton> built;
    buildUndressed(*qApp, [&built] {
        EXPECT_TRUE(qApp->styleSheet().isEmpty());
        built = std::make_unique<QPushButton>(QStringLiteral("word"));
        built->ensurePolished();
    });
    EXPECT_FALSE(qApp->styleSheet().isEmpty());
    before.resize(before.sizeHint());
    built->resize(built->sizeHint());
    EXPECT_EQ(built->grab().toImage(), before.grab().toImage());
}

TEST_F(ThemeStyle, leavesNoTokenUnresolvedInTheSheet) {
    for (const char* name : {"light", "dark"}) {
        EXPECT_FALSE(styleSheetOf(loadTheme(name).value(), 15).contains(QLatin1Char('@')));
    }
}

TEST_F(ThemeStyle, wordsOnFilledColoursCanBeRead) {
    for (const char* name : {"light", "dark"}) {
        const Theme theme = loadTheme(name).value();
        for (const QColor& filled : {theme.accent, theme.armed, theme.simulated}) {
            EXPECT_GE(contrastRatio(readableOn(theme, filled), filled), 4.5) << name;
        }
        const QColor selection = paletteOf(theme).color(QPalette::Highlight);
        EXPECT_GE(contrastRatio(paletteOf(theme).color(QPalette::HighlightedText), selection), 4.5);
    }
}

TEST_F(ThemeStyle, rolesAreKeptAndReadBack) {
    QPushButton button;
    EXPECT_EQ(roleOf(button), Role::None);
    for (const Role role : {Role::Stop, Role::Armed, Role::Simulated, Role::Warn, Role::Bad, Role::Good,
                            Role::Muted, Role::Primary, Role::None}) {
        setRole(button, role);
        EXPECT_EQ(roleOf(button), role);
    }
}

TEST_F(ThemeStyle, everyKindOfControlShowsTheFocusInTheAccent) {
    QPushButton button(QStringLiteral("Go"));
    QDoubleSpinBox spin;
    QComboBox combo;
    combo.addItem(QStringLiteral("one"));
    for (QWidget* widget :
         {static_cast<QWidget*>(&button), static_cast<QWidget*>(&spin), static_cast<QWidget*>(&combo)}) {
        widget->resize(120, 32);
        widget->show();
        widget->activateWindow();
        widget->setFocus(Qt::TabFocusReason);
        QApplication::setActiveWindow(widget);
        EXPECT_TRUE(QTest::qWaitFor([widget] { return widget->hasFocus(); }));
        EXPECT_TRUE(hasPixelLike(widget->grab().toImage(), currentTheme().accent))
            << widget->metaObject()->className();
        widget->hide();
    }
}

TEST_F(ThemeStyle, digitsHaveEqualWidths) {
    const QFontMetricsF metrics(tabularFont(qApp->font()));
    for (char digit = '0'; digit <= '9'; ++digit) {
        EXPECT_EQ(metrics.horizontalAdvance(QLatin1Char(digit)), metrics.horizontalAdvance(QLatin1Char('0')));
    }
}

TEST_F(ThemeStyle, chineseAndKoreanGetTheirOwnHanFace) {
    const auto faceOf = [](QLocale::Language language) {
        return applicationFont({QLocale(language), 10.0}).families().last();
    };
    EXPECT_EQ(faceOf(QLocale::Chinese), QStringLiteral("Noto Sans CJK SC"));
    EXPECT_EQ(faceOf(QLocale::Korean), QStringLiteral("Noto Sans CJK KR"));
    EXPECT_EQ(faceOf(QLocale::Japanese), QStringLiteral("Noto Sans CJK JP"));
}

} // namespace
} // namespace halbench::widgets
