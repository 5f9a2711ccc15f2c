// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is asked of a worker (workers.h), what it may take, and what came of it.
//
//   const Request request{.kind = "urdfdom.parse", .bytes = text, .limits = {.cpu_seconds = 2}};
//   const RequestResult result = workers.call(request);
//   if (result.end != RequestResult::End::kDone) say(describe(result, request.limits));

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace rigor::process {

struct RequestLimits {
  unsigned cpu_seconds = 60;
  /// Of address space, on top of what the worker has in use when the request comes. Not applied under the
  /// address sanitizer, which reserves terabytes.
  std::uint64_t memory_bytes = std::uint64_t{4} << 30U;
};

/// A request is also ended after this many wall seconds for each CPU second it may take: one that sleeps or
/// waits uses none. Ten leaves room for a machine that runs ten times what it has cores for.
inline constexpr unsigned kWallPerCpuSecond = 10;

struct Request {
  std::string_view kind;  ///< the name of a service of the worker (serve.h); outlives the request
  std::string bytes;
  RequestLimits limits;
};

struct RequestResult {
  enum class End : std::uint8_t {
    kDone,       ///< `bytes` is what the service gave
    kFailed,     ///< it threw; `bytes` is the exception's text
    kCrashed,    ///< the worker was killed by `signal`, or left by itself (0)
    kOutOfTime,  ///< over the CPU seconds, or the wall seconds that go with them (SIGALRM)
    kOutOfMemory,
    kNotStarted,  ///< there is no worker; `bytes` says why
  };
  End end = End::kNotStarted;
  int signal = 0;
  std::string bytes;
};

/// In the caller: what it answers to a question of the service. What it gives need not last longer than until
/// the next question.
using Answer = std::function<std::optional<std::string_view>(std::string_view question)>;

/// In the service: what its caller answers.
using Ask = std::function<std::optional<std::string>(std::string_view question)>;

/// Longer questions are not answered: the worker is ended as if it had crashed. A path has fewer bytes.
inline constexpr std::size_t kMaxQuestion = std::size_t{1} << 16U;

/// How a worker ended that a signal killed, or none (0), before it could say.
RequestResult ended_by(int signal);

RequestResult not_started(std::string why);

/// "crashed (segmentation fault)", "took more than 60 s of CPU time": for messages.
std::string describe(const RequestResult& result, const RequestLimits& limits);

}  // namespace rigor::process
