// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One request on its way through a worker, seen by its caller: nothing in it waits, so that one thread may
// have many. For the files of this folder.
//
//   Exchange exchange(std::move(worker), std::move(request), answer);
//   while (!exchange.over()) {
//     poll(exchange.wanted());
//     exchange.advance();
//   }

#pragma once

#include <poll.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/process/launch.h>
#include <rigor/process/messages.h>
#include <rigor/process/request.h>

namespace rigor::process {

/// A worker between two requests.
struct IdleWorker {
  WorkerProcess process;
  std::string program;   ///< its path
  bool greeted = false;  ///< it has said its version
};

class Exchange {
 public:
  using Clock = std::chrono::steady_clock;

  /// The wall clock of a request that begins now.
  static Clock::time_point deadline_of(const RequestLimits& limits);

  /// `answer` outlives it.
  Exchange(IdleWorker worker, Request request, const Answer& answer, Clock::time_point deadline);
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  pollfd wanted() const;
  Clock::time_point deadline() const { return deadline_; }

  /// Sends and takes what can be without waiting, and ends the worker that is past its deadline. Questions are
  /// answered here; what an answer throws comes through.
  void advance();

  bool over() const { return result_.has_value(); }

  // When it is over:
  RequestResult take_result() { return *std::move(result_); }
  /// Nothing when it is not to be asked again.
  std::optional<IdleWorker> take_worker();

 private:
  /// Bytes to be sent, then those of the request or of an answer.
  struct Outgoing {
    std::string head;
    std::string_view body;
    std::size_t sent = 0;

    bool done() const { return sent == head.size() + body.size(); }
  };

  bool send_some();
  bool receive_some();
  std::size_t limit_of(const Message& message) const;
  void take_message();
  void take_result(const Message& message);
  void answer();
  void finish(RequestResult result);
  void died();

  IdleWorker worker_;
  Request request_;
  const Answer& answer_;
  Clock::time_point deadline_;
  Outgoing outgoing_;
  Message message_;
  std::size_t got_ = 0;  ///< of `message_`, then of its bytes
  std::string bytes_;    ///< room is made as they come: the size that was announced may be a lie
  bool reusable_ = false;
  std::optional<RequestResult> result_;
};

}  // namespace rigor::process
