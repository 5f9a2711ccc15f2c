// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// In which order a user's file is replaced, as strace sees it, and what comes of a disk that fails, which
// strace makes it do.

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <cli/program.h>

namespace rigor::test {
namespace {

class AtomicFile : public ::testing::Test {
 protected:
  void SetUp() override {
    // It is absent, or a container forbids ptrace.
    if (std::system("strace -o /dev/null true >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "strace is not installed, or is not permitted to trace";
    }
    folder_.put("part.jsonl", kResult);
    folder_.put("into/all.jsonl", "old\n");
  }

  /// Replaces into/all.jsonl. The calls go to calls.txt, file descriptors with their paths.
  Ran replace(const std::string& options = "") const {
    return folder_.rigor("merge part.jsonl -o into/all.jsonl",
                         "ASAN_OPTIONS=detect_leaks=0 strace -f -y -o calls.txt " + options);
  }

  std::size_t files_in_folder() const {
    const std::filesystem::directory_iterator files(folder_.path("into"));
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

  static constexpr const char* kResult = "{\"case\":{\"index\":0,\"of\":1}}\n";
  const Folder folder_;
};

TEST_F(AtomicFile, IsOnTheDiskBeforeItHasItsName) {
  const Ran ran = replace("-e trace=write,fsync,close,renameat");
  ASSERT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(folder_.get("into/all.jsonl"), kResult);
  const std::string calls = folder_.get("calls.txt");
  const std::string temporary = "into/all.jsonl.";
  std::size_t at = 0;
  const auto next = [&](const std::string& call, const std::string& on) {
    for (at = calls.find(call, at); at != std::string::npos; at = calls.find(call, at + 1)) {
      const std::string line = calls.substr(at, calls.find('\n', at) - at);
      if (line.find(on) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(next("write(", temporary)) << calls;
  EXPECT_TRUE(next("fsync(", temporary)) << calls;
  EXPECT_TRUE(next("close(", temporary)) << calls;
  EXPECT_TRUE(next("renameat(", "\"all.jsonl.")) << calls;
  EXPECT_TRUE(next("fsync(", "/into>")) << calls;
}

TEST_F(AtomicFile, StaysWhenTheDiskFails) {
  // How many files are closed up to the one that is written.
  ASSERT_EQ(replace("-e trace=close").exit, 0);
  std::istringstream calls(folder_.get("calls.txt"));
  int closed = 0;
  for (std::string line; std::getline(calls, line);) {
    ++closed;
    if (line.find("into/all.jsonl.") != std::string::npos) break;
  }
  folder_.put("into/all.jsonl", "old\n");
  // A full disk is reported when the bytes are synchronized; NFS tells it when the file is closed.
  for (const std::string& failure :
       {std::string("fsync:error=ENOSPC"), "close:error=EDQUOT:when=" + std::to_string(closed)}) {
    const Ran ran = replace("-e inject=" + failure);
    EXPECT_EQ(ran.exit, 2) << failure << ran.err;
    EXPECT_NE(ran.err.find("cannot be written"), std::string::npos) << failure << ran.err;
    EXPECT_EQ(folder_.get("into/all.jsonl"), "old\n") << failure;
    EXPECT_EQ(files_in_folder(), 1U) << failure << ": no temporary file is left";
  }
}

TEST_F(AtomicFile, AFolderThatCannotBeSynchronizedIsNoFailure) {
  // The second fsync is the folder's.
  const Ran ran = replace("-e inject=fsync:error=EINVAL:when=2+");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(folder_.get("into/all.jsonl"), kResult);
}

TEST(ReplacedFile, IsRefusedWhenItIsReadOnly) {
  const Folder folder;
  folder.put("a.urdf", "<robot name=\"r\" ><link name=\"a\"/></robot>\n");
  const std::string before = folder.get("a.urdf");
  std::filesystem::permissions(folder.path("a.urdf"), std::filesystem::perms::owner_read);
  for (const std::string path : {"a.urdf", "."}) {
    const Ran ran = folder.rigor("fmt " + path);
    EXPECT_EQ(ran.exit, 2) << path;
    EXPECT_NE(ran.err.find("a.urdf: is read-only"), std::string::npos) << ran.err;
    EXPECT_EQ(folder.get("a.urdf"), before);
  }
}

}  // namespace
}  // namespace rigor::test
