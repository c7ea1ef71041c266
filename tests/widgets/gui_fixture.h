#pragma once

#include "widgets/figure/offscreen_application.h"
#include "widgets/theme/theme_style.h"

#include <QApplication>

#include <gtest/gtest.h>

namespace halbench::widgets {

/// An offscreen application dressed in the light theme.
class GuiTest : public ::testing::Test {
protected:
    void SetUp() override { dress("light"); }

    static void dress(const char* name) { applyTheme(*qApp, loadTheme(name).value()); }

private:
    OffscreenApplication m_application = OffscreenApplication::ensure().value();
};

} // namespace halbench::widgets
