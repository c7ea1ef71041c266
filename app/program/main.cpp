#include "app/cli/program.h"
#include "app/headless/interrupt.h"
#include "app/window/window_program.h"

int main(int count, char** words) {
    const std::vector<std::string> arguments(words + 1, words + count);
    if (halbench::app::isWindowCall(arguments)) {
        return halbench::app::runWindow(arguments);
    }
    return halbench::app::runProgram(arguments, halbench::app::catchSignals());
}
