#include "tests/widgets/gui_fixture.h"
#include "widgets/language/unbroken.h"

#include <QTextLayout>

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

/// Lines that these words take where hardly one character has room.
int lines(const QString& text) {
    QTextLayout layout(text);
    QTextOption option;
    option.setWrapMode(QTextOption::WordWrap); // at word ends only
    layout.setTextOption(option);
    layout.beginLayout();
    int count = 0;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(1.0);
        ++count;
    }
    layout.endLayout();
    return count;
}

using UnbrokenTest = GuiTest; // fonts belong to an application

TEST_F(UnbrokenTest, staysInOneLineWhereItsPlainWordsDoNot) {
    for (const char* text : {"382 r/min", "382 1/min", "3 rad", "c/J = 2.24 \u00b1 0.09"}) {
        const QString plain = QString::fromUtf8(text);
        EXPECT_GT(lines(plain), 1) << text;
        EXPECT_EQ(lines(unbroken(plain)), 1) << text;
    }
}

TEST_F(UnbrokenTest, aSentenceIsWrappedBetweenItsWordsButNotBeforeAUnit) {
    const QString kept = withUnitsKept(QStringLiteral("coils up to 68.9 \u00b0C, 4 A at 3 s, 5 samples"));
    EXPECT_TRUE(kept.contains(QStringLiteral("68.9\u00a0\u00b0C, 4\u00a0A at 3\u00a0s, 5 samples")));
    EXPECT_EQ(lines(kept), 9); // coils - up - to - 68.9 C, - 4 A - at - 3 s, - 5 - samples
}

TEST_F(UnbrokenTest, readsAsItDid) {
    QString read = unbroken(QStringLiteral("382 1/min"));
    read.remove(QChar(0x2060));
    EXPECT_EQ(read.replace(QChar(0x00a0), QLatin1Char(' ')), "382 1/min");
}

} // namespace
} // namespace halbench::widgets
