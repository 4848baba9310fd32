#pragma once

#include "coppice/geom/vec3.h"

#include "usage.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::app {

/// What --help shows of an option: its name, what stands for its value, what it means (lines of at
/// most 68 characters) and its default; the default is also the example in an error.
struct OptionText {
    std::string name;         ///< "--max-leaf", or "-o,--out"
    std::string placeholder;  ///< "N"
    std::string meaning;
    std::string default_text;
};

/// The names in a registry, in its order.
template <typename Entry>
[[nodiscard]] std::vector<std::string_view> names_in(std::span<const Entry> registry) {
    std::vector<std::string_view> names;
    for (const Entry& entry : registry) {
        names.push_back(entry.name);
    }
    return names;
}

/// A meaning for OptionText that ends in a list of names: "what: a, b, c", in lines of at most 68
/// characters.
[[nodiscard]] std::string listing(std::string_view what, std::span<const std::string_view> names);

/// An option with one text value, not empty.
CLI::Option* add_text(CLI::App& command, const OptionText& text, std::string& value);

/// An option with a whole number in [lowest, highest].
template <typename Integer>
CLI::Option* add_whole(CLI::App& command, const OptionText& text, Integer& value,
                       std::int64_t lowest, std::int64_t highest) {
    const auto read = [text, &value, lowest, highest](const std::string& given) {
        value =
            static_cast<Integer>(parse_whole(text.name, given, lowest, highest, text.default_text));
    };
    return command.add_option_function<std::string>(text.name, read, text.meaning)
        ->type_name(text.placeholder)
        ->default_str(text.default_text);
}

/// An option with a number in a range.
CLI::Option* add_number(CLI::App& command, const OptionText& text, double& value,
                        const NumberRange& range);

/// An option with a finite number of percent, >= 0; a trailing "%" is allowed.
CLI::Option* add_percentage(CLI::App& command, const OptionText& text, double& percent);

/// An option with a comma list; may be given several times. `read` gets all the texts given.
CLI::Option* add_list_option(CLI::App& command, const OptionText& text,
                             const std::function<void(const std::vector<std::string>&)>& read);

/// An option that takes one of some names.
CLI::Option* add_name(CLI::App& command, const OptionText& text, std::string& value,
                      const std::vector<std::string_view>& names);

/// An option that takes a comma list of some names, each once.
CLI::Option* add_names(CLI::App& command, const OptionText& text, std::vector<std::string>& value,
                       const std::vector<std::string_view>& names);

/// An option that takes a point or direction: three finite numbers with commas between.
CLI::Option* add_vector(CLI::App& command, const OptionText& text, std::optional<Vec3f>& value);

/// An option without a value.
CLI::Option* add_switch(CLI::App& command, const std::string& name, const std::string& meaning,
                        const std::function<void()>& turn_on);

/// Throws UsageError if an option was given that has no effect (`is_vain`); `why` says so, and what
/// to do.
void refuse_vain(const CLI::App& command, const std::string& option, bool is_vain,
                 std::string_view why);

/// The positional SCENE... of a command.
CLI::Option* add_scenes(CLI::App& command, std::vector<std::string>& scenes);

/// Makes --help show options as OptionText says, and the usage line as people write it.
void set_help_format(CLI::App& program);

}  // namespace coppice::app
