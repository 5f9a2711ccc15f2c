// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor merge -o results.sqlite` and `rigor report results.sqlite` as their users script them.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <rigor/results/sqlite.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

using results::Connection;

/// A box with a mesh to look at: a tetrahedron of a size in m.
std::string boxed_model(const std::string& name) {
  return "<sdf version='1.9'><model name='" + name +
         "'><pose>0 0 0.05 0 0 0</pose><link "
         "name='l'><inertial><mass>1</mass><inertia><ixx>0.0017</ixx>"
         "<iyy>0.0017</iyy><izz>0.0017</izz></inertia></inertial>"
         "<collision name='c'><geometry><box><size>0.1 0.1 0.1</size></box></geometry></collision>"
         "<visual name='v'><geometry><mesh><uri>hull.obj</uri></mesh></geometry></visual>"
         "</link></model></sdf>\n";
}

std::string tetrahedron(const std::string& size) {
  return "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nv 0 0 " + size +
         "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}

class ResultsDatabase : public testing::Test {
 protected:
  ResultsDatabase() {
    for (int i = 0; i < 6; ++i) {
      const std::string name = "m" + std::to_string(i);
      folder_.put("robots/" + name + "/model.sdf", boxed_model(name));
      folder_.put("robots/" + name + "/hull.obj", tetrahedron(i < 4 ? "0.1" : "0.2"));
    }
    for (const char* shard : {"1", "2", "3"}) {
      const std::string part = std::string(" --shard ") + shard + "/3 --output jsonl:";
      EXPECT_EQ(
          folder_.rigor("validate robots --fail-on never" + part + "v" + shard + ".jsonl").exit, 0);
    }
  }

  std::int64_t ask(const std::string& database, const std::string& query) const {
    return Connection(folder_.path(database), Connection::Access::kRead).integer(query);
  }

  Folder folder_;
};

TEST_F(ResultsDatabase, HoldsTheMeshesThatWereOpened) {
  const Ran merged = folder_.rigor("merge v1.jsonl v2.jsonl v3.jsonl -o results.sqlite");
  EXPECT_EQ(merged.exit, 0) << merged.err;
  EXPECT_EQ(ask("results.sqlite", "SELECT count(*) FROM models"), 6);
  EXPECT_EQ(ask("results.sqlite", "SELECT count(*) FROM model_meshes"), 6);
  EXPECT_EQ(ask("results.sqlite", "SELECT count(*) FROM meshes"), 2) << "four copies, and two";
  EXPECT_EQ(ask("results.sqlite",
                "SELECT count(*) FROM meshes WHERE triangles = 4 AND min_x = 0 AND "
                "abs(max_z - 0.1) < 1e-6"),
            1);
  EXPECT_EQ(ask("results.sqlite", "SELECT sum(bytes) FROM meshes"),
            2 * static_cast<std::int64_t>(tetrahedron("0.1").size()));
}

TEST_F(ResultsDatabase, ListsNoMeshesThatWereNotOpened) {
  const Ran lines = folder_.rigor("validate robots/m0/model.sdf --no-mesh --format jsonl");
  EXPECT_EQ(nlohmann::json::parse(lines.out)["meshes"], nlohmann::json::array());
}

TEST_F(ResultsDatabase, JoinsBothCommandsAndIsBrowsed) {
  const std::string simulate =
      "simulate robots/*/model.sdf --fail-on never --no-confirm --output jsonl:";
  EXPECT_EQ(folder_.rigor(simulate + "s.jsonl").exit, 0);
  const Ran merged = folder_.rigor("merge s.jsonl v3.jsonl v1.jsonl v2.jsonl -o all.db");
  EXPECT_EQ(merged.exit, 0) << merged.err;
  EXPECT_EQ(ask("all.db", "SELECT count(*) FROM models"), 6) << "one row for both";
  EXPECT_EQ(ask("all.db", "SELECT count(*) FROM cases JOIN models ON models.id = model_id"), 6);
  EXPECT_GT(
      ask("all.db", "SELECT count(*) FROM metrics WHERE metric = 'tilt.max' AND unit = 'rad'"), 5);
  const Ran report = folder_.rigor("report all.db -o site/");
  EXPECT_EQ(report.exit, 0) << report.err;
  EXPECT_NE(folder_.get("site/index.html").find("6 files checked"), std::string::npos);
  EXPECT_NE(folder_.get("site/models/1.html").find("m5"), std::string::npos);
}

TEST_F(ResultsDatabase, IsNotWrittenOfHalfARun) {
  folder_.put("results.sqlite", "as before");
  const Ran half = folder_.rigor("merge v1.jsonl v2.jsonl -o results.sqlite");
  EXPECT_EQ(half.exit, 1);
  EXPECT_NE(half.err.find("of validate is missing"), std::string::npos) << half.err;
  const Ran doubled = folder_.rigor("merge v1.jsonl v1.jsonl v2.jsonl v3.jsonl -o results.sqlite");
  EXPECT_EQ(doubled.exit, 1);
  EXPECT_NE(doubled.err.find("v1.jsonl:1 and in v1.jsonl:1"), std::string::npos) << doubled.err;
  EXPECT_EQ(folder_.rigor("merge none.jsonl -o results.sqlite").exit, 2);
  EXPECT_EQ(folder_.rigor("merge v1.jsonl v2.jsonl v3.jsonl -o none/results.sqlite").exit, 2);
  EXPECT_EQ(folder_.get("results.sqlite"), "as before");
}

TEST_F(ResultsDatabase, IsReportedIntoAFolderOnly) {
  EXPECT_EQ(folder_.rigor("merge v1.jsonl v2.jsonl v3.jsonl -o a.db").exit, 0);
  EXPECT_EQ(folder_.rigor("report a.db -o page.html").exit, 2);
  EXPECT_EQ(folder_.rigor("report a.db robots -o site/").exit, 2);
  folder_.put("text.db", "no database");
  const Ran refused = folder_.rigor("report text.db -o site/");
  EXPECT_EQ(refused.exit, 2);
  EXPECT_NE(refused.err.find("text.db: "), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace rigor::test
