// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines of results as `validate` and `simulate` write them, for as many models as a test wants.

#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <rigor/results/parts.h>
#include <rigor/results/writer.h>
#include <rigor/text/disk.h>

namespace rigor::results {

inline std::string model_path(std::size_t i) { return fmt::format("models/m{}/model.sdf", i); }

/// Every third file has an error, every fourth a warning at two places; two meshes are shared by all.
inline std::string checked_line(std::size_t i, std::size_t of) {
  const std::string path = model_path(i);
  const auto finding = [&](const char* rule, const char* severity, const char* places) {
    return fmt::format(
        R"({{"rule":"{}","category":"inertia","severity":"{}","message":"ixx < 0","path":"{}","line":3,)"
        R"("column":5,"end_line":3,"end_column":9,"subject":"m/link l","related":[],"fix":null,)"
        R"("why":"","help":"","docs":"","places":[{}],"origin":[]}})",
        rule, severity, path, places);
  };
  std::string findings;
  if (i % 3 == 0) findings += finding("inertia-not-physical", "error", "");
  if (i % 4 == 0) {
    findings += findings.empty() ? "" : ",";
    findings += finding("axis-zero", "warning",
                        R"({"path":"other.sdf","line":null,"subject":"","message":"again"})");
  }
  return fmt::format(
      R"({{"case":{{"index":{0},"of":{1},"id":"{2}"}},"path":"{2}","kind":"sdf","version":"1.9",)"
      R"("models":1,"links":2,"joints":1,"not_looked_at":[{3}],"meshes":[{{"path":"meshes/{4}.stl",)"
      R"("digest":"{5:032x}","bytes":684,"triangles":12,"extents":{{"min":[-1,-1,-1],"max":[1,1,{6}]}}}}],)"
      R"("diagnostics":[{7}]}})",
      i, of, path, i == 1 ? "\"include of https://example.org/hand\"" : "", i, i % 2, i % 2 + 1,
      findings);
}

/// Every fifth case tips over.
inline std::string simulated_line(std::size_t i, std::size_t of) {
  const char* const verdict = i % 5 == 0 ? "fail" : "pass";
  return fmt::format(
      R"({{"case":{{"index":{0},"of":{1},"id":"seed=0"}},"model":"{2}","verdict":"{3}","runs":[{{"test":)"
      R"("settle","seed":0,"verdict":"{3}","duration":2.5,"steps":2500,"metrics":[{{"id":"tilt.max",)"
      R"("value":{4},"unit":"rad","warn":0.1,"fail":0.5,"verdict":"{3}"}},{{"id":"rest.creep","value":null,)"
      R"("unit":"m/s","warn":null,"fail":null,"verdict":"pass"}}],"commands":[],"confirmations":[],)"
      R"("final":{{"pose":{{}}}},"state_hash":"{0:016x}"}}],"left_out":[],"diagnostics":[]}})",
      i, of, model_path(i), verdict, i % 5 == 0 ? 1.5 : 0.01);
}

/// A folder that is gone after the test.
class ResultsFolder {
 public:
  ResultsFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "rigor-results-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~ResultsFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string path(const std::string& name) const { return path_ + "/" + name; }
  std::size_t files() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator(path_)) ++count;
    return count;
  }

 private:
  std::string path_;
};

/// Writes a database of complete lines, which are spread over some files in the order that they are given in.
inline void write_database(const std::vector<std::string>& lines, std::size_t files,
                           const std::string& path) {
  std::map<std::string, std::string> parts;
  for (std::size_t i = 0; i < lines.size(); ++i)
    parts[fmt::format("{}.jsonl", (i * 7) % files)] += lines[i] + '\n';
  const MemoryDisk disk(parts);
  Parts joined(disk);
  for (const auto& [name, bytes] : parts) ASSERT_EQ(joined.add(name), std::nullopt);
  const Completeness found = joined.sort();
  ASSERT_EQ(found.missing + found.doubled, 0U);
  Writer writer(path);
  ASSERT_EQ(joined.each([&](const Record& record) { writer.add(record); }), std::nullopt);
  writer.finish();
}

inline std::vector<std::string> lines_of_both(std::size_t models) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < models; ++i) lines.push_back(checked_line(i, models));
  for (std::size_t i = 0; i < models; ++i) lines.push_back(simulated_line(i, models));
  return lines;
}

}  // namespace rigor::results
