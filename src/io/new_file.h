#pragma once

#include <cstdio>
#include <filesystem>
#include <string_view>

namespace coppice::inline v0 {

/// A file while it is being written: under a temporary name in the folder of its final one, so
/// that the last step is a rename within a file system, all or nothing.
class NewFile {
public:
    /// Throws Error(io) if `file` is anything but a regular file or absent, or if no file can be
    /// made in its folder.
    explicit NewFile(const std::filesystem::path& file);

    /// Removes the temporary file unless commit() was reached.
    ~NewFile();

    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    NewFile(NewFile&&) = delete;
    NewFile& operator=(NewFile&&) = delete;

    /// Appends bytes. Throws Error(io).
    void write(std::string_view bytes);

    /// Waits until all that was written is on the disk. Throws Error(io).
    void sync();

    /// Ends the writing: only commit() may follow. Throws Error(io).
    void close();

    /// Gives the file its final name. Throws Error(io).
    void commit();

private:
    /// Throws Error(io) with the reason of the system call that failed last.
    [[noreturn]] void fail(int error_number) const;

    std::filesystem::path file_;
    std::filesystem::path target_;  ///< `file_`, or what it links to
    std::filesystem::path temporary_;
    std::FILE* stream_ = nullptr;
};

}  // namespace coppice::inline v0
