// Lines are appended by one write and synced, so that what a kill or a power cut leaves is a
// beginning of the file: whole lines, and at most one that is cut off, which is cut away on
// opening.

#include "experiment/journal.h"

#include "coppice/base/error.h"
#include "coppice/base/named.h"
#include "coppice/io/write_file.h"
#include "coppice/json/build_report.h"

#include "text/json_text.h"

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>

namespace coppice::lab {

namespace {

using nlohmann::json;

constexpr int journal_version = 3;

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
    throw file_error(ErrorCode::io, path.string(),
                     what + std::string(": ") + std::generic_category().message(errno));
}

StageReport read_stage(const json& stages, const char* name) {
    const json& stage = stages.at(name);
    return {stage.at("wall_seconds"), stage.at("cpu_seconds"), stage.at("items")};
}

/// What is not finite is null in JSON.
double read_number(const json& from) {
    return from.is_null() ? std::numeric_limits<double>::quiet_NaN() : from.get<double>();
}

TreeStatistics read_statistics(const json& from) {
    TreeStatistics statistics;
    from.at("node_count").get_to(statistics.node_count);
    from.at("inner_count").get_to(statistics.inner_count);
    from.at("leaf_count").get_to(statistics.leaf_count);
    from.at("single_primitive_leaf_count").get_to(statistics.single_primitive_leaf_count);
    from.at("empty_leaf_count").get_to(statistics.empty_leaf_count);
    from.at("reference_count").get_to(statistics.reference_count);
    from.at("max_level").get_to(statistics.max_level);
    statistics.mean_leaf_size = read_number(from.at("mean_leaf_size"));
    statistics.sah_cost = read_number(from.at("sah_cost"));
    statistics.expected_inner_visits = read_number(from.at("expected_inner_visits"));
    statistics.expected_leaf_visits = read_number(from.at("expected_leaf_visits"));
    statistics.expected_primitive_tests = read_number(from.at("expected_primitive_tests"));
    from.at("depth_histogram").get_to(statistics.depth_histogram);
    for (const json& share : from.at("cost_share_by_depth")) {
        statistics.cost_share_by_depth.push_back(read_number(share));
    }
    return statistics;
}

BuildReport read_report(const json& from) {
    BuildReport report;
    from.at("primitive_count").get_to(report.primitive_count);
    from.at("sample_count").get_to(report.sample_count);
    from.at("tree_bytes").get_to(report.tree_bytes);
    from.at("peak_bytes").get_to(report.peak_bytes);
    const json& stages = from.at("stages");
    report.stages = {read_stage(stages, "sample"), read_stage(stages, "build"),
                     read_stage(stages, "empty"), read_stage(stages, "refill"),
                     read_stage(stages, "refine")};
    report.statistics = read_statistics(from.at("statistics"));
    return report;
}

json rays_json(const RayFigures& figures) {
    json rays{{"kind", name_of(figures.kind)},
              {"rays", figures.rays},
              {"wall_seconds", figures.wall_seconds},
              {"reference_seconds", figures.reference_seconds},
              {"mismatches", figures.mismatches}};
    if (!figures.steps) return rays;
    rays["nodes"] = figures.steps->nodes;
    rays["leaves"] = figures.steps->leaves;
    rays["primitives"] = figures.steps->primitives;
    return rays;
}

RayFigures read_rays(const json& from) {
    RayFigures figures;
    figures.kind =
        find_named(ray_kind_registry(), from.at("kind").get<std::string>(), "kind of rays").kind;
    from.at("rays").get_to(figures.rays);
    from.at("wall_seconds").get_to(figures.wall_seconds);
    from.at("reference_seconds").get_to(figures.reference_seconds);
    from.at("mismatches").get_to(figures.mismatches);
    if (from.contains("nodes")) {
        figures.steps = {from.at("nodes"), from.at("leaves"), from.at("primitives")};
    }
    return figures;
}

TreeFigures read_figures(const json& row) {
    TreeFigures figures{read_report(row.at("report")), row.at("unsampled_tests"), {}};
    for (const json& rays : row.at("rays")) {
        figures.rays.push_back(read_rays(rays));
    }
    return figures;
}

std::string row_line(const TreeKey& key, const TreeFigures& figures) {
    json row{{"scene", key.scene},
             {"primitives", key.primitives},
             {"protocol", key.protocol},
             {"sampler", key.sampler},
             {"sample_percent", key.sample_percent},
             {"seed", key.seed},
             {"report", figures.report},
             {"unsampled_tests", figures.unsampled_tests},
             {"rays", json::array()}};
    for (const RayFigures& rays : figures.rays) {
        row["rays"].push_back(rays_json(rays));
    }
    return json_ascii_line(row) + '\n';
}

/// With a name that JSON can keep; other names have others.
TreeKey stored_key(TreeKey key) {
    if (const auto hex = hex_unless_utf8(key.scene)) key.scene = *hex;
    return key;
}

/// The file up to the end of its last whole line.
std::string read_whole_lines(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        if (errno != ENOENT) fail(path, "cannot open the file");
        throw file_error(ErrorCode::io, path.string(),
                         "there is no unfinished experiment to resume; run one without --resume");
    }
    std::ostringstream contents;
    contents << stream.rdbuf();
    std::string text = contents.str();
    if (text.size() != std::filesystem::file_size(path)) {  // or rows would be cut off
        throw file_error(ErrorCode::io, path.string(), "cannot read the file");
    }
    text.resize(text.rfind('\n') + 1);  // 0 if there is none
    return text;
}

}  // namespace

/// The open file, at its end.
struct Journal::File {
    explicit File(const std::filesystem::path& path)
        : descriptor(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) {
        if (descriptor < 0) fail(path, "cannot open the file");
    }

    File(const File&) = delete;
    File& operator=(const File&) = delete;

    ~File() { ::close(descriptor); }

    int descriptor;
};

Journal::Journal(std::filesystem::path path, ExperimentRecord record)
    : path_(std::move(path)), record_(std::move(record)) {}

Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&&) noexcept = default;
Journal::~Journal() = default;

bool Journal::exists(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(folder / file_name, ignored);
}

Journal Journal::begin(const ExperimentOptions& options, const std::vector<std::string>& command) {
    return {options.out / file_name, {options, command, {}, {}, {}}};
}

void Journal::make_file() {
    record_ = record_of(record_.options, record_.command);
    const json head{{"format", journal_version}, {"record", record_}};
    std::error_code error;
    std::filesystem::create_directories(record_.options.out,
                                        error);  // write_file() says what is wrong
    write_file(path_, json_ascii_line(head) + '\n');
    file_ = std::make_unique<File>(path_);
}

Journal Journal::open(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / file_name;
    const std::string text = read_whole_lines(path);
    const std::size_t head_end = std::min(text.find('\n'), text.size());
    try {
        const json head = json::parse(text.substr(0, head_end));
        if (head.at("format") != journal_version) {
            throw file_error(ErrorCode::parse, path.string(),
                             "was written by another version of coppice; run the experiment anew");
        }
        Journal journal(path, head.at("record").get<ExperimentRecord>());
        require_unchanged(journal.record_, "the run cannot be resumed");
        journal.record_.options.out = folder;
        journal.read_rows(std::string_view(text).substr(head_end));
        std::filesystem::resize_file(path, text.size());
        journal.file_ = std::make_unique<File>(path);
        return journal;
    } catch (const json::exception& error) {
        throw file_error(ErrorCode::parse, path.string(),
                         std::string("is not an unfinished experiment: ") + error.what());
    }
}

void Journal::read_rows(std::string_view lines) {
    std::istringstream stream{std::string(lines)};
    for (std::string line; std::getline(stream, line);) {
        if (line.empty()) continue;
        const json row = json::parse(line);
        const TreeKey key{{row.at("primitives"), row.at("protocol"), row.at("sampler")},
                          row.at("scene"),
                          row.at("sample_percent"),
                          row.at("seed")};
        rows_[key] = read_figures(row);
    }
}

std::optional<TreeFigures> Journal::find(const TreeKey& key) const {
    const auto at = rows_.find(stored_key(key));
    return at == rows_.end() ? std::nullopt : std::optional(at->second);
}

void Journal::add(const TreeKey& key, const TreeFigures& figures) {
    if (file_ == nullptr) make_file();
    const std::string line = row_line(stored_key(key), figures);
    std::string_view rest = line;
    while (!rest.empty()) {
        const ssize_t written = ::write(file_->descriptor, rest.data(), rest.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(path_, "cannot write to the file");
        rest.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::fsync(file_->descriptor) != 0) fail(path_, "cannot write to the file");
    rows_[stored_key(key)] = figures;
}

void Journal::remove() noexcept {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

}  // namespace coppice::lab
