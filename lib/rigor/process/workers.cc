// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/workers.h>

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/process/exchange.h>
#include <rigor/process/launch.h>
#include <rigor/process/worker_path.h>

namespace rigor::process {
namespace {

std::string missing(const WorkerProgram& program) {
  std::string text = "rigor-worker is not installed: there is no ";
  for (std::size_t i = 0; i < program.looked_for.size(); ++i) {
    text += (i > 0 ? ", " : "") + program.looked_for[i];
  }
  return text + ", nor one in libexec beside a folder of PATH";
}

}  // namespace

class Workers::Pool {
 public:
  Pool() = default;
  explicit Pool(std::string program) : program_{std::move(program), {}} {}

  /// One that is idle, or a new one, or why there is none.
  std::variant<IdleWorker, std::string> take() {
    {
      const std::lock_guard lock(mutex_);
      while (!idle_.empty()) {
        IdleWorker worker = std::move(idle_.back());
        idle_.pop_back();
        // Killed by somebody meanwhile, it is to be replaced and not blamed on the next request.
        if (!worker.process.hung_up()) return worker;
      }
      if (!program_.path && program_.looked_for.empty()) program_ = find_worker();
    }
    if (!program_.path) return missing(program_);
    std::variant<WorkerProcess, int> started = WorkerProcess::start(*program_.path);
    if (const int* error = std::get_if<int>(&started)) {
      return *program_.path + ": " + std::generic_category().message(*error);
    }
    return IdleWorker{std::get<WorkerProcess>(std::move(started)), *program_.path};
  }

  void give_back(std::optional<IdleWorker> worker) {
    if (!worker) return;
    const std::lock_guard lock(mutex_);
    idle_.push_back(*std::move(worker));
  }

 private:
  std::mutex mutex_;
  WorkerProgram program_;
  std::vector<IdleWorker> idle_;
};

/// A request on its way, with its number; without a worker it has ended already.
class Workers::Underway {
 public:
  Underway(Pool& pool, std::size_t index, Request request, const Answer& answer)
      : pool_(pool), index_(index) {
    auto worker = pool.take();
    if (std::string* why = std::get_if<std::string>(&worker)) {
      never_begun_ = not_started(std::move(*why));
    } else {
      const auto deadline = Exchange::deadline_of(request.limits);
      exchange_.emplace(std::get<IdleWorker>(std::move(worker)), std::move(request), answer,
                        deadline);
    }
  }

  std::size_t index() const { return index_; }
  bool over() const { return !exchange_ || exchange_->over(); }
  Exchange& exchange() { return *exchange_; }

  RequestResult finish() {
    if (!exchange_) return *std::move(never_begun_);
    pool_.give_back(exchange_->take_worker());
    return exchange_->take_result();
  }

  using All = std::vector<std::unique_ptr<Underway>>;

  /// Until something can be sent or taken, or the first deadline; then all that can be is done.
  static void advance_any(const All& all) {
    std::vector<pollfd> waiting;
    auto first = Exchange::Clock::time_point::max();
    for (const auto& one : all) {
      waiting.push_back(one->exchange().wanted());
      first = std::min(first, one->exchange().deadline());
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(first - Exchange::Clock::now());
    ::poll(waiting.data(), waiting.size(), static_cast<int>(std::max<long>(left.count(), 0)));
    for (const auto& one : all) one->exchange().advance();
  }

 private:
  Pool& pool_;
  std::size_t index_;
  std::optional<Exchange> exchange_;
  std::optional<RequestResult> never_begun_;
};

Workers::Workers() : pool_(std::make_unique<Pool>()) {}
Workers::Workers(std::string program) : pool_(std::make_unique<Pool>(std::move(program))) {}
Workers::~Workers() = default;

RequestResult Workers::call(Request request) const {
  return call(std::move(request), [](std::string_view) { return std::nullopt; });
}

RequestResult Workers::call(Request request, const Answer& answer) const {
  Underway::All one;
  one.push_back(std::make_unique<Underway>(*pool_, 0, std::move(request), answer));
  while (!one.front()->over()) Underway::advance_any(one);
  return one.front()->finish();
}

void Workers::feed(unsigned jobs, const std::function<std::optional<Request>()>& next,
                   const std::function<void(std::size_t, RequestResult)>& ended) const {
  const Answer no_answer = [](std::string_view) { return std::nullopt; };
  Underway::All running;
  std::size_t given = 0;
  while (true) {
    while (running.size() < std::max(jobs, 1U)) {
      std::optional<Request> request = next();
      if (!request) break;
      auto started = std::make_unique<Underway>(*pool_, given++, *std::move(request), no_answer);
      if (started->over()) {
        ended(started->index(), started->finish());
      } else {
        running.push_back(std::move(started));
      }
    }
    if (running.empty()) return;
    Underway::advance_any(running);
    for (std::size_t i = 0; i < running.size();) {
      if (!running[i]->over()) {
        ++i;
        continue;
      }
      const std::unique_ptr<Underway> gone = std::move(running[i]);
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
      ended(gone->index(), gone->finish());
    }
  }
}

}  // namespace rigor::process
