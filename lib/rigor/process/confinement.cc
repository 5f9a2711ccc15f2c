// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/confinement.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <string>

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

/// The hard limit stays, so that the next request may have more.
void limit_to(decltype(RLIMIT_AS) resource, rlim_t soft) {
  rlimit limit = {};
  if (::getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_max, soft);
  ::setrlimit(resource, &limit);
}

/// A timer and not RLIMIT_CPU, which counts from the start of the process and in whole seconds.
void limit_cpu_time(unsigned seconds) {
  itimerval time = {};
  time.it_value.tv_sec = static_cast<time_t>(seconds);
  ::setitimer(ITIMER_PROF, &time, nullptr);
}

/// Empty where there is no such file.
std::string statm() {
  const Descriptor file(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC));
  std::array<char, 128> text = {};
  const ssize_t size = ::read(file.number(), text.data(), text.size());
  return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

/// Zero when the text does not begin with a number.
std::uint64_t bytes_of_pages(std::string_view text) {
  std::uint64_t pages = 0;
  std::from_chars(text.data(), text.data() + text.size(), pages);
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

std::uint64_t address_space_in(std::string_view statm) {
  const std::uint64_t bytes = bytes_of_pages(statm);
  return bytes > 0 ? bytes : kAssumedAddressSpace;
}

std::uint64_t address_space_in_use() { return address_space_in(statm()); }

std::uint64_t resident_in_use() {
  const std::string text = statm();
  const std::size_t blank = text.find(' ');
  return blank == std::string::npos ? 0 : bytes_of_pages(std::string_view(text).substr(blank + 1));
}

void reset_signals() {
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

void confine(const RequestLimits& limits) {
  limit_to(RLIMIT_CORE, 0);
  limit_cpu_time(std::max(limits.cpu_seconds, 1U));
  if (kAddressSanitizer) return;
  limit_to(RLIMIT_AS, address_space_in_use() + limits.memory_bytes);
}

}  // namespace rigor::process
