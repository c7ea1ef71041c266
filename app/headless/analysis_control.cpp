#include "app/headless/analysis_control.h"

namespace halbench::app {

AnalysisControl analysisControl(CommandContext& context, const Analysis& analysis) {
    AnalysisControl control;
    control.isStopped = [&context] { return context.interruptSignal.load() != 0; };
    control.onProgress = [&context, name = std::string(analysis.name)](double share) {
        context.console.progress(share, name);
    };
    return control;
}

} // namespace halbench::app
