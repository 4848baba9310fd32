#include "options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <memory>

namespace coppice::app {

namespace {

/// CLI11's help with the default behind the meaning, and the scenes in front of the options.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_option_opts(const CLI::Option* option) const override {
        return option->get_type_name().empty() ? "" : " " + option->get_type_name();
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        const std::string default_text = option->get_default_str();
        if (default_text.empty()) return option->get_description();
        // A long list gets a line of its own.
        const bool is_long = option->get_description().size() + default_text.size() > 54;
        return fmt::format("{}{}[default: {}]", option->get_description(), is_long ? "\n" : " ",
                           default_text);
    }

    std::string make_usage(const CLI::App* app, std::string name) const override {
        std::string usage = "\nUsage: " + name;
        const auto is_positional = [](const CLI::Option* option) {
            return option->get_positional();
        };
        for (const CLI::Option* option : app->get_options(is_positional)) {
            usage += " " + option->get_name(true) + option->get_type_name();
        }
        const bool has_commands = !app->get_subcommands({}).empty();
        return usage + (has_commands ? " COMMAND ...\n" : " [OPTIONS]\n");
    }

    std::string make_positionals(const CLI::App* /*app*/) const override { return {}; }
};

}  // namespace

std::string listing(std::string_view what, std::span<const std::string_view> names) {
    constexpr std::size_t width = 68;
    std::string text = fmt::format("{}:", what);
    std::size_t line_length = text.size();
    for (const std::string_view& name : names) {
        const bool is_last = &name == &names.back();
        const std::string item = fmt::format("{}{}", name, is_last ? "" : ",");
        const bool fits = line_length + 1 + item.size() <= width;
        text += (fits ? " " : "\n") + item;
        line_length = fits ? line_length + 1 + item.size() : item.size();
    }
    return text;
}

CLI::Option* add_text(CLI::App& command, const OptionText& text, std::string& value) {
    const auto read = [text, &value](const std::string& given) {
        if (given.empty()) throw UsageError(fmt::format("{}: the value is empty", text.name));
        value = given;
    };
    return command.add_option_function<std::string>(text.name, read, text.meaning)
        ->type_name(text.placeholder)
        ->default_str(text.default_text);
}

CLI::Option* add_number(CLI::App& command, const OptionText& text, double& value,
                        const NumberRange& range) {
    const auto read = [text, &value, range](const std::string& given) {
        value = parse_number(text.name, given, range, text.default_text);
    };
    return command.add_option_function<std::string>(text.name, read, text.meaning)
        ->type_name(text.placeholder)
        ->default_str(text.default_text);
}

CLI::Option* add_percentage(CLI::App& command, const OptionText& text, double& percent) {
    const auto read = [text, &percent](const std::string& given) {
        const std::string digits = given.ends_with('%') ? given.substr(0, given.size() - 1) : given;
        percent = parse_number(
            text.name, digits,
            {0.0, std::numeric_limits<double>::max(), "a finite number of percent >= 0"},
            text.default_text);
    };
    return command.add_option_function<std::string>(text.name, read, text.meaning)
        ->type_name(text.placeholder)
        ->default_str(text.default_text);
}

CLI::Option* add_list_option(CLI::App& command, const OptionText& text,
                             const std::function<void(const std::vector<std::string>&)>& read) {
    return command.add_option_function<std::vector<std::string>>(text.name, read, text.meaning)
        ->type_name(text.placeholder)
        ->default_str(text.default_text)
        ->allow_extra_args(false)
        ->take_all();
}

CLI::Option* add_name(CLI::App& command, const OptionText& text, std::string& value,
                      const std::vector<std::string_view>& names) {
    return add_text(command, text, value)
        ->each([option = text.name, names](const std::string& given) {
            require_name(option, given, names);
        });
}

CLI::Option* add_names(CLI::App& command, const OptionText& text, std::vector<std::string>& value,
                       const std::vector<std::string_view>& names) {
    const auto read = [option = text.name, &value, names](const std::vector<std::string>& texts) {
        value = parse_list(option, texts, fmt::format("{}", fmt::join(names, ",")));
        for (const std::string& name : value) {
            require_name(option, name, names);
        }
    };
    return add_list_option(command, text, read);
}

CLI::Option* add_vector(CLI::App& command, const OptionText& text, std::optional<Vec3f>& value) {
    const auto read = [option = text.name, &value](const std::string& given) {
        value = parse_vector(option, given);
    };
    return command.add_option_function<std::string>(text.name, read, text.meaning)
        ->type_name(text.placeholder)
        ->default_str(text.default_text);
}

CLI::Option* add_switch(CLI::App& command, const std::string& name, const std::string& meaning,
                        const std::function<void()>& turn_on) {
    return command.add_flag_callback(name, turn_on, meaning)->disable_flag_override();
}

void refuse_vain(const CLI::App& command, const std::string& option, bool is_vain,
                 std::string_view why) {
    if (!is_vain || command.count(option) == 0) return;
    throw UsageError(fmt::format("{}: it has no effect: {}", option, why));
}

CLI::Option* add_scenes(CLI::App& command, std::vector<std::string>& scenes) {
    return command.add_option("SCENE", scenes)->type_name("...");
}

void set_help_format(CLI::App& program) {
    const auto format = std::make_shared<HelpFormatter>();
    format->column_width(28);
    program.formatter(format);
}

}  // namespace coppice::app
