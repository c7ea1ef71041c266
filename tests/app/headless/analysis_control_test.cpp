#include "app/analyses/registry/analyses.h"
#include "app/headless/analysis_control.h"

#include <gtest/gtest.h>

#include <csignal>

namespace halbench::app {

TEST(AnalysisControlTest, anInterruptStopsTheAnalysis) {
    Console console(ConsoleStyle{.isQuiet = true, .level = LogLevel::Error});
    std::atomic<int> signal = 0;
    CommandContext context{{}, console, signal};
    const AnalysisControl control = analysisControl(context, analyses().front());
    EXPECT_FALSE(control.isStopped());
    signal = SIGINT;
    EXPECT_TRUE(control.isStopped());
    control.onProgress(0.5); // draws nothing where there is no terminal
}

} // namespace halbench::app
