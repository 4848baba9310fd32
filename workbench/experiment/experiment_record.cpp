#include "experiment/experiment_record.h"

#include "coppice/base/error.h"

#include "rows/machine.h"
#include "text/json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>

namespace coppice::lab {

namespace {

using nlohmann::json;

constexpr int record_version = 1;

/// A file's name under a key, and under key_hex if it is not UTF-8.
void put_name(json& to, const std::string& key, const std::filesystem::path& file) {
    to[key] = file.string();
    if (const auto hex = hex_unless_utf8(file.string())) to[key + "_hex"] = *hex;
}

void read_hex_name(const json& from, const std::string& key, std::filesystem::path& file) {
    if (!from.contains(key)) return;
    const auto hex = from.at(key).get<std::string>();
    std::string name(hex.size() / 2, '\0');
    for (std::size_t i = 0; i < name.size(); ++i) {
        unsigned byte = 0;
        const char* const end = hex.data() + 2 * i + 2;
        const auto read = std::from_chars(end - 2, end, byte, 16);
        if (read.ec != std::errc{} || read.ptr != end || hex.size() % 2 != 0) {
            throw Error(ErrorCode::invalid_argument,
                        "its " + key + " is not made of hexadecimal digits");
        }
        name[i] = static_cast<char>(byte);
    }
    file = name;
}

}  // namespace

std::optional<std::string> hex_unless_utf8(const std::string& name) {
    const std::string text = json_ascii_line(json(name));
    if (json::parse(text).get<std::string>() == name) return std::nullopt;
    std::string hex;
    for (const char byte : name) {
        hex += fmt::format("{:02x}", static_cast<unsigned char>(byte));
    }
    return hex;
}

FileContent content_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                         &XXH3_freeState);
    XXH3_128bits_reset(state.get());
    std::vector<char> piece(1 << 20);
    FileContent content;
    while (stream) {
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        const auto count = static_cast<std::size_t>(stream.gcount());
        XXH3_128bits_update(state.get(), piece.data(), count);
        content.byte_count += count;
    }
    if (!stream.eof()) {
        throw file_error(ErrorCode::io, file.string(),
                         "cannot read the file: " + std::generic_category().message(errno));
    }
    const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
    content.hash = fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
    return content;
}

ExperimentRecord record_of(const ExperimentOptions& options,
                           const std::vector<std::string>& command) {
    ExperimentRecord record{
        options, command, {}, std::string(coppice_version()), std::string(git_revision())};
    for (const std::filesystem::path& scene : options.scenes) {
        record.contents.push_back(content_of(scene));
    }
    return record;
}

void to_json(json& to, const ExperimentRecord& record) {
    to = {{"format", record_version},
          {"coppice", record.program_version},
          {"git_revision", record.git_revision},
          {"command", record.command},
          {"options", given_options_json(record.options)},
          {"scenes", json::array()}};
    for (std::size_t i = 0; i < record.contents.size(); ++i) {
        json scene{{"bytes", record.contents[i].byte_count}, {"xxh3", record.contents[i].hash}};
        put_name(scene, "file", record.options.scenes[i]);
        to["scenes"].push_back(std::move(scene));
    }
    put_name(to["options"], "out", record.options.out);
    to = as_written(to);
}

void from_json(const json& from, ExperimentRecord& record) {
    if (from.at("format") != record_version) {
        throw Error(ErrorCode::invalid_argument, "it was written by another version of coppice");
    }
    record.options = experiment_options_of(from.at("options"));
    from.at("command").get_to(record.command);
    from.at("coppice").get_to(record.program_version);
    from.at("git_revision").get_to(record.git_revision);
    record.contents.clear();
    for (const json& scene : from.at("scenes")) {
        record.contents.push_back({scene.at("bytes"), scene.at("xxh3")});
    }
    if (record.contents.size() != record.options.scenes.size()) {
        throw Error(ErrorCode::invalid_argument,
                    "its lists of scenes and of their contents differ in length");
    }
    for (std::size_t i = 0; i < record.contents.size(); ++i) {
        read_hex_name(from.at("scenes").at(i), "file_hex", record.options.scenes[i]);
    }
    read_hex_name(from.at("options"), "out_hex", record.options.out);
}

ExperimentRecord load_record(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw file_error(ErrorCode::io, file.string(), "cannot open the file");
    try {
        return json::parse(stream).get<ExperimentRecord>();
    } catch (const json::exception&) {
        throw file_error(ErrorCode::parse, file.string(), "is not the record of an experiment");
    } catch (const Error& error) {
        throw file_error(ErrorCode::parse, file.string(),
                         std::string("is not a record to run again: ") + error.what());
    }
}

void require_unchanged(const ExperimentRecord& record, std::string_view what_fails) {
    for (std::size_t i = 0; i < record.contents.size(); ++i) {
        const std::filesystem::path& scene = record.options.scenes[i];
        const FileContent& wanted = record.contents[i];
        const FileContent found = content_of(scene);
        if (found == wanted) continue;
        throw file_error(
            ErrorCode::parse, scene.string(),
            fmt::format("the file has changed since the experiment ({} bytes with hash {}, now {} "
                        "bytes with hash {}): {}",
                        wanted.byte_count, wanted.hash, found.byte_count, found.hash, what_fails));
    }
}

}  // namespace coppice::lab
