// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/jsonl.h>

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <report/found.h>
#include <rigor/report/json/json.h>
#include <rigor/rules/environment.h>

namespace rigor::report {
namespace {

using JsonlJson = nlohmann::ordered_json;

std::vector<std::string> whole_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    lines.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return lines;
}

/// Small models: with and without findings, and one that includes another.
MemoryDisk models_on_disk() {
  MemoryDisk disk;
  for (int i = 0; i < 12; ++i) {
    const std::string number = std::to_string(i);
    disk.put("m" + number + "/model.sdf",
             "<sdf version='1.9'><model name='m" + number + "'><link name='l'/>" +
                 (i % 3 == 0 ? "<link name='l'/>" : "") + "</model></sdf>\n");
  }
  disk.put("world.sdf",
           "<sdf version='1.9'><world name='w'><include><uri>m3</uri></include>"
           "<include><uri>https://example.org/hand</uri></include></world></sdf>\n");
  return disk;
}

std::string lines_of_shard(const Environment& environment, Shard shard) {
  Sources sources;
  rules::ValidateOptions options;
  options.shard = shard;
  for (int i = 0; i < 12; ++i) options.paths.push_back("m" + std::to_string(i) + "/model.sdf");
  options.paths.push_back("world.sdf");
  const auto result = rules::validate(environment, options, sources);
  return jsonl({result, sources, environment.registry});
}

TEST(Jsonl, PartsTogetherAreTheWhole) {
  const MemoryDisk disk = models_on_disk();
  const Environment environment(disk, {});
  const std::string whole = lines_of_shard(environment, {});
  EXPECT_EQ(whole_lines(whole).size(), 13U);
  for (const unsigned of : {2U, 3U, 7U, 40U}) {
    std::map<std::size_t, std::string> by_index;
    for (unsigned index = 1; index <= of; ++index) {
      for (const std::string& line : whole_lines(lines_of_shard(environment, {index, of}))) {
        const JsonlJson one = JsonlJson::parse(line)["case"];
        EXPECT_EQ(one["of"], 13);
        EXPECT_TRUE(by_index.emplace(one["index"].get<std::size_t>(), line).second);
      }
    }
    std::string joined;
    for (const auto& [index, line] : by_index) joined += line;
    EXPECT_EQ(joined, whole) << of << " shards";
  }
}

TEST(Jsonl, SaysWhatJsonSays) {
  const MemoryDisk disk = models_on_disk();
  const Environment environment(disk, {});
  Sources sources;
  const auto result =
      rules::validate(environment, {.paths = {"m0/model.sdf", "world.sdf"}}, sources);
  const JsonlJson all = JsonlJson::parse(json(result, sources));
  JsonlJson files = JsonlJson::array();
  JsonlJson findings = JsonlJson::array();
  std::size_t not_looked_at = 0;
  for (const std::string& line : whole_lines(jsonl({result, sources, environment.registry}))) {
    JsonlJson one = JsonlJson::parse(line);
    EXPECT_EQ(one["case"]["id"], one["path"]);
    for (const JsonlJson& finding : one["diagnostics"]) findings.push_back(finding);
    not_looked_at += one["not_looked_at"].size();
    for (const char* key : {"case", "not_looked_at", "meshes", "diagnostics"}) one.erase(key);
    files.push_back(one);
  }
  EXPECT_EQ(files, all["files"]);
  EXPECT_EQ(findings, all["diagnostics"]);
  EXPECT_EQ(not_looked_at, all["summary"]["not_looked_at"]);
  EXPECT_EQ(not_looked_at, 1U) << "the include that needs the network";
}

TEST(Jsonl, ALineHoldsNoLineBreak) {
  Found found;
  found.file("a\nb.sdf", "x").at("x", {.message = "one\ntwo \xFF"});
  const std::string text = jsonl(found.validation());
  EXPECT_EQ(whole_lines(text).size(), 1U);
  EXPECT_EQ(JsonlJson::parse(text)["diagnostics"][0]["message"], "one\ntwo \uFFFD");
}

TEST(Jsonl, NothingCheckedIsNoLine) { EXPECT_EQ(jsonl(Found().validation()), ""); }

}  // namespace
}  // namespace rigor::report
