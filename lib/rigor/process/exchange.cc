// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/exchange.h>

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

namespace rigor::process {
namespace {

using End = RequestResult::End;

template <class T>
void append_raw(std::string& text, const T& value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// All that goes before the request's bytes.
std::string head_of(const Request& request) {
  std::string head;
  append_raw(head, Message{MessageKind::kRequest, sizeof(RequestHead) + request.kind.size()});
  append_raw(head, RequestHead{request.limits.memory_bytes, request.limits.cpu_seconds});
  head += request.kind;
  append_raw(head, Message{MessageKind::kBytes, request.bytes.size()});
  return head;
}

/// Whether a call that failed may be made again later.
bool is_for_later() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

Exchange::Clock::time_point Exchange::deadline_of(const RequestLimits& limits) {
  const unsigned seconds = std::max(limits.cpu_seconds, 1U) * kWallPerCpuSecond;
  return Clock::now() + std::chrono::seconds(seconds);
}

Exchange::Exchange(IdleWorker worker, Request request, const Answer& answer,
                   Clock::time_point deadline)
    : worker_(std::move(worker)),
      request_(std::move(request)),
      answer_(answer),
      deadline_(deadline),
      outgoing_{head_of(request_), request_.bytes} {}

pollfd Exchange::wanted() const {
  const int events = outgoing_.done() ? POLLIN : POLLIN | POLLOUT;
  return {worker_.process.socket(), static_cast<short>(events), 0};
}

std::optional<IdleWorker> Exchange::take_worker() {
  if (!reusable_) return std::nullopt;
  return std::move(worker_);
}

void Exchange::advance() {
  while (!over() && (send_some() || receive_some())) continue;
  if (over() || Clock::now() < deadline_) return;
  worker_.process.end();
  finish(ended_by(SIGALRM));
}

/// False when nothing could be sent.
bool Exchange::send_some() {
  if (outgoing_.done()) return false;
  const std::string_view head = outgoing_.head;
  const std::size_t in_head = std::min(outgoing_.sent, head.size());
  const std::size_t in_body = outgoing_.sent - in_head;
  std::array<iovec, 2> parts{{
      {const_cast<char*>(head.data() + in_head), head.size() - in_head},
      {const_cast<char*>(outgoing_.body.data() + in_body), outgoing_.body.size() - in_body},
  }};
  msghdr message = {};
  message.msg_iov = parts.data();
  message.msg_iovlen = parts.size();
  const ssize_t sent = ::sendmsg(worker_.process.socket(), &message, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent > 0) outgoing_.sent += static_cast<std::size_t>(sent);
  // One that listens no more may have said why.
  if (sent < 0 && !is_for_later()) outgoing_ = {};
  return sent > 0;
}

/// False when there was nothing.
bool Exchange::receive_some() {
  constexpr std::size_t kFirst = std::size_t{1} << 20U;
  char* into = reinterpret_cast<char*>(&message_) + got_;
  std::size_t room = sizeof message_ - got_;
  if (got_ >= sizeof message_) {
    const std::size_t known = got_ - sizeof message_;
    if (known == bytes_.size()) {
      bytes_.resize(std::min<std::size_t>(message_.size, std::max(kFirst, 2 * known)));
    }
    into = bytes_.data() + known;
    room = bytes_.size() - known;
  }
  const ssize_t got = ::recv(worker_.process.socket(), into, room, MSG_DONTWAIT);
  if (got < 0 && is_for_later()) return false;
  if (got <= 0) {
    died();
    return false;
  }
  got_ += static_cast<std::size_t>(got);
  if (got_ == sizeof message_ && message_.size > limit_of(message_)) {
    worker_.process.end();
    finish(ended_by(0));
  } else if (got_ >= sizeof message_ && got_ - sizeof message_ == message_.size) {
    take_message();
    got_ = 0;
    bytes_.clear();
  }
  return true;
}

/// A result was in the worker's memory as a whole.
std::size_t Exchange::limit_of(const Message& message) const {
  switch (message.kind) {
    case MessageKind::kHello: return kMaxName;
    case MessageKind::kQuestion: return kMaxQuestion;
    case MessageKind::kResult: return request_.limits.memory_bytes;
    default: return 0;
  }
}

void Exchange::take_message() {
  if (!worker_.greeted) {
    worker_.greeted = message_.kind == MessageKind::kHello && bytes_ == worker_version();
    if (!worker_.greeted) {
      finish(not_started(worker_.program + " is not the worker of this version, " +
                         std::string(worker_version())));
    }
    return;
  }
  switch (message_.kind) {
    case MessageKind::kQuestion: return answer();
    case MessageKind::kResult: return take_result(message_);
    default: return finish(ended_by(0));  // what no sound worker says
  }
}

void Exchange::answer() {
  const std::optional<std::string_view> found = answer_(bytes_);
  outgoing_ = {{}, found.value_or(std::string_view())};
  append_raw(outgoing_.head,
             Message{found ? MessageKind::kAnswer : MessageKind::kNoAnswer, outgoing_.body.size()});
}

void Exchange::take_result(const Message& message) {
  const auto end = static_cast<End>(message.end);
  const bool own = end == End::kDone || end == End::kFailed || end == End::kOutOfMemory;
  if (!own || message.end != static_cast<std::uint32_t>(end)) return finish(ended_by(0));
  reusable_ = message.retires == 0 && outgoing_.done();
  finish({end, 0, std::move(bytes_)});
}

void Exchange::died() {
  const int signal = worker_.process.end();
  // Nothing was read by then, so it is no fault of what was asked.
  if (!worker_.greeted)
    return finish(not_started(worker_.program + " ended before it could serve"));
  finish(ended_by(signal));
}

void Exchange::finish(RequestResult result) { result_ = std::move(result); }

}  // namespace rigor::process
