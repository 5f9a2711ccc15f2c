// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/serve.h>

#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>

#include <rigor/process/confinement.h>
#include <rigor/process/launch.h>
#include <rigor/process/messages.h>

namespace rigor::process {
namespace {

using End = RequestResult::End;

/// Nobody waits for what this process does once the caller's end is closed. Also a signal's handler.
void leave_without_caller(int /*signal*/ = 0) {
  const int error = errno;
  pollfd caller{kWorkerSocket, POLLRDHUP, 0};
  if (::poll(&caller, 1, 0) > 0) ::_exit(0);
  errno = error;
}

/// The kernel signals when the socket changes. PR_SET_PDEATHSIG would not do: it is sent when the thread
/// that started this process ends.
void end_with_caller() {
  struct sigaction action = {};
  action.sa_handler = leave_without_caller;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGIO, &action, nullptr);
  ::fcntl(kWorkerSocket, F_SETOWN, ::getpid());
  ::fcntl(kWorkerSocket, F_SETFL, ::fcntl(kWorkerSocket, F_GETFL) | O_ASYNC);
}

/// Without a caller there is nothing to do.
Message receive_message() {
  Message message;
  if (!receive_all(kWorkerSocket, &message, sizeof message)) ::_exit(0);
  return message;
}

/// The kernel does not signal to one that waits here that the caller is gone, once it has sent something.
std::string receive_bytes(std::uint64_t size) {
  std::string bytes(size, '\0');
  if (!receive_all(kWorkerSocket, bytes.data(), bytes.size())) ::_exit(0);
  leave_without_caller();
  return bytes;
}

void send_to_caller(const Message& message, std::string_view bytes) {
  if (!send_message(kWorkerSocket, message, bytes)) ::_exit(0);
}

std::optional<std::string> ask_caller(std::string_view question) {
  send_to_caller({MessageKind::kQuestion, question.size()}, question);
  const Message answer = receive_message();
  std::string bytes = receive_bytes(answer.size);
  if (answer.kind != MessageKind::kAnswer) return std::nullopt;
  return bytes;
}

/// A result without bytes is a failure's.
struct Served {
  End end = End::kDone;
  Reply reply{{}, Reply::Then::kRetire};
};

Served outcome_of(const Handler& handle) {
  try {
    const Message message = receive_message();
    return {End::kDone, handle(receive_bytes(message.size), ask_caller)};
  } catch (const std::bad_alloc&) {
    return {End::kOutOfMemory};
  } catch (const std::exception& error) {
    return {End::kFailed, {error.what(), Reply::Then::kRetire}};
  } catch (...) {
    return {End::kFailed, {"an exception of unknown type", Reply::Then::kRetire}};
  }
}

bool keeps_too_much() {
  if (resident_in_use() <= kMaxKept) return false;
  ::malloc_trim(0);
  return resident_in_use() > kMaxKept;
}

/// False when the worker is not to be asked again.
bool serve_one(const std::vector<Service>& services, const Message& message) {
  RequestHead head;
  if (message.kind != MessageKind::kRequest || message.size < sizeof head ||
      message.size > sizeof head + kMaxName) {
    ::_exit(1);
  }
  const std::string text = receive_bytes(message.size);
  std::memcpy(&head, text.data(), sizeof head);
  const std::string_view kind = std::string_view(text).substr(sizeof head);
  confine({static_cast<unsigned>(head.cpu_seconds), head.memory_bytes});

  const auto known = std::find_if(services.begin(), services.end(),
                                  [kind](const Service& service) { return service.kind == kind; });
  const Served served = outcome_of([&](const std::string& bytes, const Ask& ask) -> Reply {
    if (known == services.end())
      throw std::invalid_argument("no service is named " + std::string(kind));
    return known->handle(bytes, ask);
  });
  const bool retires = served.reply.then == Reply::Then::kRetire || keeps_too_much();
  send_to_caller({MessageKind::kResult, served.reply.bytes.size(),
                  static_cast<std::uint32_t>(served.end), retires ? 1U : 0U},
                 served.reply.bytes);
  return !retires;
}

}  // namespace

int serve(const std::vector<Service>& services) {
  reset_signals();
  confine({});
  if (::fcntl(kWorkerSocket, F_GETFL) < 0) return 1;
  end_with_caller();
  const std::string_view version = worker_version();
  if (!send_message(kWorkerSocket, {MessageKind::kHello, version.size()}, version)) return 1;
  while (serve_one(services, receive_message())) continue;
  return 0;
}

}  // namespace rigor::process
