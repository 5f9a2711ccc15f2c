// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/fork_helper.h>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/process/confinement.h>
#include <rigor/process/descriptor.h>
#include <rigor/process/messages.h>

namespace rigor::process {
namespace {

// ---- In the child

/// Nothing when the caller has none; without a caller nobody waits for a result.
std::optional<std::string> receive_from_caller() {
  Message message;
  std::string bytes;
  if (!receive_all(kKept, &message, sizeof message)) ::_exit(1);
  if (!receive_text(kKept, message.size, bytes)) ::_exit(1);
  if (message.kind == MessageKind::kNoAnswer) return std::nullopt;
  return bytes;
}

[[noreturn]] void serve_one(const ChildLimits& limits, const ForkServer::Work& work, int caller,
                            pid_t helper) {
  // Nobody else would end it, should the helper be killed.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != helper) ::_exit(1);
  keep_only(caller);
  reset_signals();
  const std::string request = receive_from_caller().value_or("");
  confine(limits);
  const ChildResult outcome = outcome_of([&] {
    return work(request, [](std::string_view question) {
      if (!send_message(kKept, MessageKind::kQuestion, question)) ::_exit(1);
      return receive_from_caller();
    });
  });
  send_message(kKept, MessageKind::kResult, outcome.bytes, static_cast<std::uint64_t>(outcome.end));
  ::_exit(0);
}

// ---- In the helper

class HelperLoop {
 public:
  HelperLoop(const std::function<void()>& prepare, const ForkServer::Work& work)
      : prepare_(prepare), work_(work) {
    sigset_t child;
    ::sigemptyset(&child);
    ::sigaddset(&child, SIGCHLD);
    ::sigprocmask(SIG_BLOCK, &child, nullptr);
    ends_ = Descriptor(::signalfd(-1, &child, SFD_CLOEXEC | SFD_NONBLOCK));
  }

  /// Until the caller is gone.
  void run() {
    if (ends_.number() < 0) return;
    while (true) {
      std::vector<pollfd> waiting{{kKept, POLLIN, 0}, {ends_.number(), POLLIN, 0}};
      // Told when its reader, the caller, is gone.
      for (const Served& child : children_) {
        waiting.push_back({child.killed ? -1 : child.pipe.number(), 0, 0});
      }
      if (::poll(waiting.data(), waiting.size(), -1) < 0) continue;
      for (std::size_t i = 0; i < children_.size(); ++i) {
        if (waiting[i + 2].revents != 0) end(children_[i]);
      }
      if (waiting[1].revents != 0) tell_ends();
      if (waiting[0].revents != 0 && !take_wish()) break;
    }
    for (Served& child : children_) {
      end(child);
      ::waitpid(child.pid, nullptr, 0);
    }
  }

 private:
  struct Served {
    pid_t pid;
    Descriptor pipe;
    bool killed = false;
  };

  static void end(Served& child) {
    ::kill(child.pid, SIGKILL);
    child.killed = true;
  }

  bool take_wish() {
    std::optional<Wish> wish = receive_wish(kKept);
    if (!wish || !prepare()) return false;
    const pid_t helper = ::getpid();
    const pid_t pid = ::fork();
    if (pid == 0) serve_one(wish->limits, work_, wish->socket.number(), helper);
    if (pid < 0) {
      tell(wish->pipe, {0, errno});
    } else {
      children_.push_back({pid, std::move(wish->pipe)});
    }
    return true;
  }

  /// What takes time is left until it is needed. A signal ends the helper when it takes too much.
  bool prepare() {
    if (prepared_) return true;
    ::alarm(ForkServer::kPrepareSeconds);
    const ChildResult result = outcome_of([this] { return prepare_(), std::string(); });
    ::alarm(0);
    prepared_ = result.end == ChildResult::End::kDone;
    return prepared_;
  }

  void tell_ends() {
    signalfd_siginfo some;
    while (::read(ends_.number(), &some, sizeof some) > 0) continue;
    int status = 0;
    for (pid_t gone = ::waitpid(-1, &status, WNOHANG); gone > 0;
         gone = ::waitpid(-1, &status, WNOHANG)) {
      const auto child = std::find_if(children_.begin(), children_.end(),
                                      [gone](const Served& one) { return one.pid == gone; });
      if (child == children_.end()) continue;
      tell(child->pipe, {WIFSIGNALED(status) ? WTERMSIG(status) : 0, 0});
      children_.erase(child);
    }
  }

  /// To a caller that is gone there is nothing to tell.
  static void tell(const Descriptor& pipe, ChildEnd end) {
    if (::write(pipe.number(), &end, sizeof end) < 0) return;
  }

  const std::function<void()>& prepare_;
  const ForkServer::Work& work_;
  bool prepared_ = false;
  Descriptor ends_{-1};
  std::vector<Served> children_;
};

}  // namespace

void be_helper(int socket, const std::function<void()>& prepare, const ForkServer::Work& work) {
  keep_only(socket);
  reset_signals();
  ::signal(SIGPIPE, SIG_IGN);
  HelperLoop(prepare, work).run();
  ::_exit(0);
}

}  // namespace rigor::process
