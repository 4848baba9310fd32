#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

namespace coppice::inline v0 {

/// A file that is being written. It has a temporary name in the folder of the final file, so that
/// the last step is a rename within a file system: all or nothing.
class NewFile {
public:
    /// Creates a temporary file. Throws Error(io) if `file` exists and is not a regular file, or if
    /// no file can be created in its folder.
    explicit NewFile(const std::filesystem::path& file);

    /// Removes the temporary file unless commit() succeeded.
    ~NewFile();

    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    NewFile(NewFile&&) = delete;
    NewFile& operator=(NewFile&&) = delete;

    /// Appends bytes. Throws Error(io).
    void write(std::string_view bytes);

    /// Waits until everything written is on the disk. Throws Error(io).
    void sync();

    /// Closes the file. Only commit() may follow. Throws Error(io).
    void close();

    /// Renames the file to its final name. Throws Error(io).
    void commit();

private:
    /// Throws Error(io) with the text of a system error number.
    [[noreturn]] void fail(int error_number) const;

    std::filesystem::path file_;
    std::filesystem::path target_;  ///< `file_`, or what it links to
    std::filesystem::path temporary_;
    std::FILE* stream_ = nullptr;
};

}  // namespace coppice::inline v0
