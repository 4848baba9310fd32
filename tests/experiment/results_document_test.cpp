#include "experiment/results_document.h"

#include "experiment/experiment.h"
#include "support/lab_scenes.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace coppice::lab {

namespace {

using Json = nlohmann::ordered_json;
using testing::MatchesRegex;

class ResultsDocument : public testing::Test {
protected:
    ResultsDocument() {
        options_.scenes = {folder_.make_scene("hills, \"old\".ply", "terrain", 400),
                           folder_.make_scene("balls.ply", "spheres", 600)};
        options_.percents = {100, 0.5};
        options_.seed_count = 2;
        options_.build.threads = 1;
        options_.out = "out/x";
        results_ = run_experiment(options_);
        document_ = results_document(options_, results_, {"coppice", "experiment"});
    }

    test::TemporaryFolder folder_;
    ExperimentOptions options_;
    std::vector<SceneResult> results_;
    Json document_;
};

/// The fields of a CSV file, by RFC 4180.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
    std::vector<std::vector<std::string>> lines{{""}};
    bool is_quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            const bool is_escaped = is_quoted && i + 1 < text.size() && text[i + 1] == '"';
            if (is_escaped) lines.back().back() += text[++i];
            if (!is_escaped) is_quoted = !is_quoted;
        } else if (c == ',' && !is_quoted) {
            lines.back().emplace_back();
        } else if (c == '\n' && !is_quoted) {
            lines.push_back({""});
        } else {
            lines.back().back() += c;
        }
    }
    lines.pop_back();  // after the last line end
    return lines;
}

bool has_only_finite_numbers(const Json& json) {
    if (json.is_null()) return false;
    if (!json.is_structured()) return true;
    return std::all_of(json.begin(), json.end(), has_only_finite_numbers);
}

TEST_F(ResultsDocument, SaysWhereItComesFrom) {
    EXPECT_EQ(document_["coppice"], "0.1.0");
    EXPECT_THAT(document_["created"].get<std::string>(),
                MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z"));
    EXPECT_THAT(document_["git_revision"].get<std::string>(),
                MatchesRegex("unknown|[0-9a-f]{7,40}(-dirty)?"));
    EXPECT_THAT(document_["compiler"].get<std::string>(),
                MatchesRegex("(GCC|Clang) [0-9]+\\.[0-9]+\\.[0-9]+"));
    EXPECT_TRUE(document_["build_type"].is_string());
    EXPECT_EQ(document_["command"], (Json{"coppice", "experiment"}));
    const Json& machine = document_["machine"];
    EXPECT_GE(machine["cores"], 1);
    EXPECT_GT(machine["memory_bytes"], 1'000'000);
    EXPECT_NE(machine["cpu"], "");
    EXPECT_NE(machine["os"], "");
}

TEST_F(ResultsDocument, HasEveryOption) {
    const Json& options = document_["options"];
    const Json expected{{"scenes", {options_.scenes[0].string(), options_.scenes[1].string()}},
                        {"primitives", {"points", "triangles"}},
                        {"protocols", {"fixed", "scaled", "grown"}},
                        {"rates", {100.0, 0.5}},
                        {"split", "sah"},
                        {"methods", Json::array()},
                        {"samplers", {"uniform"}},
                        {"rays", Json::array()},
                        {"seeds", 2},
                        {"tolerance", 2.0},
                        {"traversal_cost", 1.0},
                        {"intersection_cost", 1.0},
                        {"empty_bonus", 0.5},
                        {"max_depth", 50},
                        {"max_leaf", 32},
                        {"bad_refines", 3},
                        {"clipping", "perfect"},
                        {"threads", 1},
                        {"pictures", true},
                        {"out", "out/x"}};
    EXPECT_EQ(nlohmann::json(options), nlohmann::json(expected));
}

TEST_F(ResultsDocument, HasScenesWithAllParts) {
    ASSERT_EQ(document_["scenes"].size(), 2U);
    for (const Json& scene : document_["scenes"]) {
        EXPECT_EQ(scene["rows"].size(), 24U);
        EXPECT_EQ(scene["details"].size(), 24U);
        EXPECT_EQ(scene["summary"].size(), 12U);
        EXPECT_EQ(scene["recommended"].size(), 6U);
        EXPECT_EQ(scene["knees"].size(), 6U);
        EXPECT_GT(scene["vertex_count"], 0);
        EXPECT_GT(scene["triangle_count"], 0);
        EXPECT_GT(scene["distinct_vertex_count"], 0);
        EXPECT_EQ(scene["bounds"]["lower"].size(), 3U);
        EXPECT_EQ(scene["bounds"]["upper"].size(), 3U);
        EXPECT_EQ(scene["load_report"]["format"], "ply");
    }
    EXPECT_EQ(document_["scenes"][0]["scene"], "hills, \"old\"");
}

TEST_F(ResultsDocument, DetailsBelongToTheirRows) {
    const Json& scene = document_["scenes"][1];
    for (std::size_t i = 0; i < scene["rows"].size(); ++i) {
        const Json& row = scene["rows"][i];
        const Json& details = scene["details"][i];
        for (const char* key : {"primitives", "protocol", "sample_percent", "seed"}) {
            EXPECT_EQ(row[key], details[key]);
        }
        std::uint64_t leaf_count = 0;
        for (const Json& count : details["depth_histogram"]) {
            leaf_count += count.get<std::uint64_t>();
        }
        EXPECT_EQ(leaf_count, row["leaf_count"].get<std::uint64_t>());
        const double cost = details["expected_inner_visits"].get<double>() +
                            details["expected_primitive_tests"].get<double>();
        EXPECT_NEAR(cost, row["sah_cost"].get<double>(), 1e-9 * cost);  // both constants are 1
    }
}

TEST_F(ResultsDocument, RecommendsAmongItsRows) {
    for (const Json& chosen : document_["scenes"][1]["recommended"]) {
        EXPECT_TRUE(chosen["sample_percent"] == 100 || chosen["sample_percent"] == 0.5);
        EXPECT_GT(chosen["relative_cost"], 0);
        EXPECT_GT(chosen["relative_time"], 0);
        EXPECT_THAT(chosen["rule"].get<std::string>(), testing::HasSubstr("within 2 %"));
    }
    for (const Json& knee : document_["scenes"][1]["knees"]) {
        EXPECT_EQ(knee["rule"], "kneedle");
        EXPECT_THAT(knee["source"].get<std::string>(), testing::HasSubstr("Kneedle"));
    }
}

void expect_equal_row(const Json& row, const std::vector<std::string>& names,
                      const std::vector<std::string>& fields) {
    ASSERT_EQ(fields.size(), names.size());
    ASSERT_EQ(row.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Json& value = row.at(names[i]);
        const bool is_equal =
            value.is_string() ? value == fields[i] : value.get<double>() == std::stod(fields[i]);
        EXPECT_TRUE(is_equal) << names[i] << ": " << value << ", CSV: " << fields[i];
    }
}

TEST_F(ResultsDocument, RowsEqualTheCsv) {
    const auto lines = parse_csv(csv_text(results_));
    std::size_t line = 1;
    for (const Json& scene : document_["scenes"]) {
        for (const Json& row : scene["rows"]) {
            expect_equal_row(row, lines.at(0), lines.at(line++));
        }
    }
    EXPECT_EQ(line, lines.size());
}

TEST_F(ResultsDocument, HasNoNulls) {
    EXPECT_TRUE(has_only_finite_numbers(document_));
}

TEST_F(ResultsDocument, NamesThatAreNotUtf8AreReplaced) {
    results_[0].scene = "\xff\xfe";
    results_[0].file = "\xff.obj";
    const Json document = results_document(options_, results_, {"\x80"});
    EXPECT_NO_THROW(static_cast<void>(document.dump()));
}

}  // namespace

}  // namespace coppice::lab
