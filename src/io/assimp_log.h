#pragma once

#include <assimp/LogStream.hpp>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {

/// Collects the warnings and errors that Assimp logs in its lifetime. Some of its importers drop
/// or bend faces with bad indices and say so nowhere else. The log is one for the whole process,
/// so only one AssimpLog exists at a time: the constructor waits for the others.
class AssimpLog : public Assimp::LogStream {
public:
    AssimpLog();
    ~AssimpLog() override;
    AssimpLog(const AssimpLog&) = delete;
    AssimpLog& operator=(const AssimpLog&) = delete;
    AssimpLog(AssimpLog&&) = delete;
    AssimpLog& operator=(AssimpLog&&) = delete;

    /// Called by Assimp.
    void write(const char* message) override;

    [[nodiscard]] std::uint64_t message_count() const noexcept { return message_count_; }

    /// The first messages, each one line, at most `kept_messages`.
    [[nodiscard]] const std::vector<std::string>& messages() const noexcept { return messages_; }

    /// The first message that tells of lost or bent faces; empty if there was none.
    [[nodiscard]] const std::string& data_loss() const noexcept { return data_loss_; }

    static constexpr std::size_t kept_messages = 8;

private:
    std::unique_lock<std::mutex> only_one_;
    bool is_log_ours_;
    std::uint64_t message_count_ = 0;
    std::vector<std::string> messages_;
    std::string data_loss_;
};

/// A message of Assimp's as one line of text.
[[nodiscard]] std::string one_line(std::string_view message);

}  // namespace coppice::inline v0
