#include "app/batch/interrupt.h"
#include "app/batch/program.h"

int main(int count, char** arguments) {
    const std::atomic<int>& interruptSignal = halbench::app::catchSignals();
    return halbench::app::runProgram(std::vector<std::string>(arguments + 1, arguments + count),
                                     interruptSignal);
}
