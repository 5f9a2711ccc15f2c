// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor validate --fix`, `--unsafe-fixes` and `--diff`, as scripts and hooks use them; and what is left of
// a run that is killed.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <cli/program.h>

#include "support/part.h"

namespace rigor::test {
namespace {

/// A model with one finding that has a safe fix, and one that has an unsafe one.
std::string fixable_model(const std::string& space, const std::string& lower,
                          const std::string& upper) {
  return "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n  <model name=\"arm\">\n"
         "    <link "
         "name=\"base\"><inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz>"
         "</inertia></inertial></link>\n"
         "    <link "
         "name=\"hand\"><inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz>"
         "</inertia></inertial></link>\n"
         "    <joint name=\"elbow\"" +
         space + "type=\"revolute\">\n      <parent>base</parent>\n      <child>hand</child>\n" +
         "      <axis><xyz>0 0 1</xyz><limit><lower>" + lower + "</lower><upper>" + upper +
         "</upper></limit></axis>\n    </joint>\n  </model>\n</sdf>\n";
}

const std::string kFixable = fixable_model("", "1", "-1");
const std::string kSafelyFixed = fixable_model(" ", "1", "-1");
const std::string kAllFixed = fixable_model(" ", "-1", "1");

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(FixCli, WritesSafeFixesAndListsWhatIsLeft) {
  const Folder folder;
  folder.put("arm.sdf", kFixable);
  folder.put("sub/arm.sdf", kFixable);
  ::chmod(folder.path("arm.sdf").c_str(), 0640);
  const Ran ran = folder.rigor("validate --fix --format concise");
  EXPECT_EQ(ran.exit, 1);  // the inverted limit is left
  EXPECT_EQ(folder.get("arm.sdf"), kSafelyFixed);
  EXPECT_EQ(folder.get("sub/arm.sdf"), kSafelyFixed);
  EXPECT_TRUE(contains(ran.out, "joint-limit-inverted"));
  EXPECT_FALSE(contains(ran.out, "xml-attributes-touch"));
  EXPECT_TRUE(contains(ran.err, "fixed 2 findings (2 xml-attributes-touch) in 2 files\n"))
      << ran.err;
  EXPECT_TRUE(contains(ran.err, "2 more findings can be fixed with --unsafe-fixes\n")) << ran.err;
  struct stat status = {};
  ::stat(folder.path("arm.sdf").c_str(), &status);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST(FixCli, WritesUnsafeFixesOnlyWhenAskedAndThenNothingMore) {
  const Folder folder;
  folder.put("arm.sdf", kFixable);
  EXPECT_EQ(folder.rigor("validate --unsafe-fixes arm.sdf").exit, 1);
  EXPECT_EQ(folder.get("arm.sdf"), kFixable);  // it says which fixes, not that they be written
  EXPECT_EQ(folder.rigor("validate --fix --unsafe-fixes arm.sdf").exit, 0);
  EXPECT_EQ(folder.get("arm.sdf"), kAllFixed);
  const Ran again = folder.rigor("validate --fix --unsafe-fixes arm.sdf");
  EXPECT_EQ(again.exit, 0);
  EXPECT_EQ(folder.get("arm.sdf"), kAllFixed);
  EXPECT_TRUE(contains(again.err, "nothing fixed\n"));
}

// 3 kg in a box of 0.3 x 0.2 x 0.1 m: m / 12 (y² + z²) = 0.0125 and so on.
TEST(FixCli, AnInertialKeepsItsCenterOfMass) {
  const Folder folder;
  folder.put(
      "a.sdf",
      "<sdf version='1.9'><model name='m'><link name='l'><inertial><pose>0.1 0 0 0 0 0</pose>"
      "<mass>3</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>9</izz></inertia></inertial>"
      "<collision name='c'><geometry><box><size>0.3 0.2 0.1</size></box></geometry>"
      "</collision></link></model></sdf>\n");
  folder.rigor("validate a.sdf --fix --unsafe-fixes");
  const std::string fixed = folder.get("a.sdf");
  EXPECT_NE(fixed.find("<pose>0.1 0 0 0 0 0</pose>"), std::string::npos) << fixed;
  EXPECT_NE(fixed.find("<ixx>0.0125</ixx><iyy>0.025</iyy><izz>0.0325</izz>"), std::string::npos)
      << fixed;
}

TEST(FixCli, HintsAtFixesWithoutBeingAsked) {
  const Folder folder;
  folder.put("arm.sdf", kFixable);
  EXPECT_TRUE(contains(folder.rigor("validate arm.sdf").err,
                       "1 finding can be fixed with --fix, 1 more with --unsafe-fixes\n"));
}

TEST(FixCli, DoesNotFixWhatIsIgnored) {
  const Folder folder;
  folder.put("arm.sdf", kFixable);
  folder.rigor("validate --fix --ignore xml-attributes-touch arm.sdf");
  EXPECT_EQ(folder.get("arm.sdf"), kFixable);
}

TEST(FixCli, PrintsADiffThatPatchTakes) {
  const Folder folder;
  folder.put("one/arm.sdf", kFixable);
  folder.put("two/arm.sdf", kFixable);
  folder.put("two/good.sdf", kAllFixed);
  for (const std::string options : {"--diff --unsafe-fixes", "--diff --fix --unsafe-fixes"}) {
    const Ran ran = folder.rigor("validate " + options + " one ./two");
    EXPECT_EQ(ran.exit, 1);
    EXPECT_TRUE(ran.out.starts_with("--- a/one/arm.sdf\n+++ b/one/arm.sdf\n@@")) << ran.out;
    EXPECT_TRUE(contains(ran.out, "--- a/two/arm.sdf\n"));
    EXPECT_FALSE(contains(ran.out, "good.sdf"));
    EXPECT_TRUE(contains(ran.err, "would fix 4 findings"));
    EXPECT_EQ(folder.get("one/arm.sdf"), kFixable);
    folder.put("changes.patch", ran.out);
  }
  if (std::system("command -v patch >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "patch is not installed";
  const std::string patch = "cd '" + folder.path("") + "' && patch -p1 -s <changes.patch";
  EXPECT_EQ(std::system(patch.c_str()), 0);
  EXPECT_EQ(folder.get("one/arm.sdf"), kAllFixed);
  EXPECT_EQ(folder.get("two/arm.sdf"), kAllFixed);
}

TEST(FixCli, AnEmptyDiffFailsOnlyForWhatIsFound) {
  const Folder folder;
  folder.put("good.sdf", kAllFixed);
  folder.put("arm.sdf", kSafelyFixed);
  EXPECT_EQ(folder.rigor("validate --diff good.sdf").exit, 0);
  const Ran ran = folder.rigor("validate --diff arm.sdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(folder.rigor("validate --diff --fail-on never arm.sdf").exit, 0);
}

TEST(FixCli, FixesStdinToStdoutAndSaysTheRestOnStderr) {
  const Folder folder;
  folder.put("in", kFixable);
  const Ran ran = folder.rigor("validate --fix --format concise -", "cat in |");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_EQ(ran.out, kSafelyFixed);
  EXPECT_TRUE(contains(ran.err, "<stdin>:")) << ran.err;
  EXPECT_TRUE(contains(ran.err, "[joint-limit-inverted]"));

  folder.put("in", kAllFixed);  // what needs no fix comes through as it is
  EXPECT_EQ(folder.rigor("validate --fix -", "cat in |").out, kAllFixed);

  folder.put("in", kFixable);
  const Ran diff = folder.rigor("validate --diff - --stdin-filename arm.sdf", "cat in |");
  EXPECT_EQ(diff.exit, 1);
  EXPECT_TRUE(diff.out.starts_with("--- a/arm.sdf\n+++ b/arm.sdf\n"));
}

TEST(FixCli, LeavesFilesAloneThatAreNotXml) {
  const Folder folder;
  const std::string broken = kFixable.substr(0, kFixable.size() - 8);
  folder.put("arm.sdf", broken);
  EXPECT_EQ(folder.rigor("validate --fix --unsafe-fixes arm.sdf").exit, 1);
  EXPECT_EQ(folder.get("arm.sdf"), broken);
}

/// Ends a run of `rigor validate --fix` in the folder with a signal, so many microseconds after its start.
void fix_and_kill(const Folder& folder, int signal, long microseconds) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    ::execl(RIGOR_BINARY, RIGOR_BINARY, "validate", "--fix", folder.path("").c_str(), nullptr);
    ::_exit(127);
  }
  std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
  ::kill(child, signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) > 1);
}

struct Killed {
  std::size_t old_files = 0;
  std::size_t new_files = 0;
  std::size_t broken_files = 0;
  std::size_t others = 0;  ///< what the run had begun to write
};

/// Kills a run at moments all over its time, each time from the same start.
Killed kill_often(int signal, int kills) {
  constexpr int kFiles = 60;
  const Folder folder;
  const auto name = [](int i) { return "arm_" + std::to_string(i) + ".sdf"; };
  const auto reset = [&] {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
      std::filesystem::remove(entry.path(), ignored);
    }
    for (int i = 0; i < kFiles; ++i) folder.put(name(i), kFixable);
  };
  reset();
  const auto started = std::chrono::steady_clock::now();
  folder.rigor("validate --fix");
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - started);
  std::mt19937 random(1000);
  Killed seen;
  for (int kill = 0; kill < kills; ++kill) {
    reset();
    fix_and_kill(folder, signal,
                 static_cast<long>(random() % static_cast<unsigned long>(whole.count())));
    for (int i = 0; i < kFiles; ++i) {
      const std::string now = folder.get(name(i));
      seen.old_files += now == kFixable ? 1 : 0;
      seen.new_files += now == kSafelyFixed ? 1 : 0;
      seen.broken_files += now != kFixable && now != kSafelyFixed ? 1 : 0;
    }
    const std::filesystem::directory_iterator entries(folder.path(""));
    seen.others += static_cast<std::size_t>(std::distance(begin(entries), end(entries))) - kFiles;
  }
  return seen;
}

/// `RIGOR_KILLS=1000` for more.
int kills_wanted() {
  const char* wanted = std::getenv("RIGOR_KILLS");
  return wanted == nullptr ? static_cast<int>(24 / test::parts()) : std::atoi(wanted);
}

TEST(FixCli, LeavesTheOldFileOrTheNewOneWhenKilled) {
  const Killed seen = kill_often(SIGKILL, kills_wanted());
  std::printf("%zu old, %zu new; %zu temporary files\n", seen.old_files, seen.new_files,
              seen.others);
  EXPECT_EQ(seen.broken_files, 0U);
  // A kill ends one write at most.
  EXPECT_LE(seen.others, static_cast<std::size_t>(kills_wanted()));
}

TEST(FixCli, LeavesNothingElseWhenAskedToEnd) {
  const Killed seen = kill_often(SIGTERM, kills_wanted());
  std::printf("%zu old, %zu new; %zu temporary files\n", seen.old_files, seen.new_files,
              seen.others);
  EXPECT_EQ(seen.broken_files, 0U);
  EXPECT_EQ(seen.others, 0U);
}

}  // namespace
}  // namespace rigor::test
