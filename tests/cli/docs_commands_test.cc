// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands in the documents exist, with the options that they are shown with.

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cli/program.h>
#include <support/corpus.h>

namespace rigor::test {
namespace {

/// What is code in a document: fenced, indented, or between backquotes.
std::vector<std::string> code_in(const std::string& markdown) {
  static const std::regex span("`([^`]+)`");
  std::vector<std::string> code;
  std::istringstream stream(markdown);
  bool fenced = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      fenced = !fenced;
    } else if (fenced || line.starts_with("    ")) {
      code.push_back(line);
    } else {
      for (std::sregex_iterator each(line.begin(), line.end(), span), end; each != end; ++each) {
        code.push_back((*each)[1]);
      }
    }
  }
  return code;
}

class Helps {
 public:
  /// The options of a command; empty when there is no such command.
  const std::set<std::string>& options(const std::string& command) {
    const auto [found, fresh] = known_.try_emplace(command);
    if (!fresh) return found->second;
    const Ran ran = folder_.rigor(command + " --help");
    static const std::regex option("--[a-z][a-z0-9-]*|-[a-zA-Z]\\b");
    if (ran.exit == 0) {
      for (std::sregex_iterator each(ran.out.begin(), ran.out.end(), option), end; each != end;
           ++each) {
        found->second.insert(each->str());
      }
    }
    return found->second;
  }

 private:
  Folder folder_;
  std::map<std::string, std::set<std::string>> known_;
};

TEST(DocumentCommands, ExistWithTheirOptions) {
  namespace fs = std::filesystem;
  const fs::path top = RIGOR_SOURCE_DIR;
  std::vector<fs::path> documents{top / "README.md", top / "CONTRIBUTING.md",
                                  top / "packaging/README.md"};
  for (const auto& entry : fs::directory_iterator(top / "docs")) {
    if (entry.path().extension() == ".md") documents.push_back(entry.path());
  }
  // A command at the beginning of a line, after a prompt, or after `run:` and the like of CI.
  static const std::regex command(
      R"((?:^\s*|[$:(]\s+|&&\s+|\|\s+)rigor ([a-z][a-z0-9-]*)((?: [^|;&`]*)?))");
  static const std::regex option(R"(\s(--[a-z][a-z0-9-]*))");
  Helps helps;
  int checked = 0;
  for (const fs::path& document : documents) {
    const std::string name = document.lexically_relative(top).string();
    for (const std::string& line : code_in(read_file(document))) {
      std::smatch found;
      if (!std::regex_search(line, found, command)) continue;
      const std::set<std::string>& known = helps.options(found[1]);
      EXPECT_FALSE(known.empty()) << name << ": there is no `rigor " << found[1] << "`: " << line;
      const std::string rest = found[2].str().substr(0, found[2].str().find(" #"));
      for (std::sregex_iterator each(rest.begin(), rest.end(), option), end; each != end; ++each) {
        EXPECT_TRUE(known.contains((*each)[1]))
            << name << ": `rigor " << found[1] << "` has no " << (*each)[1];
      }
      ++checked;
    }
  }
  EXPECT_GT(checked, 100);
}

}  // namespace
}  // namespace rigor::test
