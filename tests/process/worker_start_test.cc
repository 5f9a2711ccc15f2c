// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Finding and starting a worker's program, and what is said when that fails.

#include <rigor/process/worker_path.h>

#include <sys/resource.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <rigor/process/messages.h>
#include <rigor/process/workers.h>

#include "cli/program.h"
#include "process/workers_fixture.h"

namespace rigor::process {
namespace {

using StartEnd = RequestResult::End;

std::string words_of(const RequestResult& result) {
  EXPECT_EQ(result.end, StartEnd::kNotStarted);
  return describe(result, {});
}

RequestResult echo_of(const std::string& program) {
  return Workers(program).call({.kind = "echo", .bytes = "x"});
}

void put_program(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
}

TEST(WorkerStart, AMissingProgramIsNamed) {
  EXPECT_EQ(words_of(echo_of("/nowhere/rigor-worker")),
            "could not be started: /nowhere/rigor-worker: No such file or directory");
}

TEST(WorkerStart, AProgramThatIsNoWorkerIsNotBlamedOnTheRequest) {
  EXPECT_EQ(words_of(echo_of("/bin/true")),
            "could not be started: /bin/true ended before it could serve");
}

TEST(WorkerStart, AWorkerOfAnotherVersionIsRefused) {
  const test::Folder folder;
  const std::string program = folder.path("rigor-worker");
  const std::string version = "rigor-worker 0.0.0";
  const Message hello{MessageKind::kHello, version.size()};
  std::ofstream(program + ".hello")
      .write(reinterpret_cast<const char*>(&hello), sizeof hello)
      .write(version.data(), static_cast<std::streamsize>(version.size()));
  put_program(program, "#!/bin/sh\nexec cat '" + program + ".hello' >&3\n");
  EXPECT_EQ(words_of(echo_of(program)), "could not be started: " + program +
                                            " is not the worker of this version, " +
                                            std::string(worker_version()));
}

TEST(WorkerStart, WithoutDescriptorsThereIsNone) {
  const Workers workers{RIGOR_TEST_WORKER};
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{0, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  const RequestResult alone = workers.call({.kind = "echo"});
  int left = 3;
  int ended = 0;
  workers.feed(
      2, [&] { return left-- > 0 ? std::optional(Request{.kind = "echo"}) : std::nullopt; },
      [&](std::size_t, const RequestResult& result) {
        ended += result.end == StartEnd::kNotStarted;
      });
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_EQ(words_of(alone), "could not be started: " RIGOR_TEST_WORKER ": Too many open files");
  EXPECT_EQ(ended, 3);
  EXPECT_EQ(workers.call({.kind = "echo", .bytes = "x"}).bytes, "x");
}

TEST(WorkerStart, ItIsFoundBesideTheProgramOrInLibexec) {
  const test::Folder folder;
  const std::string bin = folder.path("bin");
  std::filesystem::create_directories(bin);
  std::filesystem::create_directories(folder.path("libexec"));
  const WorkerProgram none = find_worker_from(bin, "relative:/opt/x/bin:");
  EXPECT_FALSE(none.path);
  ASSERT_EQ(none.looked_for.size(), 3U);
  EXPECT_EQ(none.looked_for[0], bin + "/rigor-worker");
  EXPECT_EQ(none.looked_for[1], folder.path("libexec") + "/rigor-worker");

  std::ofstream(none.looked_for[0]) << "no program";
  EXPECT_FALSE(find_worker_from(bin, "relative:/opt/x/bin:").path);
  put_program(none.looked_for[1], "");
  EXPECT_EQ(find_worker_from(bin, "relative:/opt/x/bin:").path, none.looked_for[1]);
  put_program(none.looked_for[0], "");
  EXPECT_EQ(find_worker_from(bin, "relative:/opt/x/bin:").path, none.looked_for[0]);
}

TEST(WorkerStart, ItIsFoundByPathWhereRigorIsInstalled) {
  const test::Folder folder;
  folder.put("libexec/rigor-worker", "");
  put_program(folder.path("libexec/rigor-worker"), "");
  EXPECT_EQ(find_worker_from("/nowhere", "relative::/nowhere/bin:" + folder.path("bin") + ":").path,
            folder.path("libexec/rigor-worker"));
}

TEST(WorkerStart, TheTestsFindTheLibrarysOwn) {
  const WorkerProgram found = find_worker();
  ASSERT_TRUE(found.path);
  EXPECT_EQ(Workers().call({.kind = "no such service"}).end, StartEnd::kFailed);
}

TEST(WorkerStart, TheFileOfAnAddressIsInTheMaps) {
  const char* maps =
      "00400000-00452000 r-xp 00000000 08:02 173521      /usr/bin/dbus-daemon\n"
      "00e03000-00e24000 rw-p 00000000 00:00 0           [heap]\n"
      "35b1800000-35b1820000 r-xp 00000000 08:02 135522  /usr/lib64/a b.so\n";
  EXPECT_EQ(file_mapped_at(maps, 0x400000), "/usr/bin/dbus-daemon");
  EXPECT_EQ(file_mapped_at(maps, 0x451fff), "/usr/bin/dbus-daemon");
  EXPECT_EQ(file_mapped_at(maps, 0x452000), std::nullopt);
  EXPECT_EQ(file_mapped_at(maps, 0xe03000), std::nullopt);
  EXPECT_EQ(file_mapped_at(maps, 0x35b1800001), "/usr/lib64/a b.so");
  EXPECT_EQ(file_mapped_at("", 1), std::nullopt);
}

}  // namespace
}  // namespace rigor::process
