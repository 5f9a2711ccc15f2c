// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Workers: programs that do what may crash, hang or eat memory, each in a process of its own, so that only the
// file that it was at is to blame.
//
//   const Workers workers;
//   const RequestResult result = workers.call({.kind = mesh::kImportScene, .bytes = path},
//                                             [&](std::string_view name) { return find(name); });
//   if (result.end != RequestResult::End::kDone) say(describe(result, limits));
//
// A worker is executed when there is a request and none is idle, serves one request at a time under the limits
// of each, and is kept for the next: there are as many as requests were under way at once. One that dies or
// overstays is replaced. This process is never forked, so it may have any threads.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/process/request.h>

namespace rigor::process {

class Workers {
 public:
  /// Of the program that is found with the library (worker_path.h). Nothing is looked for or started yet.
  Workers();
  /// Of the program at this path.
  explicit Workers(std::string program);
  /// Ends all of them. No request is under way.
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// How much memory requests of a kind get from now on, in place of what they ask for. Before the first
  /// request.
  void set_memory(std::string_view kind, std::uint64_t bytes) {
    memory_[std::string(kind)] = bytes;
  }

  /// The limits of a request of that kind which asks for these.
  RequestLimits limits_of(std::string_view kind, RequestLimits asked) const {
    const auto found = memory_.find(kind);
    if (found != memory_.end()) asked.memory_bytes = found->second;
    return asked;
  }

  /// Blocks until the request is done or its worker gone, but for `answer`, which is called here. What
  /// `answer` throws ends the worker. Without a program the result is kNotStarted, and says where it was
  /// looked for. Safe across threads.
  RequestResult call(Request request, const Answer& answer) const;
  RequestResult call(Request request) const;

  /// Many requests, at most `jobs` at a time, of which some are known only when others have ended. `next`
  /// gives one, or nothing when there is none for now; `ended` is told the result of each as soon as it is
  /// there, with its number in the order that `next` gave them. Both are called here, and no questions are
  /// answered. Returns when nothing is under way and there is none.
  void feed(unsigned jobs, const std::function<std::optional<Request>()>& next,
            const std::function<void(std::size_t, RequestResult)>& ended) const;

 private:
  class Pool;
  class Underway;
  std::map<std::string, std::uint64_t, std::less<>> memory_;  // bytes, by kind
  std::unique_ptr<Pool> pool_;
};

}  // namespace rigor::process
