// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/request.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <utility>

namespace rigor::process {
namespace {

using End = RequestResult::End;

/// "segmentation fault": the C library's words, in any locale in English, but for the capital.
std::string signal_name(int signal) {
  const char* known = ::sigdescr_np(signal);
  std::string name = known ? known : "signal " + std::to_string(signal);
  const bool word = name.size() > 1 && name[1] >= 'a' && name[1] <= 'z';
  if (word && name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
  return name;
}

std::string in_units(std::uint64_t bytes) {
  constexpr std::uint64_t kMiB = 1U << 20U;
  constexpr std::uint64_t kGiB = 1U << 30U;
  if (bytes >= kGiB && bytes % kGiB == 0) return std::to_string(bytes / kGiB) + " GiB";
  return std::to_string(bytes / kMiB) + " MiB";
}

}  // namespace

RequestResult ended_by(int signal) {
  // SIGXCPU is a limit that was there before; SIGALRM represents the caller's clock.
  const bool too_long = signal == SIGPROF || signal == SIGXCPU || signal == SIGALRM;
  return {too_long ? End::kOutOfTime : End::kCrashed, signal, {}};
}

RequestResult not_started(std::string why) { return {End::kNotStarted, 0, std::move(why)}; }

std::string describe(const RequestResult& result, const RequestLimits& limits) {
  const unsigned seconds = std::max(limits.cpu_seconds, 1U);
  switch (result.end) {
    case End::kDone: return "ended well";
    case End::kFailed: return "failed: " + result.bytes;
    case End::kCrashed:
      return result.signal == 0 ? "ended before its time"
                                : "crashed (" + signal_name(result.signal) + ")";
    case End::kOutOfTime:
      if (result.signal == SIGALRM) {
        return "did not end within " + std::to_string(seconds * kWallPerCpuSecond) + " s";
      }
      return "took more than " + std::to_string(seconds) + " s of CPU time";
    case End::kOutOfMemory:
      return "needed more than " + in_units(limits.memory_bytes) + " of memory";
    case End::kNotStarted: return "could not be started: " + result.bytes;
  }
  return {};
}

}  // namespace rigor::process
