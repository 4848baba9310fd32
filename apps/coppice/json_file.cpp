#include "json_file.h"

#include "coppice/io/write_file.h"

#include "interrupts.h"
#include "rows/output_folder.h"
#include "usage.h"

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

void write_json_file(const std::filesystem::path& file, const nlohmann::ordered_json& document) {
    const DeferInterrupts whole_file;
    // File names need not be UTF-8; JSON must be.
    write_file(
        file,
        document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
}

}  // namespace coppice::app
