#include "app/report/report_style.h"
#include "widgets/theme.h"

#include <gtest/gtest.h>

#include <regex>

namespace halbench::app {
namespace {

TEST(ReportStyle, takesEveryColourFromTheTheme) {
    const widgets::Theme theme = widgets::loadTheme("light").value();
    const std::string style = reportStyle(theme);
    EXPECT_NE(style.find("--bad:" + theme.bad.name().toStdString() + ";"), std::string::npos);
    // Behind the line that defines the roles no rule names a colour of its own.
    const std::string rules = style.substr(style.find('\n'));
    EXPECT_FALSE(std::regex_search(rules, std::regex("#[0-9a-fA-F]{3,8}|rgb\\(")));
}

} // namespace
} // namespace halbench::app
