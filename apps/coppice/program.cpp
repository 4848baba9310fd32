#include "program.h"

#include "coppice/base/parallel.h"
#include "coppice/io/load_mesh.h"

#include "options.h"
#include "piped_scenes.h"
#include "rows/machine.h"
#include "usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace coppice::app {

namespace {

std::string version_text() {
    return fmt::format("coppice {} (revision {}, {}, {}, tasks by {}, {} Assimp)",
                       lab::coppice_version(), lab::git_revision(), lab::compiler_name(),
                       lab::build_type(), tasking_backend(),
                       can_load_scene_files() ? "with" : "without");
}

/// The names of the commands, or of the options of one command, for suggestions.
std::vector<std::string> command_names(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options({})) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

/// Throws UsageError for the first argument that no option or command took.
void refuse_unknown(const CLI::App& app, std::string_view help_command) {
    std::vector<std::string> unknown = app.remaining();
    std::erase(unknown, "--");  // the parser keeps the mark behind which nothing is an option
    if (unknown.empty()) return;
    const std::string& argument = unknown.front();
    const bool is_option = argument.starts_with('-');
    const bool is_command = !is_option && app.get_parent() == nullptr;
    const auto candidates = is_option ? option_names(app) : command_names(app);
    const std::vector<std::string_view> names(candidates.begin(), candidates.end());
    throw UsageError(fmt::format("{} '{}'{}; see {} --help",
                                 is_option    ? "unknown option"
                                 : is_command ? "unknown command"
                                              : "unexpected argument",
                                 argument.substr(0, argument.find('=')),
                                 suggestion(argument.substr(0, argument.find('=')), names),
                                 help_command));
}

/// CLI11's own complaints, in our words.
UsageError usage_error(const CLI::App& program, const CLI::ParseError& error) {
    const std::string text = error.what();
    const std::string option = text.substr(0, text.find(':'));
    std::string help_command = "coppice";
    for (const CLI::App* command : program.get_subcommands()) {
        help_command += " " + command->get_name();
    }
    const bool is_mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr;
    std::string what = text;
    if (is_mismatch && text.ends_with("missing")) what = option + ": the value is missing";
    if (is_mismatch && text.find("At Most") != std::string::npos) what = option + ": given twice";
    if (text.find("flag override") != std::string::npos) {
        what = fmt::format("--{}: takes no value", text.substr(0, text.find(' ')));
    }
    return UsageError(fmt::format("{}; see {} --help", what, help_command));
}

int run_parsed(const CLI::App& program, const std::vector<Command>& commands,
               const std::function<void(const Command&)>& run) {
    refuse_unknown(program, "coppice");
    const auto is_parsed = [](const Command& command) { return command.parser->parsed(); };
    const auto command = std::find_if(commands.begin(), commands.end(), is_parsed);
    if (command == commands.end()) {
        std::fputs(program.help().c_str(), stderr);
        return wrong_use;
    }
    refuse_unknown(*command->parser, "coppice " + command->parser->get_name());
    run(*command);
    return done;
}

int print_and_check(std::string_view text) {
    Output output;
    output.print(text);
    output.check();
    return done;
}

}  // namespace

int run_program(int argument_count, const char* const* argument_texts,
                const std::function<void(const Command&)>& run) {
    const std::vector<std::string> arguments(argument_texts, argument_texts + argument_count);
    CLI::App program("Ray-tracing acceleration structures built from a sample.", "coppice");
    set_help_format(program);
    program.set_version_flag("--version", version_text(), "Print version, revision and compiler");
    program.require_subcommand(0, 1);
    program.allow_extras();
    const std::vector<Command> commands{add_experiment(program, arguments),
                                        add_build(program),
                                        add_check(program),
                                        add_bench(program),
                                        add_tune(program),
                                        add_compare(program),
                                        add_trace(program),
                                        add_render(program),
                                        add_info(program),
                                        add_list(program),
                                        add_generate(program)};
    program.footer(
        "Examples:\n"
        "  coppice generate terrain --triangles 100000 -o terrain.obj\n"
        "  coppice info terrain.obj\n"
        "  coppice experiment terrain.obj --out out/terrain\n"
        "  coppice build terrain.obj\n"
        "  coppice build terrain.obj -o terrain.cpk\n"
        "  coppice check terrain.cpk terrain.obj\n"
        "  coppice bench terrain.obj\n"
        "  coppice tune terrain.obj --rays 1e8\n"
        "  coppice trace terrain.obj --count\n"
        "  coppice render terrain.obj -o terrain.png\n"
        "  coppice experiment --help");
    try {
        program.parse(argument_count, argument_texts);
    } catch (const CLI::CallForHelp&) {
        return print_and_check(program.help());
    } catch (const CLI::CallForVersion& version) {
        return print_and_check(std::string(version.what()) + '\n');
    } catch (const CLI::ParseError& error) {
        throw usage_error(program, error);
    }
    return run_parsed(program, commands, run);
}

void require_scenes(const CLI::App& command, std::vector<std::string>& scenes) {
    if (!scenes.empty()) return take_piped_scenes(scenes);
    // An unknown option is the likelier mistake: it may have swallowed the scene.
    refuse_unknown(command, "coppice " + command.get_name());
    throw UsageError(fmt::format("{}: no scene is given; example: coppice {} scenes/dragon.obj",
                                 command.get_name(), command.get_name()));
}

}  // namespace coppice::app
