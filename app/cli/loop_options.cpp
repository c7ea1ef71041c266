#include "app/cli/loop_options.h"

#include <algorithm>

namespace halbench::app {

void addModelAxis(CommandSyntax& syntax, std::string& axis) {
    syntax.option("--axis", axis, "Of a model with several axes; default all", "NAME|all");
}

void addLoopOutputs(CommandSyntax& syntax, LoopOutputs& options) {
    syntax.repeatable(
        "--picture", options.pictures,
        "bode, nyquist, nichols, sensitivity, root-locus, step, large-step or disturbance; repeatable",
        "VIEW=F.svg|.pdf|.png");
    syntax.option("--disturbance", options.load, "Load that is looked at, as a current; default 0.5", "A");
    syntax.option("--code", options.codeFile, "The law for another controller", "LAW.c");
}

void addPictureFiles(CommandOutputs& outputs, const LoopOutputs& options) {
    for (const std::string& picture : options.pictures) { // VIEW=FILE
        outputs.files.push_back(picture.substr(std::min(picture.find('='), picture.size() - 1) + 1));
    }
}

} // namespace halbench::app
