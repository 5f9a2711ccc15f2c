// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the parsers of the formats themselves say of a file, where they are installed: check_urdf of urdfdom
// (liburdfdom-tools) and `ign sdf -k` of libsdformat (ignition-tools), which reads URDF, too.
//
//   const std::string parser = test::kOfficialParsers[0];
//   if (test::is_installed(parser)) EXPECT_TRUE(test::accepts(parser, text, "robot.urdf"));

#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <rigor/process/program.h>

namespace rigor::test {

inline constexpr std::array<const char*, 2> kOfficialParsers{"check_urdf", "ign"};

inline process::ProgramResult run_parser(const std::string& parser, const std::string& path) {
  std::vector<std::string> words{parser};
  if (parser == "ign") words.insert(words.end(), {"sdf", "-k"});
  words.push_back(path);
  constexpr unsigned kSeconds = 20;  // check_urdf never ends on a loop of joints
  return process::run_program(words, {.wall_seconds = kSeconds});
}

inline bool is_installed(const std::string& parser) {
  const process::ProgramResult result = run_parser(parser, "/no/such/file");
  return result.end == process::ProgramResult::End::kExited &&
         (result.out + result.err).find("Unknown command") == std::string::npos;
}

/// Of a file of that name with these bytes, in a folder of its own.
inline bool accepts(const std::string& parser, const std::string& text, const std::string& name) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) /
      ("rigor_" + parser + '_' + std::to_string(::getpid()) + '_' + name);
  std::filesystem::create_directories(folder);
  const std::string path = (folder / name).string();
  std::ofstream(path, std::ios::binary) << text;
  const process::ProgramResult result = run_parser(parser, path);
  std::filesystem::remove_all(folder);
  return result.end == process::ProgramResult::End::kExited && result.exit_code == 0 &&
         (parser != "ign" || result.out.find("Valid.") != std::string::npos);
}

}  // namespace rigor::test
