#pragma once

#include "coppice/tree/validate.h"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace coppice::inline v0 {

/// The issues found by one validation, up to its limit.
class IssueList {
public:
    explicit IssueList(std::size_t limit) : limit_(limit) {}

    /// Adds an issue unless the limit is reached.
    template <typename... Args>
    void report(ValidationIssueKind kind, std::uint64_t subject, fmt::format_string<Args...> format,
                Args&&... args) {
        if (is_full()) return;
        findings_.push_back({kind, subject, fmt::format(format, std::forward<Args>(args)...)});
    }

    /// The message of the first issue. The list must not be empty.
    [[nodiscard]] const std::string& first_message() const { return findings_.front().message; }

    [[nodiscard]] bool is_empty() const noexcept { return findings_.empty(); }

    [[nodiscard]] bool is_full() const noexcept { return findings_.size() >= limit_; }

    [[nodiscard]] std::vector<ValidationIssue> take() && noexcept { return std::move(findings_); }

private:
    std::size_t limit_;
    std::vector<ValidationIssue> findings_;
};

}  // namespace coppice::inline v0
