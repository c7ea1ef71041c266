#include "app/cli/command_syntax.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <string_view>

namespace halbench::app {

namespace {

/// In words; empty when a recording can have this name. Whoever has recorded for an hour does not want to
/// hear it then.
std::string problemOfRecordingName(const std::string& path) {
    if (!std::string_view(path).ends_with(".csv")) {
        return fmt::format("'{}' is no .csv file: a recording is written as CSV, of which halbench convert "
                           "makes .mf4 or .mat",
                           path);
    }
    std::error_code ignored; // what cannot be looked at is said when it is written
    if (std::filesystem::is_other(path, ignored) || std::filesystem::is_directory(path, ignored)) {
        return fmt::format("'{}' is a folder, device or pipe: name a file", path);
    }
    return {};
}

void setType(CLI::Option* option, const std::string& type) {
    if (!type.empty()) {
        option->type_name(type);
    }
}

} // namespace

CommandSyntax::CommandSyntax(CLI::App& command) : m_command(command) {}

void CommandSyntax::argument(const std::string& name, std::string& value, const std::string& help,
                             const std::string& type) {
    option(name, value, help, type, Presence::Required);
}

void CommandSyntax::arguments(const std::string& name, std::vector<std::string>& values,
                              const std::string& help) {
    m_command.add_option(name, values, help)->required();
}

void CommandSyntax::device(std::string& uri) {
    argument("DEVICE", uri, "sim:htm, tcp:HOST:PORT, replay:FILE ...");
}

void CommandSyntax::option(const std::string& name, std::string& value, const std::string& help,
                           const std::string& type, Presence presence) {
    CLI::Option* option = m_command.add_option(name, value, help);
    option->required(presence == Presence::Required);
    setType(option, type);
}

void CommandSyntax::flag(const std::string& name, bool& isGiven, const std::string& help) {
    m_command.add_flag(name, isGiven, help);
}

void CommandSyntax::repeatable(const std::string& name, std::vector<std::string>& values,
                               const std::string& help, const std::string& type) {
    CLI::Option* option = m_command.add_option(name, values, help);
    option->take_all()->allow_extra_args(false);
    setType(option, type);
}

void CommandSyntax::recording(const std::string& name, std::string& path, const std::string& help,
                              Presence presence) {
    CLI::Option* option = m_command.add_option(name, path, help);
    option->required(presence == Presence::Required);
    option->type_name("FILE.csv");
    option->check([](const std::string& given) {
        return given.empty() ? std::string() : problemOfRecordingName(given);
    });
}

} // namespace halbench::app
