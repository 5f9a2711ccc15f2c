// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

/// `rigor validate --watch` in a folder; what it says is read line by line, as it comes.
class Watcher {
 public:
  explicit Watcher(const Folder& folder, const char* path) {
    std::array<int, 2> ends{};
    std::array<int, 2> complaints{};
    if (::pipe(ends.data()) != 0 || ::pipe(complaints.data()) != 0) return;
    const std::string where = folder.path("");
    pid_ = ::fork();
    if (pid_ == 0) {
      ::dup2(ends[1], STDOUT_FILENO);
      ::dup2(complaints[1], STDERR_FILENO);
      for (const int end : {ends[0], ends[1], complaints[0], complaints[1]}) ::close(end);
      // Should it say nothing, the test fails and does not hang.
      ::alarm(60);
      if (::chdir(where.c_str()) == 0) {
        ::execl(RIGOR_BINARY, "rigor", "validate", "--watch", path, nullptr);
      }
      ::_exit(99);
    }
    ::close(ends[1]);
    ::close(complaints[1]);
    lines_ = ::fdopen(ends[0], "r");
    complaints_ = ::fdopen(complaints[0], "r");
  }
  ~Watcher() {
    if (lines_ != nullptr) std::fclose(lines_);
    if (complaints_ != nullptr) std::fclose(complaints_);
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;

  /// All up to the first line that holds one of the words; what there is when it ends before.
  std::string read_to(const std::string& word, const std::string& other) {
    return read_to(lines_, word, other);
  }
  /// The same of what stands on stderr.
  std::string complaint(const std::string& word) { return read_to(complaints_, word, word); }
  std::string answer() { return read_to("as before", "no problems"); }

  int interrupt() {
    ::kill(pid_, SIGINT);
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  static std::string read_to(std::FILE* from, const std::string& word, const std::string& other) {
    std::string text;
    std::array<char, 4096> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), from) != nullptr) {
      text += line.data();
      const std::string_view last(line.data());
      if (last.find(word) != std::string::npos || last.find(other) != std::string::npos) break;
    }
    return text;
  }

  pid_t pid_ = -1;
  std::FILE* lines_ = nullptr;
  std::FILE* complaints_ = nullptr;
};

/// Nobody sees half of it, so there is one answer to it.
void put_at_once(const Folder& folder, const std::string& name, const std::string& bytes) {
  folder.put(".new", bytes);
  std::filesystem::rename(folder.path(".new"), folder.path(name));
}

std::string watched_arm(const std::string& inside) {
  return "<robot name=\"arm\">\n  <link name=\"base\"/>\n" + inside + "</robot>\n";
}

constexpr const char* kTurned =
    "  <link name=\"tip\"/>\n"
    "  <joint name=\"wrist\" type=\"revolute\"><parent link=\"base\"/><child link=\"tip\"/>\n"
    "    <axis xyz=\"0 0 1\"/><limit lower=\"1\" upper=\"-1\" effort=\"1\" "
    "velocity=\"1\"/></joint>\n";

TEST(Watch, SaysWhatAnEditDid) {
  const Folder folder;
  folder.put("arm.urdf", watched_arm(""));
  Watcher watcher(folder, "arm.urdf");
  EXPECT_NE(watcher.read_to("watching", "watching").find("watching 1 file"), std::string::npos);

  put_at_once(folder, "arm.urdf", watched_arm(kTurned));
  const std::string broken = watcher.answer();
  EXPECT_NE(broken.find("error[joint-limit-inverted]"), std::string::npos) << broken;
  EXPECT_NE(broken.find(" new"), std::string::npos) << broken;

  // A line above the finding makes nothing new.
  put_at_once(folder, "arm.urdf", "<!-- moved -->\n" + watched_arm(kTurned));
  const std::string moved = watcher.answer();
  EXPECT_EQ(moved.find("nothing changed, "), 0U) << moved;

  put_at_once(folder, "arm.urdf", watched_arm(""));
  const std::string mended = watcher.answer();
  EXPECT_NE(mended.find("fixed: arm.urdf:6:"), std::string::npos) << mended;
  EXPECT_EQ(watcher.interrupt(), 0);
}

TEST(Watch, WhatIsMalformedFixesNothing) {
  const Folder folder;
  folder.put("arm.urdf", watched_arm(kTurned));
  Watcher watcher(folder, "arm.urdf");
  EXPECT_NE(watcher.read_to("watching", "watching").find("joint-limit-inverted"),
            std::string::npos);

  put_at_once(folder, "arm.urdf", "<robot name=\"arm\">\n  <link name=\"base\n");
  const std::string broken = watcher.answer();
  EXPECT_NE(broken.find("error[xml-"), std::string::npos) << broken;
  EXPECT_EQ(broken.find("fixed"), std::string::npos) << broken;
  EXPECT_NE(broken.find("not checked in files that cannot be read"), std::string::npos) << broken;

  put_at_once(folder, "arm.urdf", watched_arm(kTurned));
  const std::string back = watcher.answer();
  EXPECT_EQ(back.find(" new"), std::string::npos) << back;
  EXPECT_EQ(back.find("joint-limit-inverted"), std::string::npos) << back;
}

TEST(Watch, SeesTheConfiguration) {
  const Folder folder;
  folder.put(".git/HEAD", "");
  folder.put("arm.urdf", watched_arm(kTurned));
  Watcher watcher(folder, "arm.urdf");
  EXPECT_NE(watcher.read_to("watching", "watching").find("joint-limit-inverted"),
            std::string::npos);

  put_at_once(folder, "rigor.toml", "ignore = [\"joint-limit-inverted\"]\n");
  const std::string ignored = watcher.answer();
  EXPECT_NE(ignored.find("joint-limit-inverted"), std::string::npos) << ignored;
  EXPECT_NE(ignored.find("fixed"), std::string::npos) << ignored;

  // One that cannot stand is told on stderr, and the watch goes on.
  put_at_once(folder, "rigor.toml", "ignroe = []\n");
  EXPECT_NE(watcher.complaint("ignroe").find("ignroe"), std::string::npos);
  std::filesystem::remove(folder.path("rigor.toml"));
  const std::string back = watcher.answer();
  EXPECT_NE(back.find("error[joint-limit-inverted]"), std::string::npos) << back;
  EXPECT_NE(back.find(" new"), std::string::npos) << back;
}

TEST(Watch, SeesMeshesThatAppear) {
  const Folder folder;
  folder.put(
      "arm.sdf",
      "<sdf version=\"1.9\"><model name=\"m\"><link name=\"l\"><visual name=\"v\"><geometry><mesh>"
      "<uri>meshes/a.stl</uri></mesh></geometry></visual></link></model></sdf>\n");
  Watcher watcher(folder, ".");
  EXPECT_NE(watcher.read_to("watching", "watching").find("mesh-not-found"), std::string::npos);
  folder.put(".hidden/a.stl",
             "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
             "endloop\nendfacet\nendsolid a\n");
  std::filesystem::rename(folder.path(".hidden"), folder.path("meshes"));
  const std::string found = watcher.answer();
  EXPECT_NE(found.find("[mesh-not-found]"), std::string::npos) << found;
  EXPECT_NE(found.find(" fixed, "), std::string::npos) << found;

  put_at_once(folder, "new.urdf", watched_arm(kTurned));
  EXPECT_NE(watcher.answer().find("error[joint-limit-inverted]"), std::string::npos);
}

TEST(Watch, AnArgumentThatIsNotThereIsWrongUse) {
  const Folder folder;
  EXPECT_EQ(folder.rigor("validate --watch none.sdf").exit, 2);
}

}  // namespace
}  // namespace rigor::test
