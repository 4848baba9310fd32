// The option parser: the input's lines are the arguments. Nothing is run: whatever the arguments,
// there is a command, a text that was printed, or one line on what is wrong.

#include "expect.h"
#include "program.h"
#include "scratch_file.h"
#include "usage.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace coppice;
    std::vector<std::string> arguments{"coppice"};
    std::string_view rest = fuzz::text_of({data, size});
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        // As the system hands arguments over, they end at the first zero.
        arguments.emplace_back(std::string(rest.substr(0, end)).c_str());
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    std::vector<const char*> texts;
    for (const std::string& argument : arguments) {
        texts.push_back(argument.c_str());
    }
    try {
        const int code = app::run_program(static_cast<int>(texts.size()), texts.data(),
                                          [](const app::Command&) {});
        fuzz::expect(code == app::done || code == app::wrong_use, "an exit code");
    } catch (const app::UsageError& error) {
        fuzz::expect(*error.what() != '\0', "a reason");
    }
    return 0;
}
