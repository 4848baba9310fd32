#pragma once

#include "experiment/experiment_options.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::lab {

/// What tells a file's content from others.
struct FileContent {
    std::uint64_t byte_count = 0;
    std::string hash;  ///< XXH3, 128 bits, in hexadecimal digits

    friend bool operator==(const FileContent&, const FileContent&) = default;
};

/// Reads a file for its content. Throws Error(io).
[[nodiscard]] FileContent content_of(const std::filesystem::path& file);

/// Everything that an experiment depends on, to run it again.
struct ExperimentRecord {
    ExperimentOptions options;
    std::vector<std::string> command;   ///< the program's argument list
    std::vector<FileContent> contents;  ///< of the scenes' files, in their order
    std::string program_version;
    std::string git_revision;
};

/// The record of an experiment that this program is to run now. Throws like content_of().
[[nodiscard]] ExperimentRecord record_of(const ExperimentOptions& options,
                                         const std::vector<std::string>& command);

/// The bytes of a name in hexadecimal digits if JSON cannot hold them: if it is not UTF-8.
[[nodiscard]] std::optional<std::string> hex_unless_utf8(const std::string& name);

/// A record as JSON. All strings are valid UTF-8: what is not is replaced, and the names of files
/// are there in hexadecimal digits, too, so that they are found again.
void to_json(nlohmann::json& json, const ExperimentRecord& record);

/// The record that to_json() made `json` of. Throws nlohmann::json::exception for what is none, and
/// Error(invalid_argument) for names that are not there.
void from_json(const nlohmann::json& json, ExperimentRecord& record);

/// Reads a record from a file. Throws Error(io), and Error(parse) if it is none.
[[nodiscard]] ExperimentRecord load_record(const std::filesystem::path& file);

/// Throws Error(parse) naming the first scene whose file is not what it was, and Error(io) for one
/// that cannot be read; `what_fails` ends the message: "the run cannot be resumed".
void require_unchanged(const ExperimentRecord& record, std::string_view what_fails);

}  // namespace coppice::lab
