// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Completion scripts do complete, and man pages are what man takes; each is asked of the shell or the
// tool itself, where that is installed.

#include <cstdlib>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <cli/program.h>

#include "support/part.h"

namespace rigor::test {
namespace {

bool installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

/// Runs `command` by the shell in the folder.
Ran by_shell(const Folder& folder, const std::string& command) {
  const std::string all = "cd '" + folder.path("") + "' && { " + command + "; } >out.txt 2>err.txt";
  const int status = std::system(all.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder.get("out.txt"),
          folder.get("err.txt")};
}

std::set<std::string> lines_of(const std::string& text) {
  std::set<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.insert(line);
  return lines;
}

/// What bash offers for the last of `words`, as it would ask the script.
std::set<std::string> bash_offers(const Folder& folder, const std::string& words) {
  folder.put("ask.sh", ". ./rigor.bash\nCOMP_WORDS=(" + words +
                           ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                           "$(complete -p rigor | sed 's/.*-F \\([^ ]*\\).*/\\1/')\n"
                           "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
  const Ran ran = by_shell(folder, "bash ask.sh");
  EXPECT_EQ(ran.err, "") << words;
  std::set<std::string> offers = lines_of(ran.out);
  offers.erase("");
  return offers;
}

class BashCompletion : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!installed("bash")) GTEST_SKIP() << "no bash";
    const Ran script = folder_.rigor("completion bash");
    ASSERT_EQ(script.exit, 0) << script.err;
    folder_.put("rigor.bash", script.out);
  }
  Folder folder_;
};

TEST_F(BashCompletion, OffersCommands) {
  EXPECT_EQ(bash_offers(folder_, "rigor mes"), (std::set<std::string>{"mesh-check"}));
  EXPECT_EQ(bash_offers(folder_, "rigor val"), (std::set<std::string>{"validate"}));
  EXPECT_FALSE(bash_offers(folder_, "rigor ''").contains("man")) << "it is hidden";
}

TEST_F(BashCompletion, OffersOptionsOfTheCommand) {
  const auto offers = bash_offers(folder_, "rigor validate --st");
  EXPECT_EQ(offers, (std::set<std::string>{"--stdin-filename"}));
  EXPECT_FALSE(bash_offers(folder_, "rigor inspect --").contains("--stdin-filename"));
}

TEST_F(BashCompletion, OffersValuesOfAnOption) {
  EXPECT_EQ(bash_offers(folder_, "rigor validate --color ''"),
            (std::set<std::string>{"auto", "always", "never"}));
  EXPECT_EQ(bash_offers(folder_, "rigor validate --color = al"), (std::set<std::string>{"always"}));
  EXPECT_EQ(bash_offers(folder_, "rigor validate --fail-on ''"),
            (std::set<std::string>{"error", "warning", "info", "never"}));
  EXPECT_TRUE(bash_offers(folder_, "rigor inspect --format ''").contains("tsv"));
}

/// The names are those that the command takes, however its help words them.
TEST_F(BashCompletion, OffersValuesThatHelpDoesNotList) {
  EXPECT_EQ(bash_offers(folder_, "rigor mesh-check --fit ''"),
            (std::set<std::string>{"box", "sphere", "cylinder", "capsule", "best"}));
  EXPECT_EQ(bash_offers(folder_, "rigor inertia --from ''"),
            (std::set<std::string>{"collision", "visual"}));
  EXPECT_EQ(bash_offers(folder_, "rigor urdf2sdf --sdf-version ''"),
            (std::set<std::string>{"1.9", "1.10", "1.11"}));
  EXPECT_TRUE(bash_offers(folder_, "rigor mesh-check --unit ''").contains("foot"));
  EXPECT_EQ(bash_offers(folder_, "rigor completion z"), (std::set<std::string>{"zsh"}));
}

TEST(Completion, EachValueThatIsOfferedIsTaken) {
  const Folder folder;
  std::istringstream script(folder.rigor("completion bash").out);
  int tried = 0;
  std::set<std::string> seen;  // an option that several commands share is one
  for (std::string line; std::getline(script, line);) {
    // "    'validate --color') words='auto always never' ;;"
    const std::size_t option = line.find(" --");
    const std::size_t words = line.find("') words='");
    if (!line.starts_with("    '") || option == std::string::npos || words == std::string::npos ||
        line.find(" | ") != std::string::npos) {
      continue;
    }
    if (!seen.insert(line.substr(option)).second || !test::in_part(line)) continue;
    const std::string command = line.substr(5, option - 5);
    std::istringstream values(line.substr(words + 10, line.rfind('\'') - words - 10));
    for (std::string value; values >> value;) {
      const std::string given = command + line.substr(option, words - option) + ' ' + value;
      // What is said of anything else is that there is no such file.
      EXPECT_EQ(folder.rigor(given + " none.sdf").err.find('"' + value + '"'), std::string::npos)
          << given;
      ++tried;
    }
  }
  EXPECT_GT(tried, static_cast<int>(test::part_of(100)));
}

TEST_F(BashCompletion, OffersRules) {
  EXPECT_EQ(bash_offers(folder_, "rigor explain axis-z"), (std::set<std::string>{"axis-zero"}));
  EXPECT_TRUE(bash_offers(folder_, "rigor validate --select iner").contains("inertia"));
}

TEST_F(BashCompletion, OffersFilesAndFolders) {
  folder_.put("my robot/model.sdf", "");
  folder_.put("my-notes.txt", "");
  EXPECT_EQ(bash_offers(folder_, "rigor validate my"),
            (std::set<std::string>{"my robot", "my-notes.txt"}));
  EXPECT_EQ(bash_offers(folder_, "rigor validate --model-path my"),
            (std::set<std::string>{"my robot"}));
}

TEST_F(BashCompletion, OffersFilesBehindAVerb) {
  folder_.put("robot.urdf", "");
  folder_.put("notes.txt", "");
  EXPECT_EQ(bash_offers(folder_, "rigor edit lu"), (std::set<std::string>{"lump"}));
  EXPECT_EQ(bash_offers(folder_, "rigor edit lump ro"), (std::set<std::string>{"robot.urdf"}));
  EXPECT_EQ(bash_offers(folder_, "rigor edit rename a b ro"),
            (std::set<std::string>{"robot.urdf"}));
  EXPECT_EQ(bash_offers(folder_, "rigor edit --write re"),
            (std::set<std::string>{"remove", "reroot", "rename"}));
  EXPECT_EQ(bash_offers(folder_, "rigor edit rename --wr"), (std::set<std::string>{"--write"}));
}

TEST(ShellCompletion, ShellsTakeTheirScripts) {
  const Folder folder;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const Ran script = folder.rigor("completion " + shell);
    ASSERT_EQ(script.exit, 0) << script.err;
    folder.put("script", script.out);
    if (!installed(shell)) continue;
    const Ran check = by_shell(folder, shell + " -n script");
    EXPECT_EQ(check.exit, 0) << shell << ": " << check.err;
  }
  EXPECT_EQ(folder.rigor("completion tcsh").exit, 2);
}

TEST(ShellCompletion, FishOffers) {
  if (!installed("fish")) GTEST_SKIP() << "no fish";
  const Folder folder;
  folder.put("rigor.fish", folder.rigor("completion fish").out);
  // The home is the folder's, since fish writes into it.
  const std::string ask =
      "HOME=$PWD XDG_CONFIG_HOME=$PWD XDG_DATA_HOME=$PWD fish -c 'source rigor.fish; ";
  const Ran values = by_shell(folder, ask + "complete -C \"rigor validate --color \"'");
  std::set<std::string> offers;
  for (const std::string& line : lines_of(values.out))
    offers.insert(line.substr(0, line.find('\t')));
  EXPECT_EQ(offers, (std::set<std::string>{"auto", "always", "never"})) << values.err;
}

TEST(ManPages, ManTakesEachWithoutAWarning) {
  const Folder folder;
  std::filesystem::create_directories(folder.path("pages"));
  const Ran wrote = folder.rigor("man -o pages");
  ASSERT_EQ(wrote.exit, 0) << wrote.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path("pages/rigor-validate.1")));
  if (installed("mandoc")) {
    const Ran lint = by_shell(folder, "mandoc -T lint -W error pages/*.1");
    EXPECT_EQ(lint.exit, 0) << lint.out;
  }
  if (installed("groff")) {
    const Ran groff = by_shell(
        folder,
        "for page in pages/*.1; do groff -K utf8 -T utf8 -man -ww $page >/dev/null || exit; done");
    EXPECT_EQ(groff.exit, 0);
    EXPECT_EQ(groff.err, "");
  }
}

TEST(ManPages, APageHoldsEveryOptionOfTheHelp) {
  const Folder folder;
  const std::string page = folder.rigor("man validate").out;
  std::istringstream help(folder.rigor("validate --help").out);
  int options = 0;
  for (std::string line; std::getline(help, line);) {
    const std::size_t begin = line.find("--");
    if (begin == std::string::npos || line.find_first_not_of(" -hj,") < begin) continue;
    std::string name = line.substr(begin, line.find_first_of(" \n", begin) - begin);
    for (std::size_t at = 0; (at = name.find('-', at)) != std::string::npos; at += 2) {
      name.insert(at, "\\");
    }
    EXPECT_NE(page.find("\\fB" + name + "\\fR"), std::string::npos) << name;
    ++options;
  }
  EXPECT_GT(options, 10);
}

}  // namespace
}  // namespace rigor::test
