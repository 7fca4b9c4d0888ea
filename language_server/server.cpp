#include "language_server/server.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <ostream>
#include <sstream>
#include <thread>
#include <utility>

#include "language_server/framing.hpp"
#include "language_server/session.hpp"

namespace pal::language_server {

namespace {

bool changes_a_text(const Json& message) {
  const std::string method = string_of(message, "method");
  return method.starts_with("textDocument/did") || method.starts_with("workspace/did");
}

Json without_meaning(int code, const std::string& reason) {
  return {{"jsonrpc", "2.0"}, {"id", nullptr}, {"error", {{"code", code}, {"message", reason}}}};
}

/// A file name may hold any bytes; what is no UTF-8 in it is replaced.
std::string text_of(const Json& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

class Server {
 public:
  Server(std::istream& in, std::ostream& out, const FileSystem& files, const Options& options,
         std::ostream* log)
      : in_(in),
        out_(out),
        log_(log),
        options_(options),
        session_(files, options, [this](const Json& message) { send(message); }) {}

  bool run() {
    std::thread reader([this] { read(); });
    std::thread prover([this] { prove(); });
    answer();
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
      ++newest_;
    }
    changed_.notify_all();
    prover.join();
    reader.join();
    return session_.was_shut_down();
  }

 private:
  void read() {
    for (;;) {
      auto next = read_message(in_);
      const std::lock_guard lock(mutex_);
      if (std::holds_alternative<EndOfInput>(next)) {
        ended_ = true;
        changed_.notify_all();
        return;
      }
      if (const auto* bad = std::get_if<BadHeader>(&next)) {
        tasks_.push_back([this, reason = bad->reason] { send(without_meaning(parse_error, reason)); });
      } else {
        const auto& text = std::get<std::string>(next);
        note("<-", text);
        if (!take(text)) return;
      }
      changed_.notify_all();
    }
  }

  /// With the mutex held. False after `exit`: nothing comes after it.
  bool take(const std::string& text) {
    Json message = Json::parse(text, nullptr, false);
    if (message.is_discarded()) {
      tasks_.push_back([this] { send(without_meaning(parse_error, "the message is no JSON")); });
      return true;
    }
    const std::string method = string_of(message, "method");
    if (method == "$/cancelRequest") cancelled_.insert(member(member(message, "params"), "id"));
    const bool change = changes_a_text(message);
    if (change) {
      ++newest_;  // proofs of the text before end at once
      ++waiting_;
    }
    tasks_.push_back([this, change, message = std::move(message)] {
      bool cancelled = false;
      {
        const std::lock_guard lock(mutex_);
        if (change) --waiting_;
        cancelled = cancelled_.erase(member(message, "id")) != 0;
      }
      session_.receive(message, cancelled);
    });
    changed_.notify_all();
    return method != "exit";
  }

  void answer() {
    for (;;) {
      std::function<void()> task;
      {
        std::unique_lock lock(mutex_);
        if (tasks_.empty()) {
          lock.unlock();
          const bool texts = session_.has_to_check();
          if (session_.check([this] { return waiting_ > 0; })) hand_over(session_.take_jobs());
          if (texts) rest();
          lock.lock();
          changed_.wait(lock, [this] { return !tasks_.empty() || ended_; });
          if (tasks_.empty()) return;
        }
        task = std::move(tasks_.front());
        tasks_.pop_front();
      }
      task();
      if (session_.is_over()) return;
    }
  }

  void hand_over(std::vector<ProofJob> jobs) {
    if (jobs.empty()) return;
    const std::lock_guard lock(mutex_);
    if (waiting_ > 0) return;
    jobs_ = {jobs.begin(), jobs.end()};
    jobs_of_ = newest_;
    changed_.notify_all();
  }

  void prove() {
    for (;;) {
      ProofJob job;
      std::uint64_t begun = 0;
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return over_ || !jobs_.empty(); });
        if (over_) return;
        job = std::move(jobs_.front());
        jobs_.pop_front();
        begun = jobs_of_;
      }
      const auto stop = [this, begun] { return newest_ != begun; };
      prove(job, stop);
      give([this] { session_.hide_progress(); });
      job.analysis = nullptr;
      rest();
    }
  }

  /// First whether everything holds, as that is soon known; then the bounds that runs attain, and advice.
  void prove(const ProofJob& job, const std::function<bool()>& stop) {
    for (const Depth depth : {Depth::quick, Depth::whole}) {
      if (stop()) return;
      std::function<void(Proofs)> told;
      if (depth == Depth::quick) {
        told = [this, &job](Proofs now) {
          give([this, job, known = std::make_shared<Proofs>(std::move(now))] {
            session_.told(job, std::move(*known));
          });
        };
      }
      auto proofs = std::make_shared<Proofs>(
          language_server::prove(*job.analysis, *options_.prover, depth, job.seconds, stop, told));
      if (stop()) return;
      const bool whole = is_whole(*proofs);
      give([this, job, proofs] { session_.proved(job, std::move(*proofs)); });
      if (whole) break;
      give([this, job] { session_.show_progress(job); });
    }
    auto advice = std::make_shared<AllAdvice>(advise(*job.analysis, *options_.prover, job.seconds, stop));
    if (!stop()) give([this, job, advice] { session_.advised(job, std::move(*advice)); });
  }

  /// A thread has done all that a text asked for.
  void rest() const {
    if (options_.at_rest) options_.at_rest();
  }

  void give(std::function<void()> task) {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
    changed_.notify_all();
  }

  void send(const Json& message) {
    const std::string text = text_of(message);
    note("->", text);
    write_message(text, out_);
  }

  void note(const char* direction, const std::string& text) {
    if (log_ == nullptr) return;
    const std::lock_guard lock(log_mutex_);
    const auto now =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begun_);
    *log_ << now.count() << " ms " << direction << ' ' << text << std::endl;
  }

  std::istream& in_;
  std::ostream& out_;
  std::ostream* log_;
  const Options& options_;
  Session session_;
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::mutex log_mutex_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;  // for the thread that answers
  std::set<Json> cancelled_;
  std::deque<ProofJob> jobs_;
  std::uint64_t jobs_of_ = 0;
  std::atomic<std::uint64_t> newest_ = 0;  // grows with each change of a text
  std::atomic<int> waiting_ = 0;           // changes that are read and not taken
  bool ended_ = false, over_ = false;
};

}  // namespace

bool serve(std::istream& in, std::ostream& out, const FileSystem& files, const Options& options,
           std::ostream* log) {
  return Server(in, out, files, options, log).run();
}

std::string replay(const std::string& script, const FileSystem& files, const Options& options) {
  std::string sent;
  Session session(files, options, [&](const Json& message) { sent += text_of(message) + "\n"; });
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line) && !session.is_over();) {
    if (line.empty() || line.front() == '#') continue;
    const Json message = Json::parse(line, nullptr, false);
    if (message.is_discarded()) {
      sent += text_of(without_meaning(parse_error, "the message is no JSON")) + "\n";
      continue;
    }
    session.receive(message);
    session.check({});
    const auto never = [] { return false; };
    for (const auto& job : session.take_jobs()) {
      for (const Depth depth : {Depth::quick, Depth::whole}) {
        const auto told = [&](Proofs now) { session.told(job, std::move(now)); };
        Proofs proofs = prove(*job.analysis, *options.prover, depth, job.seconds, never,
                              depth == Depth::quick ? std::function<void(Proofs)>(told) : nullptr);
        const bool whole = is_whole(proofs);
        session.proved(job, std::move(proofs));
        if (whole) break;
        session.show_progress(job);
      }
      session.advised(job, advise(*job.analysis, *options.prover, job.seconds, never));
      session.hide_progress();
    }
  }
  return sent;
}

}  // namespace pal::language_server
