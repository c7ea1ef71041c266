// Project files and the documents in them: any text; what is accepted comes back as it was written.
#include "app/documents/calibration_file.h"
#include "app/documents/identification_file.h"
#include "app/documents/model_file.h"
#include "app/window/project/project_file.h"

using namespace halbench::app;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const halbench::Result<Project> project = parseProject(text, "fuzz.toml");
    if (!project) {
        if (project.error().message.empty() || project.error().hint.empty()) {
            __builtin_trap(); // every refusal says what to do
        }
        return 0;
    }
    const halbench::Result<Project> again = parseProject(projectText(*project), "again.toml");
    Project read = *project;
    read.resets.clear(); // what is written has none
    if (!again || *again != read) {
        __builtin_trap();
    }
    for (const NamedDocument& model : project->models) {
        (void)parseIdentification(model.document, model.name);
    }
    for (const NamedDocument& design : project->designs) {
        (void)parseGains(design.document, design.name);
    }
    for (const NamedDocument& calibration : project->calibrations) {
        (void)parseCalibrationRecord(calibration.document, calibration.name);
    }
    return 0;
}
