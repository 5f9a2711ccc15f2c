// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The process between a `ForkServer` and its children. For the files of this folder.
//
//   const pid_t pid = ::fork();
//   if (pid == 0) be_helper(socket, prepare, work);

#pragma once

#include <functional>

#include <rigor/process/fork_server.h>

namespace rigor::process {

/// Takes wishes for children from the socket until its other end is closed; then it ends, and whatever
/// children there are with it. It never waits for a child, so that one that hangs keeps no other waiting.
[[noreturn]] void be_helper(int socket, const std::function<void()>& prepare,
                            const ForkServer::Work& work);

}  // namespace rigor::process
