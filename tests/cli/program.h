// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the program in a temporary folder, as a user's script would.

#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace rigor::test {

struct Ran {
  int exit = -1;
  std::string out;
  std::string err;
};

/// A folder that is gone after the test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "rigor-cli-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name) const { return path_ + "/" + name; }

  void put(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << bytes;
  }

  std::string get(const std::string& name) const {
    std::ifstream stream(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// `rigor ARGUMENTS` in the folder, by the shell; `before` sets variables or feeds a pipe.
  Ran rigor(const std::string& arguments, const std::string& before = "") const {
    return run(before + " '" RIGOR_BINARY "' " + arguments);
  }

  /// Any command in the folder, by the shell.
  Ran run(const std::string& command) const {
    const Folder results;
    const std::string whole = "cd '" + path_ + "' && " + command + " >'" + results.path("out") +
                              "' 2>'" + results.path("err") + "'";
    const int status = std::system(whole.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, results.get("out"), results.get("err")};
  }

 private:
  std::string path_;
};

}  // namespace rigor::test
