// Work in a process of its own, and what it says to the one that asked: whatever goes wrong there,
// here it is a sentence.

#include "io/isolate.h"

#include "coppice/base/error.h"

#include "io/import_answer.h"
#include "io/message.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace coppice::test {
namespace {

constexpr IsolationLimits limits{.memory_bytes = std::uint64_t{1} << 28, .cpu_seconds = 10};

std::string failure_of(const std::function<std::string()>& work) {
    return run_isolated(work, limits).failure;
}

TEST(RunIsolated, HandsTheResultOver) {
    const std::string large(3'000'000, 'x');
    int touched = 0;
    const IsolatedResult result = run_isolated(
        [&] {
            touched = 1;
            return large + std::to_string(getpid());
        },
        limits);
    EXPECT_EQ(result.failure, "");
    EXPECT_EQ(result.bytes.substr(0, large.size()), large);
    EXPECT_NE(result.bytes.substr(large.size()), std::to_string(getpid()));
    EXPECT_EQ(touched, 0);
    EXPECT_EQ(run_isolated([] { return std::string(); }, limits).bytes, "");
}

TEST(RunIsolated, TellsHowItFailed) {
    const auto die_of = [](int signal) {
        return failure_of([signal] {
            std::raise(signal);
            return std::string();
        });
    };
    EXPECT_EQ(die_of(SIGSEGV), "crashed (Segmentation fault)");
    EXPECT_EQ(die_of(SIGABRT), "crashed (Aborted)");
    EXPECT_EQ(die_of(SIGXCPU), "did not finish in time");
    EXPECT_EQ(failure_of([]() -> std::string { throw std::runtime_error("no"); }), "failed");
    EXPECT_EQ(failure_of([]() -> std::string { _exit(0); }), "failed");
    EXPECT_NE(failure_of([] { return std::string(std::size_t{1} << 40, 'x'); }), "");
}

TEST(RunIsolated, LetsNothingBeHeard) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(failure_of([] {
                  std::fputs("free(): invalid pointer\n", stderr);
                  std::fflush(stderr);
                  return std::string();
              }),
              "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

ImportAnswer small_answer() {
    ImportAnswer answer;
    answer.loaded.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    answer.loaded.report.file = "a.dae";
    answer.loaded.report.warnings = {"one", ""};
    answer.loaded.report.polygons = {2, {7, 9}};
    answer.attributes.materials = {{.name = "red", .diffuse = {1, 0, 0}, .illumination = 2}};
    answer.attributes.triangle_materials = {0};
    answer.attributes.normals = {{0, 0, 1}, {}, {}};
    return answer;
}

TEST(ImportAnswer, ComesOverWhole) {
    const ImportAnswer sent = small_answer();
    const ImportAnswer came = import_answer_from(to_bytes(sent), "a.dae");
    EXPECT_EQ(came.loaded.mesh.vertices, sent.loaded.mesh.vertices);
    EXPECT_EQ(came.loaded.mesh.triangles, sent.loaded.mesh.triangles);
    EXPECT_EQ(came.loaded.report.warnings, sent.loaded.report.warnings);
    EXPECT_EQ(came.loaded.report.polygons.first, sent.loaded.report.polygons.first);
    EXPECT_EQ(came.attributes.materials[0].name, "red");
    EXPECT_EQ(came.attributes.materials[0].illumination, 2);
    EXPECT_EQ(came.attributes.normals, sent.attributes.normals);
}

std::string refusal_of(const ImportAnswer& answer) {
    try {
        static_cast<void>(import_answer_from(to_bytes(answer), "a.dae"));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ImportAnswer, IsNotTrusted) {
    const std::string broken = "a.dae: Assimp returned invalid data: the file is damaged";
    ImportAnswer answer = small_answer();
    answer.loaded.mesh.triangles[0][1] = 3;
    EXPECT_EQ(refusal_of(answer), broken);
    answer = small_answer();
    answer.attributes.triangle_materials = {1};
    EXPECT_EQ(refusal_of(answer), broken);
    answer = small_answer();
    answer.attributes.normals.pop_back();
    EXPECT_EQ(refusal_of(answer), broken);
    answer.set_error(file_error(ErrorCode::limit, "a.dae", "too large"));
    EXPECT_EQ(refusal_of(answer), "a.dae: too large");
    const std::string bytes = to_bytes(small_answer());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_THROW(static_cast<void>(import_answer_from(bytes.substr(0, size), "a.dae")), Error);
    }
}

}  // namespace
}  // namespace coppice::test
