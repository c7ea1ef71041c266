#pragma once

#include "app/cli/command_syntax.h"
#include "app/headless/command_context.h"
#include "app/headless/command_outputs.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace halbench::app {

/// A command of the command line. Its options are a struct of its own, which lives in the functions: the
/// command line fills it, then the others read it.
struct Command {
    std::string name;
    std::string help;
    std::function<void(CommandSyntax& syntax)> addOptions;
    std::function<CommandResult(CommandContext& context)> run;
    std::function<CommandOutputs()> outputs;
};

/// The functions of a command, which take its options.
template <typename Options>
struct CommandFunctions {
    void (*addOptions)(CommandSyntax& syntax, Options& options);
    CommandResult (*run)(CommandContext& context, const Options& options);
    CommandOutputs (*outputs)(const Options& options) = nullptr; ///< none: it writes no file
};

/// `options`: what they are before the command line is read.
template <typename Options>
Command makeCommand(std::string name, std::string help, CommandFunctions<Options> functions,
                    Options options = {}) {
    const auto own = std::make_shared<Options>(std::move(options));
    return {std::move(name), std::move(help),
            [own, functions](CommandSyntax& syntax) { functions.addOptions(syntax, *own); },
            [own, functions](CommandContext& context) { return functions.run(context, *own); },
            [own, functions] { return functions.outputs ? functions.outputs(*own) : CommandOutputs(); }};
}

} // namespace halbench::app
