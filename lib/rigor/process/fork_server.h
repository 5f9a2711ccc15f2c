// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Many children of one kind, each as cheap as it can be. A fork costs by the memory that its parent
// uses by then, and a library that is opened in a child is opened again in the next. So one helper
// process is forked when the first child is needed; it opens the library, and every child is forked
// from it.
//
//   const ForkServer server(open_library, [](const std::string& path, const ForkServer::Ask& ask) {
//     return import(ask(path).value(), ask("materials.mtl"));  // in a child
//   });
//   ChildResult result = server.run(limits, path, [&](std::string_view name) {
//     return find(name);  // here
//   });
//
// A child ends in all the ways that one of `run_in_child` does, under the same limits. Should the
// helper itself be gone, children are forked from here.

#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/process/child.h>

namespace rigor::process {

class ForkServer {
 public:
  /// In the child: what its caller answers.
  using Ask = std::function<std::optional<std::string>(std::string_view question)>;
  /// In the caller; what it gives need not last longer than until the next question.
  using Answer = std::function<std::optional<std::string_view>(std::string_view question)>;
  using Work = std::function<std::string(const std::string& request, const Ask& ask)>;

  /// Longer questions are not answered: the child is ended as if it had crashed. A path has fewer.
  static constexpr std::size_t kMaxQuestion = std::size_t{1} << 16U;
  /// So many seconds `prepare` may take, by the clock; then there is no helper.
  static constexpr unsigned kPrepareSeconds = 60;

  /// Nothing is started. `prepare` is called once, in the helper, before the first child; `work` in each
  /// child. Both see this process as it was when the helper was started, and change nothing in it.
  ForkServer(std::function<void()> prepare, Work work);
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  /// Starts the helper now, before this process has more memory or threads.
  void start() const { helper(); }

  /// Blocks until the child is gone, but for `answer`, which is called here. What `answer` throws ends
  /// the child. Safe across threads.
  ChildResult run(const ChildLimits& limits, const std::string& request,
                  const Answer& answer) const;

 private:
  class Helper;
  const Helper& helper() const;

  std::function<void()> prepare_;
  Work work_;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rigor::process
