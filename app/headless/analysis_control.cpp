#include "app/headless/analysis_control.h"

#include <chrono>

namespace halbench::app {

AnalysisControl analysisControl(CommandContext& context, const Analysis& analysis) {
    AnalysisControl control;
    control.isStopped = [&context] { return context.interruptSignal.load() != 0; };
    control.onProgress = [&context, name = std::string(analysis.name)](double share) {
        context.console.progress(share, name);
    };
    control.now_s = [] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    };
    return control;
}

} // namespace halbench::app
