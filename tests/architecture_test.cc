// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The house's walls, held by reading every #include: no room reaches up or sideways, no two files
// form a circle, third parties stay in the rooms that may use them. The table is docs/architecture.md's.

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/corpus.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// Which rooms a room may include, besides itself.
const std::map<std::string, Names>& rooms() {
  static const std::map<std::string, Names> kRooms{
      {"text", {}},
      {"xml", {"text"}},
      {"schema", {"text"}},
      {"model", {"text"}},
      {"read", {"xacro", "text", "xml", "schema", "model"}},
      {"process", {"text"}},
      {"xacro", {"text", "xml"}},
      {"config", {"text"}},
      {"mesh", {"text", "xml", "model", "process"}},
      {"mass", {"text", "model", "mesh", "process"}},
      {"write", {"text", "xml", "schema", "model", "read", "mass"}},
      {"robot", {"text", "schema", "model", "read", "mesh", "mass"}},
      {"convert",
       {"text", "xml", "schema", "model", "process", "read", "mesh", "mass", "write", "robot"}},
      {"simulate",
       {"text", "xml", "schema", "model", "config", "process", "read", "mesh", "mass", "robot"}},
      {"rules",
       {"xacro", "text", "xml", "schema", "model", "process", "read", "mesh", "mass", "write",
        "robot", "convert", "simulate"}},
      {"results", {"text"}},
      {"author",
       {"xacro", "text", "xml", "schema", "model", "config", "read", "mesh", "mass", "write",
        "robot", "convert", "simulate", "rules"}},
      {"view", {"text", "xml", "schema", "model", "read", "mesh", "mass", "robot"}},
      {"report",
       {"xacro", "text", "xml", "schema", "model", "read", "mesh", "mass", "write", "robot",
        "convert", "simulate", "rules", "author", "view", "results"}},
      {"lsp",
       {"xacro", "text", "xml", "schema", "model", "config", "process", "read", "mesh", "mass",
        "write", "robot", "convert", "simulate", "rules", "author", "report", "view"}},
  };
  return kRooms;
}

/// The rooms a third party's headers may be named in.
const std::map<std::string, Names>& third_parties() {
  static const std::map<std::string, Names> kParties{
      {"tinyxml2.h", {"xml", "tools"}},
      {"Eigen/", {"mass", "report"}},
      {"fmt/", {"convert", "rules", "author", "report", "lsp", "tools"}},
      {"nlohmann/", {"mesh", "report", "results", "lsp"}},
      {"CLI/", {"tools"}},
      {"httplib.h", {"tools"}},
      {"toml++", {"config"}},
      {"assimp/", {"mesh"}},
      {"libqhull", {"mesh"}},
      {"fcl/", {"mesh"}},
      {"meshoptimizer", {"mesh", "tools"}},
      {"urdf_parser/", {"convert"}},
      {"console_bridge/", {"convert"}},
      {"ode/", {"simulate", "tools"}},
      {"mujoco/", {"simulate", "tools"}},
      {"embree", {"view"}},
      {"png.h", {"view", "mesh"}},
      {"turbojpeg.h", {"view"}},
      {"xxhash.h", {"text"}},
      {"yaml-cpp/", {"xacro"}},
      {"boost/", {"xacro"}},
      {"zlib.h", {"report"}},
      {"sqlite3.h", {"results"}}};
  return kParties;
}

/// The first folder: `rules/xml/a.cc` is of room rules.
std::string room_of(const std::string& path) { return path.substr(0, path.find('/')); }

struct File {
  std::string name;  ///< "read/load.cc"; tools as "tools/main.cc"
  Names rigor;       ///< what it includes of rigor, as "read/load.h"
  Names others;
};

std::vector<File> all_files() {
  std::vector<File> files;
  const std::regex include("#include [<\"]([^>\"]+)[>\"]");
  for (const char* top : {"lib/rigor", "tools"}) {
    const fs::path root = fs::path(RIGOR_SOURCE_DIR) / top;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".cc" && ending != ".h") continue;
      File file;
      file.name = fs::relative(entry.path(), root).generic_string();
      if (std::string(top) == "tools") file.name = "tools/" + file.name;
      const std::string text = test::read_file(entry.path());
      for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
        const std::string name = (*it)[1];
        if (name.starts_with("rigor/")) {
          file.rigor.insert(name.substr(6));
        } else {
          file.others.insert(name);
        }
      }
      files.push_back(std::move(file));
    }
  }
  return files;
}

TEST(Architecture, NoRoomReachesUpOrSideways) {
  for (const File& file : all_files()) {
    const std::string room = room_of(file.name);
    if (room == "tools") continue;  // the top floor
    const auto allowed = rooms().find(room);
    ASSERT_NE(allowed, rooms().end()) << file.name << " is in no room that the plan has";
    for (const std::string& name : file.rigor) {
      EXPECT_TRUE(room_of(name) == room || allowed->second.contains(room_of(name)))
          << file.name << " includes " << name;
    }
  }
}

TEST(Architecture, ThirdPartiesStayInTheirRooms) {
  for (const File& file : all_files()) {
    for (const auto& [party, allowed] : third_parties()) {
      for (const std::string& name : file.others) {
        if (!name.starts_with(party)) continue;
        EXPECT_TRUE(allowed.contains(room_of(file.name))) << file.name << " includes " << name;
      }
    }
  }
}

TEST(Architecture, NoTwoFilesFormACircle) {
  std::map<std::string, Names> includes;
  for (const File& file : all_files()) includes[file.name] = file.rigor;
  std::map<std::string, int> state;  // 1 while on the path, 2 when done
  const std::function<void(const std::string&)> visit = [&](const std::string& name) {
    if (state[name] == 2) return;
    ASSERT_NE(state[name], 1) << name << " includes itself in the end";
    state[name] = 1;
    for (const std::string& next : includes[name]) visit(next);
    state[name] = 2;
  };
  for (const auto& [name, next] : std::map(includes)) visit(name);
}

/// What lib/public_headers.cmake lists, as "read/load.h".
Names public_headers() {
  const std::string list =
      test::read_file(fs::path(RIGOR_SOURCE_DIR) / "lib" / "public_headers.cmake");
  const std::regex header("^  rigor/([^)\\s]+)", std::regex::multiline);
  Names names;
  for (std::sregex_iterator it(list.begin(), list.end(), header), end; it != end; ++it) {
    names.insert((*it)[1]);
  }
  return names;
}

TEST(Architecture, PublicHeadersIncludeNoOthers) {
  const Names listed = public_headers();
  ASSERT_GT(listed.size(), 40U);
  std::map<std::string, Names> includes;
  for (const File& file : all_files()) includes[file.name] = file.rigor;
  for (const std::string& header : listed) {
    ASSERT_TRUE(includes.contains(header)) << header << " does not exist";
    for (const std::string& name : includes[header]) {
      EXPECT_TRUE(listed.contains(name)) << header << " includes " << name;
    }
  }
}

TEST(Architecture, FoldersAreSmall) {
  constexpr int kMaxFiles = 40;  // more are split by noun
  std::map<std::string, int> files;
  for (const File& file : all_files()) {
    const fs::path folder = fs::path(file.name).parent_path();
    // A rule is one file, and its category is where people look for it.
    if (folder.parent_path() != "rules") ++files[folder.generic_string()];
  }
  for (const auto& [folder, count] : files) EXPECT_LE(count, kMaxFiles) << folder;
}

TEST(Architecture, FilesHaveOneSubject) {
  for (const char* top : {"lib", "tools", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RIGOR_SOURCE_DIR) / top)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".cc" && ending != ".h") continue;
      const std::string text = test::read_file(entry.path());
      EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 700) << entry.path();
    }
  }
}

}  // namespace
}  // namespace rigor
