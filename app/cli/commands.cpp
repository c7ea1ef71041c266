#include "app/cli/commands.h"

#include "app/analyses/registry/analyses.h"

namespace halbench::app {

std::vector<Command> allCommands() {
    std::vector<Command> commands = {
        devicesCommand(), describeCommand(), getCommand(),        setCommand(),      configCommand(),
        recordCommand(),  moveCommand(),     calibrateCommand(),  identifyCommand(), tuneCommand(),
        analyseCommand(), runCommand(),      serveCommand(),      convertCommand(),  spectrumCommand(),
        plotCommand(),    importCommand(),   recordingsCommand(), overlayCommand()};
    for (const Analysis& analysis : analyses()) {
        commands.push_back(analysisCommand(analysis));
    }
    return commands;
}

} // namespace halbench::app
