// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What posix_spawn is informed of a new program, freed again. For the files of this folder.
//
//   SpawnFiles files;
//   files.give(pipe, STDOUT_FILENO);
//   ::posix_spawnp(&pid, "git", files.get(), SpawnAttributes().get(), words, environ);

#pragma once

#include <fcntl.h>
#include <spawn.h>

#include <csignal>

namespace rigor::process {

/// Its descriptors. It has no others than those that it is given.
class SpawnFiles {
 public:
  SpawnFiles() { ::posix_spawn_file_actions_init(&actions_); }
  ~SpawnFiles() { ::posix_spawn_file_actions_destroy(&actions_); }
  SpawnFiles(const SpawnFiles&) = delete;
  SpawnFiles& operator=(const SpawnFiles&) = delete;

  /// In the order of the calls: a descriptor that is still to be given must not have a number that was given.
  void give(int descriptor, int number) {
    ::posix_spawn_file_actions_adddup2(&actions_, descriptor, number);
  }
  void give_nothing(int number) {
    ::posix_spawn_file_actions_addopen(&actions_, number, "/dev/null", O_RDWR, 0);
  }
  void close_from(int number) { ::posix_spawn_file_actions_addclosefrom_np(&actions_, number); }

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

/// Its signals: signals that this process ignores or blocks would stay so.
class SpawnAttributes {
 public:
  SpawnAttributes() {
    sigset_t all;
    sigset_t none;
    ::sigfillset(&all);
    ::sigemptyset(&none);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  }
  ~SpawnAttributes() { ::posix_spawnattr_destroy(&attributes_); }
  SpawnAttributes(const SpawnAttributes&) = delete;
  SpawnAttributes& operator=(const SpawnAttributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

}  // namespace rigor::process
