#include "json_file.h"

#include "interrupts.h"
#include "lab/output_folder.h"
#include "usage.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <string_view>

namespace coppice::app {

namespace {

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace

void check_json_file(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.empty()) throw UsageError("--json: no file is named; example: --json out.json");
    const DeferInterrupts no_trace;
    lab::check_writable(folder_of(file), std::array{std::string_view(name)});
}

void write_json_file(const std::filesystem::path& file, const nlohmann::ordered_json& document) {
    const DeferInterrupts whole_file;
    const lab::OutputFile contents{file.filename().string(), document.dump(2) + '\n'};
    lab::write_all(folder_of(file), std::array{contents});
}

}  // namespace coppice::app
