#include "widgets/theme/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

/// Relative luminance and contrast ratio of WCAG 2.1.
double luminance(const QColor& colour) {
    const auto linear = [](double c) {
        return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

double contrast(const QColor& one, const QColor& other) {
    const double a = luminance(one);
    const double b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

class EveryTheme : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryTheme, hasReadableWordsOnItsSurfaces) {
    const auto theme = loadTheme(GetParam());
    ASSERT_TRUE(theme.has_value());
    EXPECT_EQ(theme->name, GetParam());
    for (const QColor& surface : {theme->window, theme->panel, theme->plotBackground}) {
        for (const QColor& word : {theme->text, theme->muted, theme->good, theme->warn, theme->bad}) {
            EXPECT_GE(contrast(word, surface), 4.5)
                << word.name().toStdString() << " on " << surface.name().toStdString();
        }
    }
}

TEST_P(EveryTheme, hasEightDifferentCurveColoursThatStandOut) {
    const auto theme = loadTheme(GetParam());
    ASSERT_TRUE(theme.has_value());
    for (std::size_t i = 0; i < theme->curves.size(); ++i) {
        EXPECT_GE(contrast(theme->curves[i], theme->plotBackground), 2.5);
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_NE(theme->curves[i], theme->curves[k]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Themes, EveryTheme, ::testing::Values("light", "dark"));

TEST(Theme, refusesUnknownNamesAndIncompleteText) {
    EXPECT_EQ(loadTheme("purple").error().code, ErrorCode::UnknownName);
    EXPECT_EQ(parseTheme("not json").error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(parseTheme("{\"window\": \"#FFFFFF\"}").error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(parseTheme("{\"window\": \"reddish\"}").error().code, ErrorCode::InvalidInput);
}

} // namespace
} // namespace halbench::widgets
