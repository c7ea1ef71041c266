#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace halbench::app {

/// Whether a command can do without an option.
enum class Presence { Optional, Required };

/// Adds the options of one command to the command line, each tied to the field that takes what the user
/// writes: "--name" is an option, "NAME" an argument by its place. Numbers stay text until the command judges
/// them, so that its message can name the option. `type` is the placeholder of the value in the help.
class CommandSyntax {
public:
    explicit CommandSyntax(CLI::App& command);

    /// An argument by its place, which must be given.
    void argument(const std::string& name, std::string& value, const std::string& help,
                  const std::string& type = {});
    /// One or more of them.
    void arguments(const std::string& name, std::vector<std::string>& values, const std::string& help);
    /// DEVICE
    void device(std::string& uri);
    void option(const std::string& name, std::string& value, const std::string& help,
                const std::string& type = {}, Presence presence = Presence::Optional);
    void flag(const std::string& name, bool& isGiven, const std::string& help);
    /// An option that may be given several times, with one value each.
    void repeatable(const std::string& name, std::vector<std::string>& values, const std::string& help,
                    const std::string& type);
    /// An option that names a recording to be written: .csv, and nothing stands there that is no file.
    void recording(const std::string& name, std::string& path, const std::string& help,
                   Presence presence = Presence::Optional);

private:
    CLI::App& m_command;
};

} // namespace halbench::app
