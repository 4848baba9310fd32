#pragma once

#include "experiment/experiment_options.h"
#include "experiment/experiment_record.h"
#include "rows/results.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::lab {

/// The trees of an experiment that are finished, on disk as soon as they are: a run that was killed
/// goes on from here. One file in the folder of the results, one line a tree; a line that was cut
/// off by the end of the program or the machine does not count.
class Journal {
public:
    /// The file's name.
    static constexpr std::string_view file_name = "unfinished.jsonl";

    /// Whether a folder has one.
    [[nodiscard]] static bool exists(const std::filesystem::path& folder);

    /// Begins one in `options.out`. Nothing is written before the first tree is added; that makes
    /// the folder if need be, and replaces the file of another run.
    [[nodiscard]] static Journal begin(const ExperimentOptions& options,
                                       const std::vector<std::string>& command);

    /// Opens the one that a folder has, to go on with it. Throws Error(io) if there is none, and
    /// Error(parse) if it is not one, or one of a scene whose file has changed since.
    [[nodiscard]] static Journal open(const std::filesystem::path& folder);

    Journal(Journal&&) noexcept;
    Journal& operator=(Journal&&) noexcept;
    ~Journal();

    /// The options of the run and the program's argument list that began it.
    [[nodiscard]] const ExperimentOptions& options() const noexcept { return record_.options; }

    [[nodiscard]] const std::vector<std::string>& command() const noexcept {
        return record_.command;
    }

    /// The same with the contents of the scenes' files, once the first tree is added.
    [[nodiscard]] const ExperimentRecord& record() const noexcept { return record_; }

    [[nodiscard]] std::size_t row_count() const noexcept { return rows_.size(); }

    /// What was measured of a finished tree; nothing if it is not finished. Its report's `options`
    /// are not kept.
    [[nodiscard]] std::optional<TreeFigures> find(const TreeKey& key) const;

    /// Adds a finished tree; it is on disk when this returns. Throws Error(io).
    void add(const TreeKey& key, const TreeFigures& figures);

    /// Removes the file: the results are written.
    void remove() noexcept;

private:
    struct File;

    Journal(std::filesystem::path path, ExperimentRecord record);
    void read_rows(std::string_view lines);
    void make_file();

    std::filesystem::path path_;
    ExperimentRecord record_;
    std::map<TreeKey, TreeFigures> rows_;
    std::unique_ptr<File> file_;
};

}  // namespace coppice::lab
