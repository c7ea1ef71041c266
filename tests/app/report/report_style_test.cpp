#include "app/report/report_style.h"
#include "widgets/theme/theme.h"

#include <QRegularExpression>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(ReportStyle, takesEveryColourFromTheTheme) {
    const widgets::Theme theme = widgets::loadTheme("light").value();
    const std::string style = reportStyle(theme);
    EXPECT_NE(style.find("--bad:" + theme.bad.name().toStdString() + ";"), std::string::npos);
    // Behind the line that defines the roles no rule names a colour of its own.
    const std::string rules = style.substr(style.find('\n'));
    const QRegularExpression colour(QStringLiteral("#[0-9a-fA-F]{3,8}|rgb\\("));
    EXPECT_FALSE(colour.match(QString::fromStdString(rules)).hasMatch());
}

} // namespace
} // namespace halbench::app
