// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A worker whose services end in every way there is. For the tests of this folder.

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/process/exchange.h>
#include <rigor/process/launch.h>
#include <rigor/process/serve.h>

namespace rigor::process {
namespace {

/// The number that a request is.
std::size_t number(const std::string& bytes) { return std::stoul(bytes); }

[[noreturn]] void wait_for_ever() {
  while (true) ::pause();
}

[[noreturn]] void spin_for_ever() {
  std::atomic<std::size_t> spin{0};
  while (true) ++spin;
}

/// As many bytes as are asked for, which no simpler rule gives.
std::string noise(std::size_t size) {
  std::string bytes(size, '\0');
  std::uint32_t state = 1;
  for (char& byte : bytes)
    byte = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24U);
  return bytes;
}

/// A part of a result, more than a socket holds, comes through before the worker dies.
[[noreturn]] Reply die_while_writing() {
  constexpr int kSocket = STDERR_FILENO + 1;
  const std::string part(300'000, '\0');
  if (::write(kSocket, part.data(), part.size()) < 0) ::_exit(1);
  ::raise(SIGKILL);
  ::_exit(1);
}

std::string print() {
  std::fputs("out", stdout);
  std::fputs("err", stderr);
  std::fflush(nullptr);
  return {};
}

/// Services that give something.
std::vector<Service> sound_services() {
  return {
      {"echo", [](const std::string& bytes, const Ask&) -> Reply { return bytes; }},
      {"noise", [](const std::string& bytes, const Ask&) -> Reply { return noise(number(bytes)); }},
      {"process",
       [](const std::string&, const Ask&) -> Reply { return std::to_string(::getpid()); }},
      {"retire",
       [](const std::string&, const Ask&) -> Reply {
         return {std::to_string(::getpid()), Reply::Then::kRetire};
       }},
      {"ask",
       [](const std::string& bytes, const Ask& ask) -> Reply {
         return ask(bytes).value_or("no answer") + " to " + bytes;
       }},
      {"take",
       [](const std::string& bytes, const Ask&) -> Reply {
         return std::to_string(std::vector<char>(number(bytes)).size());
       }},
      {"use",
       [](const std::string& bytes, const Ask&) -> Reply {
         const auto begin = std::clock();
         while ((std::clock() - begin) * 1000 / CLOCKS_PER_SEC < std::stol(bytes)) continue;
         return std::string();
       }},
      {"hoard",
       [](const std::string& bytes, const Ask&) -> Reply {
         // Never given back: in pages of its own, all of them touched.
         char* kept = new char[number(bytes)];
         for (std::size_t i = 0; i < number(bytes); i += 4096) kept[i] = 1;
         return std::to_string(::getpid());
       }},
      {"print", [](const std::string&, const Ask&) -> Reply { return print(); }},
      {"is-open",
       [](const std::string& bytes, const Ask&) -> Reply {
         const bool open = ::fcntl(static_cast<int>(number(bytes)), F_GETFD) >= 0;
         return std::string(open ? "open" : "closed");
       }},
  };
}

/// Services that give nothing.
std::vector<Service> unsound_services() {
  return {
      {"throw",
       [](const std::string& bytes, const Ask&) -> Reply { throw std::runtime_error(bytes); }},
      {"throw-number", [](const std::string&, const Ask&) -> Reply { throw 7; }},
      {"bad-alloc", [](const std::string&, const Ask&) -> Reply { throw std::bad_alloc(); }},
      {"raise",
       [](const std::string& bytes, const Ask&) -> Reply {
         ::raise(static_cast<int>(number(bytes)));
         return std::string();
       }},
      {"leave", [](const std::string&, const Ask&) -> Reply { ::_exit(0); }},
      {"spin", [](const std::string&, const Ask&) -> Reply { spin_for_ever(); }},
      {"ask-and-wait",
       [](const std::string& bytes, const Ask& ask) -> Reply {
         ask(bytes.empty() ? std::to_string(::getpid()) : std::string(number(bytes), '?'));
         wait_for_ever();
       }},
      {"ask-and-spin",
       [](const std::string&, const Ask& ask) -> Reply {
         ask(std::to_string(::getpid()));
         spin_for_ever();
       }},
      {"wait", [](const std::string&, const Ask&) -> Reply { wait_for_ever(); }},
      {"die-while-writing", [](const std::string&, const Ask&) { return die_while_writing(); }},
  };
}

/// As a caller that is gone while its worker works: prints the worker's process.
int leave_an_orphan() {
  bool told = false;
  const Answer tell = [&](std::string_view process) -> std::optional<std::string_view> {
    std::fwrite(process.data(), 1, process.size(), stdout);
    std::fflush(stdout);
    told = true;
    return "";
  };
  auto started = WorkerProcess::start("/proc/self/exe");
  if (!std::holds_alternative<WorkerProcess>(started)) return 1;
  Exchange exchange({std::get<WorkerProcess>(std::move(started)), {}}, {.kind = "ask-and-spin"},
                    tell, Exchange::Clock::time_point::max());
  while (!told && !exchange.over()) {
    pollfd wanted = exchange.wanted();
    ::poll(&wanted, 1, -1);
    exchange.advance();
  }
  ::_exit(told ? 0 : 1);
}

}  // namespace
}  // namespace rigor::process

int main(int argc, char**) {
  if (argc > 1) return rigor::process::leave_an_orphan();
  std::vector<rigor::process::Service> services = rigor::process::sound_services();
  for (rigor::process::Service& one : rigor::process::unsound_services()) services.push_back(one);
  return rigor::process::serve(services);
}
