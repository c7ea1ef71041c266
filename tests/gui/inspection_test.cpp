#include "tests/gui/inspection.h"
#include "widgets/controls/elided_label.h"
#include "widgets/language/whole_numbers.h"

#include <QAction>
#include <QApplication>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPalette>
#include <QPushButton>
#include <QTabBar>
#include <QTableWidget>
#include <QtTest/QTest>

#include <gtest/gtest.h>

namespace halbench::gui {
namespace {

/// The walk is worth as much as what it finds: each of its rules is shown something wrong.
class InspectionTest : public testing::Test {
protected:
    struct Platform {
        Platform() { qputenv("QT_QPA_PLATFORM", "offscreen"); }
    };

    template <typename Widget>
    Widget* make(const QString& text) {
        auto* widget = new Widget(&root);
        widget->setText(text);
        widget->setToolTip(QStringLiteral("what it does"));
        widget->setAccessibleName(QStringLiteral("name"));
        widget->resize(300, 40);
        return widget;
    }

    QString found(const QHash<QString, QString>& phrases = {}) {
        root.resize(400, 60);
        root.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&root));
        return inspect(root, phrases).join('\n');
    }

    class NarrowTabs : public QTabBar {
    public:
        using QTabBar::QTabBar;
        int width_px = 200;

    protected:
        QSize tabSizeHint(int index) const override {
            return {width_px, QTabBar::tabSizeHint(index).height()};
        }
        QSize minimumTabSizeHint(int index) const override { return tabSizeHint(index); }
    };

    Platform platform;
    int argumentCount = 1;
    char name[5] = "test";
    char* arguments[2] = {name, nullptr};
    QApplication application{argumentCount, arguments};
    QWidget root;
};

TEST_F(InspectionTest, findsTheEnglishOfAMessageIntoWhichSomethingIsFilled) {
    const QHash<QString, QString> phrases = {
        {"the device has no parameter '", "das Gerät hat keinen Parameter „{}“"}};
    auto* label = make<QLabel>("das Gerät hat keinen Parameter „a“");
    EXPECT_FALSE(found(phrases).contains("is not translated"));
    label->setText("the device has no parameter 'a'");
    EXPECT_TRUE(found(phrases).contains("is not translated"));
}

TEST_F(InspectionTest, findsNothingInAGoodButton) {
    make<QPushButton>("Go");
    EXPECT_EQ(found(), "");
}

TEST_F(InspectionTest, findsWordsWiderThanTheirButtonAlsoWhereATooltipHasThem) {
    auto* button = make<QPushButton>("Write the changed values");
    button->resize(50, 30);
    EXPECT_TRUE(found().contains("px, has"));
    button->setToolTip("Write the changed values to the device");
    EXPECT_TRUE(found().contains("px, has"));
}

TEST_F(InspectionTest, aLabelThatLeavesWordsOutOnPurposeHasThemInItsTooltip) {
    auto* label = new widgets::ElidedLabel(4, &root);
    label->resize(60, 30);
    label->setWords("a device with a long name");
    QLabel neighbour(&root);
    neighbour.setGeometry(64, 0, 336, 30);
    EXPECT_EQ(found(), "");
    label->setToolTip({});
    EXPECT_TRUE(found().contains("no tooltip has it all"));
}

TEST_F(InspectionTest, findsWordsThatAreLeftOutBesideFreeRoomAndNoOthers) {
    auto* label = new widgets::ElidedLabel(5, &root);
    label->setWords("Connected, and the motor turns");
    label->setGeometry(0, 0, 80, 30);
    EXPECT_TRUE(found().contains("beside"));
    QLabel neighbour(&root);
    neighbour.setGeometry(84, 0, 316, 30);
    neighbour.show();
    EXPECT_FALSE(found().contains("beside")) << found().toStdString();
}

TEST_F(InspectionTest, findsACellThatIsCutBesideFreeRoomAndNoOthers) {
    QTableWidget table(1, 2, &root);
    table.setGeometry(0, 0, 300, 60);
    table.setItem(0, 0, new QTableWidgetItem("words that want more room"));
    table.setColumnWidth(0, 60);
    table.setColumnWidth(1, 20);
    EXPECT_TRUE(found().contains("words that want more room' lacks"));
    table.setColumnWidth(1, 240);
    EXPECT_FALSE(found().contains("lacks")) << found().toStdString();
}

TEST_F(InspectionTest, findsANumberThatTheEdgeCutsUnlessDotsStandForIt) {
    QTableWidget table(1, 2, &root);
    table.setGeometry(0, 0, 300, 60);
    table.setColumnWidth(0, 200);
    table.setColumnWidth(1, 110); // behind the edge at the right
    auto* cell = new QTableWidgetItem("1001");
    table.setItem(0, 1, cell);
    EXPECT_TRUE(found().contains("number '1001' is cut")) << found().toStdString();
    cell->setText("words");
    EXPECT_FALSE(found().contains("is cut"));
    cell->setText("1001");
    table.setItemDelegate(new widgets::WholeNumbers(&table));
    EXPECT_FALSE(found().contains("is cut")) << found().toStdString();
}

TEST_F(InspectionTest, findsTitlesThatAreCut) {
    QGroupBox box("What the board is told before each run", &root);
    box.resize(60, 40);
    EXPECT_TRUE(found().contains("'What the board"));
    box.resize(380, 40);
    EXPECT_EQ(found(), "");
}

TEST_F(InspectionTest, findsATabThatIsCut) {
    NarrowTabs bar(&root);
    bar.setAccessibleName("pages");
    bar.addTab("Fit and residuals");
    bar.setExpanding(false);
    bar.resize(300, 40);
    EXPECT_EQ(found(), "");
    bar.width_px = 20;
    bar.setTabText(0, "Residuals and fit"); // asks for the size anew
    EXPECT_TRUE(found().contains("tab 'Residuals and fit'"));
}

TEST_F(InspectionTest, findsAKeyThatTheTooltipDoesNotName) {
    auto* button = make<QPushButton>("&Go");
    EXPECT_EQ(found(), ""); // an access key is underlined
    button->setShortcut(QKeySequence("Ctrl+G"));
    EXPECT_TRUE(found().contains("does not name its key Ctrl+G"));
    button->setToolTip("what it does (Ctrl+G)");
    EXPECT_EQ(found(), "");
}

TEST_F(InspectionTest, findsALabelThatIsTooLowForItsLines) {
    auto* label = make<QLabel>(QString("many words ").repeated(40));
    label->setWordWrap(true);
    label->resize(200, 20);
    EXPECT_TRUE(found().contains("px of height"));
}

TEST_F(InspectionTest, findsAMissingTooltipAndName) {
    make<QLineEdit>("")->setToolTip({});
    EXPECT_TRUE(found().contains("no tooltip"));
    root.findChild<QLineEdit*>()->setAccessibleName({});
    EXPECT_TRUE(found().contains("no accessible name"));
}

TEST_F(InspectionTest, findsAnEnglishWordInAnotherLanguage) {
    make<QPushButton>("&Save");
    EXPECT_TRUE(found({{"Save", "Sichern"}}).contains("not translated"));
}

TEST_F(InspectionTest, findsAnEnglishWordInATabAHeaderACellAndAnEmptyField) {
    const QHash<QString, QString> phrases = {
        {"Gain", "Verst\u00e4rkung"}, {"Value", "Wert"}, {"Search", "Suchen"}, {"held", "gehalten"}};
    auto* field = make<QLineEdit>("");
    field->setPlaceholderText("Search");
    auto* tabs = new QTabBar(&root);
    tabs->addTab("Gain");
    tabs->resize(tabs->sizeHint());
    tabs->move(0, 50);
    QTableWidget table(1, 1, &root);
    table.setHorizontalHeaderLabels({"Value"});
    table.setItem(0, 0, new QTableWidgetItem("held"));
    table.setGeometry(0, 100, 300, 100);
    root.setMinimumSize(400, 220);
    const QString said = found(phrases);
    for (const char* word : {"Gain", "Value", "Search", "held"}) {
        EXPECT_TRUE(said.contains(QStringLiteral("'%1' is not translated").arg(QLatin1String(word))))
            << word << "\n"
            << said.toStdString();
    }
    field->setText("Search"); // the user's word
    table.item(0, 0)->setText("gehalten");
    const QString rest = found(phrases);
    EXPECT_FALSE(rest.contains("'Search'")) << rest.toStdString();
    EXPECT_FALSE(rest.contains("'held'")) << rest.toStdString();
}

TEST_F(InspectionTest, findsAPaleCell) {
    QTableWidget table(1, 1, &root);
    table.setItem(0, 0, new QTableWidgetItem("hardly to be read"));
    table.setGeometry(0, 0, 300, 100);
    table.setColumnWidth(0, 200);
    table.setShowGrid(false);
    root.setMinimumSize(400, 120);
    EXPECT_FALSE(found().contains("'hardly to be read' has a contrast")) << found().toStdString();
    table.item(0, 0)->setForeground(QColor(200, 200, 200));
    EXPECT_TRUE(found().contains("'hardly to be read' has a contrast")) << found().toStdString();
}

TEST_F(InspectionTest, findsAKeyThatTwoControlsShare) {
    auto* button = make<QPushButton>("&Go");
    auto* label = make<QLabel>("&Gap");
    EXPECT_FALSE(found().contains("share"));
    EXPECT_TRUE(inspectKeys(root).isEmpty()); // a label has no key without a control
    label->setBuddy(button);
    EXPECT_TRUE(inspectKeys(root).join('\n').contains("share Alt+G"));
    auto* action = new QAction("Copy", button);
    auto* other = new QAction("Cut", label);
    for (QAction* one : {action, other}) {
        one->setShortcut(QKeySequence("Ctrl+C"));
        one->setShortcutContext(Qt::WidgetShortcut);
    }
    EXPECT_FALSE(inspectKeys(root).join('\n').contains("Ctrl+C")); // each where it has the focus
    other->setShortcutContext(Qt::WindowShortcut);
    EXPECT_TRUE(inspectKeys(root).join('\n').contains("Ctrl+C"));
}

TEST_F(InspectionTest, findsGreyWordsOnGrey) {
    auto* label = make<QLabel>("pale");
    QPalette pale = root.palette();
    pale.setColor(QPalette::Window, Qt::white);
    pale.setColor(QPalette::WindowText, QColor(170, 170, 170)); // 2.3 on white
    root.setPalette(pale);
    label->setPalette(pale);
    EXPECT_TRUE(found().contains("contrast of 2."));
}

TEST_F(InspectionTest, findsAPaleWordBesideADarkOne) {
    auto* label =
        make<QLabel>("<span style='color: black'>dark</span> <span style='color: #aaaaaa'>pale</span>");
    QPalette white = root.palette();
    white.setColor(QPalette::Window, Qt::white);
    root.setPalette(white);
    EXPECT_TRUE(found().contains("contrast of 2.")) << found().toStdString();
    label->setText("<span style='color: black'>dark</span> <span style='color: #606060'>grey</span>"); // 6.3
    EXPECT_EQ(found(), "");
}

TEST_F(InspectionTest, findsAnAccessKeyThatAMenuHasTwice) {
    QMenu menu;
    menu.addAction("&Save");
    menu.addAction("Con&nect");
    EXPECT_TRUE(inspectMenu(menu, {}).isEmpty());
    menu.addAction("&Send");
    EXPECT_EQ(inspectMenu(menu, {}).size(), 1);
}

} // namespace
} // namespace halbench::gui
