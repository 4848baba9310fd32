#pragma once

#include <assimp/LogStream.hpp>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::inline v0 {

/// Collects the warnings and errors that Assimp logs while this object lives. Some of its importers
/// drop or alter faces with bad indices and report that only here. The log is global, so only one
/// AssimpLog exists at a time: the constructor waits for the others.
class AssimpLog : public Assimp::LogStream {
public:
    AssimpLog();
    ~AssimpLog() override;
    AssimpLog(const AssimpLog&) = delete;
    AssimpLog& operator=(const AssimpLog&) = delete;
    AssimpLog(AssimpLog&&) = delete;
    AssimpLog& operator=(AssimpLog&&) = delete;

    /// Receives a message from Assimp.
    void write(const char* message) override;

    [[nodiscard]] std::uint64_t message_count() const noexcept { return message_count_; }

    /// The first messages, at most `kept_messages`, as one line each.
    [[nodiscard]] const std::vector<std::string>& messages() const noexcept { return messages_; }

    /// The first message about lost or altered faces; empty if there is none.
    [[nodiscard]] const std::string& data_loss() const noexcept { return data_loss_; }

    static constexpr std::size_t kept_messages = 8;

private:
    std::unique_lock<std::mutex> only_one_;
    bool is_log_ours_;
    std::uint64_t message_count_ = 0;
    std::vector<std::string> messages_;
    std::string data_loss_;
};

/// A message from Assimp as a single line.
[[nodiscard]] std::string one_line(std::string_view message);

}  // namespace coppice::inline v0
