// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links of the documents: each leads to a file, and each anchor to a heading. Pages of docs/ link to nothing outside
// it, since docs/ alone becomes the site.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/corpus.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = RIGOR_SOURCE_DIR;

std::vector<fs::path> documents() {
  std::vector<fs::path> found;
  for (const char* folder : {"docs", "packaging", "testdata", "tests", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kTop / folder)) {
      const std::string path = entry.path().string();
      if (entry.path().extension() == ".md" && path.find("node_modules") == std::string::npos) {
        found.push_back(entry.path());
      }
    }
  }
  for (const char* name : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"})
    found.push_back(kTop / name);
  return found;
}

/// The lines of a document without its code, fenced or inline.
std::vector<std::string> prose(const fs::path& path) {
  std::vector<std::string> lines;
  std::istringstream stream(test::read_file(path));
  bool fenced = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      fenced = !fenced;
    } else if (!fenced) {
      lines.push_back(line);
    }
  }
  return lines;
}

/// The anchor that GitHub gives a heading: lowercase, hyphens for spaces, letters, digits, _ and - of the rest.
std::string anchor_of(const std::string& heading) {
  static const std::regex link(R"(\[([^\]]*)\]\([^)]*\))");
  std::string anchor;
  for (const char c : std::regex_replace(heading, link, "$1")) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
                        static_cast<unsigned char>(c) >= 0x80;
    if (c >= 'A' && c <= 'Z') {
      anchor += static_cast<char>(c - 'A' + 'a');
    } else if (c == ' ' || letter) {
      anchor += c == ' ' ? '-' : c;
    }
  }
  return anchor;
}

std::set<std::string> anchors_in(const fs::path& path) {
  std::set<std::string> anchors;
  std::map<std::string, int> times;
  for (const std::string& line : prose(path)) {
    const std::size_t level = line.find_first_not_of('#');
    if (level == 0 || level == std::string::npos || line[level] != ' ') continue;
    const std::string anchor = anchor_of(line.substr(level + 1));
    const int before = times[anchor]++;
    anchors.insert(before == 0 ? anchor : anchor + "-" + std::to_string(before));
  }
  return anchors;
}

TEST(DocumentLinks, LeadSomewhere) {
  static const std::regex code("`[^`]*`");
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  std::map<fs::path, std::set<std::string>> anchors;
  int checked = 0;
  for (const fs::path& document : documents()) {
    for (const std::string& line : prose(document)) {
      // A link's text may be code: only what is between the marks goes.
      const std::string text = std::regex_replace(line, code, "`");
      for (std::sregex_iterator each(text.begin(), text.end(), link), end; each != end; ++each) {
        const std::string target = (*each)[1];
        if (target.starts_with("http:") || target.starts_with("https:")) continue;
        const std::string file = target.substr(0, target.find('#'));
        const fs::path path =
            (file.empty() ? document : document.parent_path() / file).lexically_normal();
        const std::string where = document.lexically_relative(kTop).string() + ": " + target;
        ++checked;
        if (!fs::exists(path)) {
          ADD_FAILURE() << where << " leads nowhere";
          continue;
        }
        const bool in_docs =
            document.lexically_relative(kTop / "docs").string().substr(0, 2) != "..";
        if (in_docs) {
          EXPECT_NE(path.lexically_relative(kTop / "docs").string().substr(0, 2), "..")
              << where << " leaves docs/";
        }
        if (target.size() == file.size()) continue;
        if (!anchors.contains(path)) anchors[path] = anchors_in(path);
        EXPECT_TRUE(anchors[path].contains(target.substr(file.size() + 1)))
            << where << ": no such heading";
      }
    }
  }
  EXPECT_GT(checked, 500);
}

TEST(DocumentLinks, EveryPageIsReached) {
  const std::string index = test::read_file(kTop / "docs/index.md");
  for (const auto& entry : fs::directory_iterator(kTop / "docs")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".md" || name == "index.md") continue;
    EXPECT_NE(index.find("](" + name + ")"), std::string::npos)
        << name << " is not in docs/index.md";
  }
}

TEST(DocumentLinks, AnAnchorIsMadeOfTheHeadingsLetters) {
  EXPECT_EQ(anchor_of("rigor sdf2urdf"), "rigor-sdf2urdf");
  EXPECT_EQ(anchor_of("`[[xacro]]`"), "xacro");
  EXPECT_EQ(anchor_of("What is it? [A link](there.md), in_code"), "what-is-it-a-link-in_code");
}

}  // namespace
}  // namespace rigor
