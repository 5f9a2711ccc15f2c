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
      {"read", {"text", "xml", "schema", "model"}},
      {"process", {"text"}},
      {"xacro", {"text", "xml"}},
      {"config", {"text"}},
      {"mesh", {"text", "xml", "model", "process"}},
      {"mass", {"text", "model", "mesh"}},
      {"write", {"text", "xml", "schema", "model", "read", "mass"}},
      {"convert", {"text", "xml", "schema", "model", "read", "mesh", "mass", "write", "process"}},
      {"simulate",
       {"text", "xml", "schema", "model", "config", "process", "read", "mesh", "mass", "convert"}},
      {"rules",
       {"text", "xml", "schema", "model", "read", "mesh", "mass", "write", "convert", "simulate",
        "environment"}},
      {"environment", {"text", "schema", "read", "rules"}},
      {"author",
       {"text", "xml", "schema", "model", "read", "mesh", "mass", "write", "convert", "simulate",
        "rules", "environment"}},
      {"view",
       {"text", "xml", "schema", "model", "read", "mesh", "mass", "convert", "simulate", "rules",
        "author", "environment"}},
      {"report",
       {"text", "xml", "schema", "model", "read", "mesh", "mass", "write", "convert", "simulate",
        "rules", "author", "view", "environment"}},
  };
  return kRooms;
}

/// The rooms a third party's headers may be named in.
const std::map<std::string, Names>& third_parties() {
  static const std::map<std::string, Names> kParties{
      {"tinyxml2.h", {"xml", "tools"}},
      {"Eigen/", {"mass", "report"}},
      {"fmt/", {"convert", "rules", "author", "report", "tools"}},
      {"nlohmann/", {"report", "tools"}},
      {"CLI/", {"tools"}},
      {"toml++", {"config"}},
      {"assimp/", {"mesh"}},
      {"libqhull", {"mesh"}},
      {"meshoptimizer", {"mesh", "tools"}},
      {"urdf_parser/", {"convert"}},
      {"console_bridge/", {"convert"}},
      {"ode/", {"simulate", "tools"}},
      {"embree3/", {"view"}},
      {"png.h", {"view", "mesh"}},
      {"turbojpeg.h", {"view"}},
      {"zlib.h", {"report"}},
      {"yaml-cpp/", {"xacro"}},
      {"boost/", {"xacro"}}};
  return kParties;
}

/// `rules/xml/a.cc` is of room rules; `environment.h` is a room of its own.
std::string room_of(const std::string& path) {
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? path.substr(0, path.find('.')) : path.substr(0, slash);
}

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
