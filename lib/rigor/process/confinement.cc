// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/confinement.h>

#include <fcntl.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <exception>
#include <new>
#include <system_error>

#include <rigor/process/descriptor.h>

namespace rigor::process {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kAddressSanitizer = true;
#elif defined(__has_feature)
constexpr bool kAddressSanitizer = __has_feature(address_sanitizer);
#else
constexpr bool kAddressSanitizer = false;
#endif

void lower_limit(decltype(RLIMIT_CPU) resource, rlim_t soft, rlim_t hard) {
  rlimit limit = {};
  if (::getrlimit(resource, &limit) != 0) return;
  limit.rlim_max = std::min(limit.rlim_max, hard);
  limit.rlim_cur = std::min(limit.rlim_max, soft);
  ::setrlimit(resource, &limit);
}

/// Bytes of address space in use: the first number of statm, in pages (man 5 proc). 0 where there is
/// no such file.
rlim_t address_space() {
  const Descriptor file(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC));
  std::array<char, 64> text = {};
  const ssize_t size = ::read(file.number(), text.data(), text.size());
  rlim_t pages = 0;
  if (size > 0) std::from_chars(text.data(), text.data() + size, pages);
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

void keep_only(int descriptor) {
  if (::dup2(descriptor, kKept) < 0) ::_exit(1);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (int standard = STDIN_FILENO; standard <= STDERR_FILENO; ++standard) {
    nowhere >= 0 ? ::dup2(nowhere, standard) : ::close(standard);
  }
  // Another child's pipe among them would keep its reader waiting for this child. An old kernel
  // refuses; then the reader waits.
  ::close_range(kKept + 1, ~0U, 0);
}

void reset_signals() {
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

void confine(const ChildLimits& limits) {
  const unsigned seconds = std::max(limits.cpu_seconds, 1U);
  lower_limit(RLIMIT_CORE, 0, 0);
  lower_limit(RLIMIT_CPU, seconds, rlim_t{seconds} + 1);
  ::alarm(seconds * kWallPerCpuSecond);
  if (kAddressSanitizer) return;
  const rlim_t bytes = address_space() + limits.memory_bytes;
  lower_limit(RLIMIT_AS, bytes, bytes);
}

ChildResult outcome_of(const std::function<std::string()>& work) {
  try {
    return {ChildResult::End::kDone, 0, work()};
  } catch (const std::bad_alloc&) {
    return {ChildResult::End::kOutOfMemory, 0, {}};
  } catch (const std::exception& error) {
    return {ChildResult::End::kFailed, 0, error.what()};
  } catch (...) {
    return {ChildResult::End::kFailed, 0, "an exception of unknown type"};
  }
}

ChildResult ended_by(int signal) {
  const bool too_long = signal == SIGXCPU || signal == SIGALRM;
  return {too_long ? ChildResult::End::kOutOfTime : ChildResult::End::kCrashed, signal, {}};
}

ChildResult not_started(int error) {
  return {ChildResult::End::kNotStarted, 0, std::generic_category().message(error)};
}

}  // namespace rigor::process
