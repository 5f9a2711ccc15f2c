// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats of `rigor validate` that CI services read, its shards, and how they are joined.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <tinyxml2.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>

namespace rigor::test {
namespace {

using FormatJson = nlohmann::json;

/// The variables of all services away, so that the tests say the same in CI.
constexpr const char* kNoCi =
    "env -u CI_NODE_INDEX -u CI_NODE_TOTAL -u CIRCLE_NODE_INDEX -u CIRCLE_NODE_TOTAL "
    "-u BUILDKITE_PARALLEL_JOB -u BUILDKITE_PARALLEL_JOB_COUNT -u SYSTEM_JOBPOSITIONINPHASE "
    "-u SYSTEM_TOTALJOBSINPHASE -u SEMAPHORE_JOB_INDEX -u SEMAPHORE_JOB_COUNT "
    "-u SLURM_ARRAY_TASK_ID -u SLURM_ARRAY_TASK_COUNT "
    "-u CI_PROJECT_DIR -u GITHUB_WORKSPACE -u GITHUB_STEP_SUMMARY ";

constexpr const char* kBroken =
    "<sdf version='1.9'>\n<model name='m'>\n<link name='l'/>\n<link name='l'/>\n</model>\n</sdf>\n";
constexpr const char* kEmptyWorld = "<sdf version='1.9'>\n<world name='w'/>\n</sdf>\n";

class FormatsCli : public testing::Test {
 protected:
  FormatsCli() {
    folder_.put(".git/HEAD", "ref: refs/heads/main\n");
    for (const char* name : {"a", "b", "c", "d", "e"}) {
      folder_.put(std::string("robots/") + name + "/model.sdf", kBroken);
    }
    folder_.put("robots/lab.world", kEmptyWorld);
    folder_.put("robots/t/model.sdf.erb", "<%= 1 %>");
    folder_.put("robots/u/model.sdf.jinja", "{{ 1 }}");
  }

  Ran validate(const std::string& arguments, const std::string& variables = "") const {
    return folder_.rigor("validate " + arguments, kNoCi + variables);
  }

  Folder folder_;
};

TEST_F(FormatsCli, Sarif) {
  const Ran ran = validate("robots --format sarif");
  EXPECT_EQ(ran.exit, 1);
  const FormatJson run = FormatJson::parse(ran.out)["runs"][0];
  EXPECT_FALSE(run["results"].empty());
  EXPECT_EQ(run["invocations"][0]["exitCode"], 1);
  EXPECT_EQ(run["invocations"][0]["toolExecutionNotifications"].size(), 2U) << "the templates";
  EXPECT_EQ(ran.out.find(folder_.path("")), std::string::npos) << "nothing says where it ran";
  const Ran absolute = validate("'" + folder_.path("robots") + "' --format sarif");
  EXPECT_EQ(absolute.out, ran.out);
}

TEST_F(FormatsCli, Github) {
  const Ran ran = validate("robots/a --format github");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_TRUE(
      ran.out.starts_with("::error title=rigor (duplicate-name),file=robots/a/model.sdf,"
                          "line=4,endLine=4,"))
      << ran.out;
}

TEST_F(FormatsCli, GithubAddsToThePageOfTheRun) {
  folder_.put("summary.md", "of another step\n");
  const std::string named = "GITHUB_STEP_SUMMARY='" + folder_.path("summary.md") + "'";
  validate("robots/a --format github", named);
  const std::string page = folder_.get("summary.md");
  EXPECT_TRUE(page.starts_with("of another step\n")) << page;
  EXPECT_NE(page.find("duplicate-name"), std::string::npos) << page;
  validate("robots/a --format concise", named);
  EXPECT_EQ(folder_.get("summary.md"), page) << "only the format for GitHub does";
  const Ran ran = validate("robots/a --format github", "GITHUB_STEP_SUMMARY=/nowhere/at/all");
  EXPECT_EQ(ran.exit, 1) << "as without";
  EXPECT_NE(ran.err.find("GITHUB_STEP_SUMMARY"), std::string::npos) << ran.err;
}

TEST_F(FormatsCli, GitlabSeesPathsFromTheTopOfTheProject) {
  const Ran ran =
      folder_.rigor("validate a --format gitlab", "cd robots && " + std::string(kNoCi) +
                                                      "CI_PROJECT_DIR='" + folder_.path("") + "'");
  EXPECT_EQ(ran.exit, 1) << ran.err;
  EXPECT_EQ(FormatJson::parse(ran.out)[0]["location"]["path"], "robots/a/model.sdf");
}

TEST_F(FormatsCli, PathsBeginAtTheRepository) {
  folder_.put(".git/HEAD", "ref: refs/heads/main\n");
  const Ran ran =
      folder_.rigor("validate ../robots/./a --format gitlab", "cd robots && " + std::string(kNoCi));
  EXPECT_EQ(FormatJson::parse(ran.out)[0]["location"]["path"], "robots/a/model.sdf");
}

TEST_F(FormatsCli, GitlabOfACleanRunIsAnEmptyList) {
  const Ran ran = validate("robots/lab.world --output gitlab:report.json");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(folder_.get("report.json"), "[]\n");
}

TEST_F(FormatsCli, Junit) {
  const Ran ran = validate("robots --format junit");
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(ran.out.c_str()), tinyxml2::XML_SUCCESS) << ran.out;
  const tinyxml2::XMLElement* suites = document.FirstChildElement("testsuites");
  ASSERT_NE(suites, nullptr);
  EXPECT_EQ(suites->IntAttribute("skipped"), 2);
  EXPECT_GE(suites->IntAttribute("failures"), 5);
}

TEST_F(FormatsCli, SeveralInOneRun) {
  const Ran ran = validate(
      "robots/a --format concise --output sarif:out.sarif --output gitlab:out.json "
      "--output junit:out.xml --output jsonl:out.jsonl --output github:out.txt");
  EXPECT_EQ(ran.exit, 1) << ran.err;
  EXPECT_NE(ran.out.find("[duplicate-name]\n"), std::string::npos);
  for (const char* format : {"sarif", "gitlab", "junit", "jsonl", "github"}) {
    const std::string ending = std::string(format) == "gitlab"   ? "json"
                               : std::string(format) == "junit"  ? "xml"
                               : std::string(format) == "github" ? "txt"
                                                                 : format;
    EXPECT_EQ(folder_.get("out." + ending),
              validate("robots/a --format " + std::string(format)).out)
        << format;
  }
}

TEST_F(FormatsCli, ShardsMergedAreTheWhole) {
  const std::string whole = validate("robots --format jsonl").out;
  EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 8) << "six files and two templates";
  for (const int of : {2, 3, 7, 20}) {
    std::string parts;
    for (int i = 1; i <= of; ++i) {
      const std::string part = "part" + std::to_string(i) + ".jsonl";
      const std::string shard = std::to_string(i) + '/' + std::to_string(of);
      const Ran ran = validate("robots --shard " + shard + " --output jsonl:" + part);
      EXPECT_LE(ran.exit, 1) << ran.err;
      parts += ' ' + part;
    }
    const Ran merged = folder_.rigor("merge" + parts);
    EXPECT_EQ(merged.exit, 0) << merged.err;
    EXPECT_EQ(merged.out, whole) << of << " shards";
  }
}

TEST_F(FormatsCli, APartThatIsMissingIsNamed) {
  validate("robots --shard 1/2 --output jsonl:one.jsonl");
  validate("robots --shard 2/2 --output jsonl:two.jsonl");
  const std::string bigger =
      folder_.get("one.jsonl").size() > folder_.get("two.jsonl").size() ? "one" : "two";
  const Ran merged = folder_.rigor("merge " + bigger + ".jsonl -o all.jsonl");
  EXPECT_EQ(merged.exit, 1);
  EXPECT_NE(merged.err.find("of 8 is missing"), std::string::npos) << merged.err;
  EXPECT_EQ(folder_.get("all.jsonl"), "");
}

TEST_F(FormatsCli, ShardAutoIsWhatTheServiceSays) {
  const std::string second = validate("robots --format jsonl --shard 2/3").out;
  ASSERT_NE(second, validate("robots --format jsonl --shard 1/3").out);
  for (const char* variables :
       {"CI_NODE_INDEX=2 CI_NODE_TOTAL=3", "CIRCLE_NODE_INDEX=1 CIRCLE_NODE_TOTAL=3",
        "BUILDKITE_PARALLEL_JOB=1 BUILDKITE_PARALLEL_JOB_COUNT=3",
        "SYSTEM_JOBPOSITIONINPHASE=2 SYSTEM_TOTALJOBSINPHASE=3",
        "SEMAPHORE_JOB_INDEX=2 SEMAPHORE_JOB_COUNT=3",
        "SLURM_ARRAY_TASK_ID=2 SLURM_ARRAY_TASK_COUNT=3"}) {
    EXPECT_EQ(validate("robots --format jsonl --shard auto", variables).out, second) << variables;
  }
  const std::string whole = validate("robots --format jsonl").out;
  for (const char* variables : {"CI_NODE_TOTAL=1", "CIRCLE_NODE_INDEX=0 CIRCLE_NODE_TOTAL=1",
                                "SYSTEM_TOTALJOBSINPHASE=0 SYSTEM_JOBPOSITIONINPHASE=1"}) {
    EXPECT_EQ(validate("robots --format jsonl --shard auto", variables).out, whole) << variables;
  }
}

TEST_F(FormatsCli, AShardThatIsNoneIsRefused) {
  const Ran unknown = validate("robots --shard auto");
  EXPECT_EQ(unknown.exit, 2);
  EXPECT_NE(unknown.err.find("CI_NODE_INDEX"), std::string::npos) << unknown.err;
  EXPECT_NE(unknown.err.find("strategy.job-total"), std::string::npos) << unknown.err;
  for (const char* variables :
       {"CI_NODE_INDEX=4 CI_NODE_TOTAL=3", "CI_NODE_INDEX=0 CI_NODE_TOTAL=3", "CI_NODE_TOTAL=3",
        "CI_NODE_INDEX=two CI_NODE_TOTAL=3", "CIRCLE_NODE_INDEX=3 CIRCLE_NODE_TOTAL=3"}) {
    EXPECT_EQ(validate("robots --shard auto", variables).exit, 2) << variables;
  }
  EXPECT_EQ(validate("robots --shard 4/3").exit, 2);
  EXPECT_EQ(validate("robots --shard all").exit, 2);
}

}  // namespace
}  // namespace rigor::test
