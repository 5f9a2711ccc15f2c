// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/fork_server.h>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <mutex>
#include <optional>
#include <utility>

#include <rigor/process/confinement.h>
#include <rigor/process/descriptor.h>
#include <rigor/process/fork_helper.h>
#include <rigor/process/messages.h>

namespace rigor::process {
namespace {

/// The child's end of a socket goes away, this one stays.
struct Ends {
  Descriptor own{-1};
  Descriptor others{-1};
};

std::optional<Ends> make_socket(int type) {
  std::array<int, 2> ends = {};
  if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0) return std::nullopt;
  return Ends{Descriptor(ends[0]), Descriptor(ends[1])};
}

std::optional<Ends> make_pipe() {
  std::array<int, 2> ends = {};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  return Ends{Descriptor(ends[0]), Descriptor(ends[1])};
}

/// A child that said what no sound one says.
ChildResult damaged() { return ended_by(0); }

ChildResult result_in(const Message& message, std::string bytes) {
  const auto end = static_cast<ChildResult::End>(message.end);
  const bool own = end == ChildResult::End::kDone || end == ChildResult::End::kFailed ||
                   end == ChildResult::End::kOutOfMemory;
  return own && message.end == static_cast<std::uint64_t>(end)
             ? ChildResult{end, 0, std::move(bytes)}
             : damaged();
}

/// Talks with the child until it has said its last; nothing when it ended without.
std::optional<ChildResult> talk(int child, const ChildLimits& limits, const std::string& request,
                                const ForkServer::Answer& answer) {
  if (!send_message(child, MessageKind::kRequest, request)) return std::nullopt;
  Message message;
  while (receive_all(child, &message, sizeof message)) {
    const bool is_question = message.kind == MessageKind::kQuestion;
    if (!is_question && message.kind != MessageKind::kResult) return damaged();
    // A result was in the child's memory as a whole.
    if (message.size > (is_question ? ForkServer::kMaxQuestion : limits.memory_bytes)) {
      return damaged();
    }
    std::string bytes;
    if (!receive_text(child, message.size, bytes)) return std::nullopt;
    if (!is_question) return result_in(message, std::move(bytes));
    const std::optional<std::string_view> found = answer(bytes);
    const MessageKind kind = found ? MessageKind::kAnswer : MessageKind::kNoAnswer;
    if (!send_message(child, kind, found.value_or(""))) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

class ForkServer::Helper {
 public:
  Helper(const std::function<void()>& prepare, const Work& work) {
    std::optional<Ends> ends = make_socket(SOCK_SEQPACKET);
    if (!ends) return;
    const pid_t pid = ::fork();
    if (pid == 0) be_helper(ends->others.number(), prepare, work);
    if (pid < 0) return;
    pid_ = pid;
    socket_ = std::move(ends->own);
  }
  ~Helper() {
    socket_.close();  // which ends it, and all of its children
    while (pid_ > 0 && ::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;

  /// Nothing when the helper is gone.
  std::optional<ChildResult> run(const ChildLimits& limits, const std::string& request,
                                 const Answer& answer) const {
    if (socket_.number() < 0) return std::nullopt;
    std::optional<Ends> child = make_socket(SOCK_STREAM);
    if (!child) return not_started(errno);
    std::optional<Ends> end = make_pipe();
    if (!end) return not_started(errno);
    {
      const Wish wish{limits, std::move(child->others), std::move(end->others)};
      if (!send_wish(socket_.number(), wish)) return std::nullopt;
    }
    std::optional<ChildResult> result = talk(child->own.number(), limits, request, answer);
    // One that talks nonsense may go on for long; the helper ends it when nobody waits.
    if (result && result->end == ChildResult::End::kCrashed) return result;
    child->own.close();
    ChildEnd how;
    const bool told = receive_all(end->own.number(), &how, sizeof how);
    if (result) return result;
    if (!told) return std::nullopt;
    return how.error != 0 ? not_started(how.error) : ended_by(how.signal);
  }

 private:
  pid_t pid_ = -1;
  Descriptor socket_{-1};
};

struct ForkServer::State {
  std::once_flag started;
  std::optional<Helper> helper;
};

ForkServer::ForkServer(std::function<void()> prepare, Work work)
    : prepare_(std::move(prepare)), work_(std::move(work)), state_(std::make_unique<State>()) {}

ForkServer::~ForkServer() = default;

const ForkServer::Helper& ForkServer::helper() const {
  std::call_once(state_->started, [this] { state_->helper.emplace(prepare_, work_); });
  return *state_->helper;
}

ChildResult ForkServer::run(const ChildLimits& limits, const std::string& request,
                            const Answer& answer) const {
  if (std::optional<ChildResult> result = helper().run(limits, request, answer)) return *result;
  return run_in_child(limits, [&] {
    return work_(request, [&](std::string_view question) -> std::optional<std::string> {
      const std::optional<std::string_view> found = answer(question);
      return found ? std::optional<std::string>(*found) : std::nullopt;
    });
  });
}

}  // namespace rigor::process
