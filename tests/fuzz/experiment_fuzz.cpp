// Experiment files: any text; what is accepted must survive being turned into configurations.
#include "app/experiments/step_configs.h"

using namespace halbench::app;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const halbench::Result<Experiment> experiment = parseExperiment(text, "fuzz.toml", {});
    if (!experiment) {
        if (experiment.error().message.empty() || experiment.error().hint.empty()) {
            __builtin_trap(); // every refusal says what to do
        }
        return 0;
    }
    for (const ExperimentStep& step : experiment->steps) {
        if (step.kind == "identify") {
            (void)identifyConfigOf(step, actuatorOf({}));
        } else if (step.kind == "calibrate") {
            (void)calibrateConfigOf(step);
        } else if (step.kind == "move") {
            (void)moveConfigOf(step);
        } else if (step.kind == "record") {
            (void)recordConfigOf(step);
        } else if (step.kind == "set") {
            (void)valuesOf(step);
        } else if (step.kind == "tune") {
            (void)designTargetsOf(step);
        }
    }
    return 0;
}
