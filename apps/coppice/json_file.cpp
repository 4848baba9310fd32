#include "json_file.h"

#include "coppice/io/write_file.h"

#include "interrupts.h"
#include "rows/output_folder.h"
#include "text/json_text.h"
#include "usage.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>

namespace coppice::app {

void check_json_file(const std::filesystem::path& file) {
    if (file.filename().empty()) {
        throw UsageError("--json: no file is named; example: --json out.json");
    }
    const DeferInterrupts no_trace;
    lab::check_file_writable(file);
}

void write_json_file(const std::filesystem::path& file, const nlohmann::ordered_json& document,
                     Output& output) {
    {
        const DeferInterrupts whole_file;
        write_file(file, lab::json_text(document));
    }
    output.print(fmt::format("written: {}\n", file.string()));
}

}  // namespace coppice::app
