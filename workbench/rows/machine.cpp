#include "rows/machine.h"

#include "coppice/base/parallel.h"
#include "coppice/version.h"

#include <nlohmann/json.hpp>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <fstream>

namespace coppice::lab {

namespace {

/// The value of the first line `key<spaces or tabs><separator>value` of a system file, or
/// "unknown".
std::string find_entry(const char* file, std::string_view key, char separator) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, key.size(), key) != 0) continue;
        const auto at = line.find_first_not_of(" \t", key.size());
        if (at == std::string::npos || line[at] != separator) continue;
        const auto first = line.find_first_not_of(" \t\"", at + 1);
        const auto last = line.find_last_not_of(" \t\"");
        if (first == std::string::npos || first > last) continue;
        return line.substr(first, last - first + 1);
    }
    return "unknown";
}

std::uint64_t installed_memory_bytes() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long page_bytes = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page_bytes <= 0) return 0;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_bytes);
}

}  // namespace

Machine find_machine() {
    Machine machine;
    machine.cpu = find_entry("/proc/cpuinfo", "model name", ':');
    machine.cores = hardware_thread_count();
    machine.memory_bytes = installed_memory_bytes();
    machine.os = find_entry("/etc/os-release", "PRETTY_NAME", '=');
    utsname system{};
    machine.kernel = uname(&system) == 0
                         ? std::string(system.sysname) + " " + system.release + " " + system.machine
                         : "unknown";
    return machine;
}

void to_json(nlohmann::json& json, const Machine& machine) {
    json = {{"cpu", machine.cpu},
            {"cores", machine.cores},
            {"memory_bytes", machine.memory_bytes},
            {"os", machine.os},
            {"kernel", machine.kernel}};
}

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    std::array<char, 32> text{};
    const std::size_t size = gmtime_r(&now, &parts) == nullptr
                                 ? 0
                                 : std::strftime(text.data(), text.size(), "%FT%TZ", &parts);
    return {text.data(), size};
}

nlohmann::ordered_json provenance_json() {
    nlohmann::ordered_json json = nlohmann::json(find_machine());
    json["compiler"] = compiler_name();
    json["build_type"] = build_type();
    json["flags"] = compiler_flags();
    json["git_revision"] = git_revision();
    json["created"] = utc_now();
    return json;
}

std::string_view coppice_version() noexcept {
    return version().text;
}

std::string_view compiler_name() noexcept {
#define COPPICE_TEXT_OF(number) #number
#define COPPICE_TEXT(number) COPPICE_TEXT_OF(number)
#if defined(__clang__)
    return "Clang " COPPICE_TEXT(__clang_major__) "." COPPICE_TEXT(
        __clang_minor__) "." COPPICE_TEXT(__clang_patchlevel__);
#elif defined(__GNUC__)
    return "GCC " COPPICE_TEXT(__GNUC__) "." COPPICE_TEXT(__GNUC_MINOR__) "." COPPICE_TEXT(
        __GNUC_PATCHLEVEL__);
#else
    return "unknown";
#endif
#undef COPPICE_TEXT
#undef COPPICE_TEXT_OF
}

}  // namespace coppice::lab
