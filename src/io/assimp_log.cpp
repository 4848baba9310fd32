#include "io/assimp_log.h"

#include "io/text.h"

#include <assimp/DefaultLogger.hpp>
#include <assimp/Logger.hpp>

#include <algorithm>
#include <array>

namespace coppice::inline v0 {

namespace {

constexpr unsigned watched = Assimp::Logger::Warn | Assimp::Logger::Err;

std::unique_lock<std::mutex> lock_log() {
    static std::mutex mutex;
    return std::unique_lock(mutex);
}

/// True if a message reports lost or altered faces. Assimp's messages have no codes, so that it is
/// recognized by words. Messages seen in 5.2.5: "Some faces had out-of-range indices. Those faces
/// were dropped.", "AC3D: Invalid vertex reference", "Face has an invalid index. It will be
/// ignored", "MDC vertex index is out of range".
bool tells_of_lost_faces(std::string_view message) {
    constexpr std::array<std::string_view, 3> subjects = {"vert", "face", "triangle"};
    constexpr std::array<std::string_view, 6> losses = {
        "out of range", "out-of-range", "out of bounds", "invalid", "incorrect", "dropped"};
    const std::string text = to_lower(message);
    const auto is_in_text = [&](std::string_view word) {
        return text.find(word) != std::string::npos;
    };
    return std::any_of(subjects.begin(), subjects.end(), is_in_text) &&
           std::any_of(losses.begin(), losses.end(), is_in_text);
}

}  // namespace

AssimpLog::AssimpLog()
    : only_one_(lock_log()), is_log_ours_(Assimp::DefaultLogger::isNullLogger()) {
    if (is_log_ours_) {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    }
    Assimp::DefaultLogger::get()->attachStream(this, watched);
}

AssimpLog::~AssimpLog() {
    Assimp::DefaultLogger::get()->detachStream(this, watched);
    if (is_log_ours_) {
        Assimp::DefaultLogger::kill();
    }
}

void AssimpLog::write(const char* message) {
    std::string text = one_line(message);
    // Removes the prefix "Warn,  T0: ".
    const std::size_t colon = text.find(": ");
    if (colon != std::string::npos && text.find(", T") < colon) {
        text.erase(0, colon + 2);
    }
    if (data_loss_.empty() && tells_of_lost_faces(text)) {
        data_loss_ = text;
    }
    if (message_count_++ < kept_messages) {
        messages_.push_back(std::move(text));
    }
}

std::string one_line(std::string_view message) {
    std::string line;
    for (std::string_view rest = message; !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of("\r\n\t "), rest.size());
        if (end > 0) {
            line += line.empty() ? "" : " ";
            line += rest.substr(0, end);
        }
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    constexpr std::size_t longest = 240;
    return line.substr(0, longest);
}

}  // namespace coppice::inline v0
