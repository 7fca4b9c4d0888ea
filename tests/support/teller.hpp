// Random runs, told event by event: whatever the referee lets pass, sense or nonsense.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "analyzer/run_checker/referee.hpp"

namespace pal::test {

/// Tells runs of one problem. The next event is a random one that breaks no rule yet, whether the skill could
/// do it or not. Time goes on by a millisecond when the referee allows it. Events that no machine would make
/// are as likely as others.
class Teller {
 public:
  /// `empty`: a run of the problem without events.
  Teller(const analyzer::Problem& problem, trace::Trace empty, std::uint64_t seed)
      : problem_(problem), run_(std::move(empty)), engine_(seed), after_(problem.threads.size()) {
    run_.events.clear();
    serial_.resize(problem.channels.size());
    for (const analyzer::ThreadId t : problem.threads.ids()) lead_to(after_[t], problem.threads[t].entry);
    entries_ = after_;
  }

  /// A run of at most `events` events, in which all is told up to `until()`.
  const trace::Trace& tell(std::size_t events) {
    while (run_.events.size() < events && rewinds_ < 50 && now_ < longest) {
      if (one_of(3) == 0 && pass()) continue;
      if (say_something() || pass()) continue;
      rewind();
    }
    if (!leaves(now_)) rewind();
    return run_;
  }

  analyzer::Nanoseconds until() const { return now_; }

 private:
  using Kind = trace::Kind;
  using Step = analyzer::Step;
  static constexpr analyzer::Nanoseconds unit = 1'000'000;
  static constexpr analyzer::Nanoseconds longest = 60 * unit;

  struct Kept {
    std::size_t events = 0;
    std::vector<int> serial;
    Table<analyzer::ThreadId, std::set<analyzer::StepId>> after;
  };

  std::size_t one_of(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

  /// Steps at which a thread can be that has come to this one.
  void lead_to(std::set<analyzer::StepId>& steps, analyzer::StepId step) const {
    if (!steps.insert(step).second) return;
    const Step& at = problem_.steps[step];
    if (at.kind == Step::Kind::fork) lead_to(steps, at.next.front());
  }

  std::string follow(std::optional<analyzer::Nanoseconds> until) const {
    analyzer::run_checker::Referee referee(problem_, nullptr, run_.events,
                                           analyzer::run_checker::BusyFrom::each_pause);
    try {
      referee.follow(until, {});
    } catch (const analyzer::run_checker::Broken& rule) {
      return rule.what();
    }
    return {};
  }

  bool leaves(analyzer::Nanoseconds next) const { return follow(next).empty(); }

  /// Whether all that is told keeps the rules, although the instant is not over.
  bool keeps() {
    trace::Event last;
    last.time_ns = -1;
    run_.events.push_back(last);
    const bool kept = follow(std::nullopt) == "time runs backwards";
    run_.events.pop_back();
    return kept;
  }

  bool pass() {
    if (!leaves(now_ + unit)) return false;
    kept_ = {run_.events.size(), serial_, after_};
    now_ += unit;
    return true;
  }

  void rewind() {
    ++rewinds_;
    run_.events.resize(kept_.events);
    if (kept_.after.empty()) {
      serial_.assign(serial_.size(), 0);
      after_ = entries_;
      return;
    }
    serial_ = kept_.serial;
    after_ = kept_.after;
  }

  bool say_something() {
    std::vector<trace::Event> all = sayable();
    std::shuffle(all.begin(), all.end(), engine_);
    for (const trace::Event& event : all) {
      const bool idle_talk = event.kind == Kind::ready || event.kind == Kind::stop;
      if (idle_talk && one_of(4) != 0) continue;
      run_.events.push_back(event);
      if (keeps()) {
        note(event);
        return true;
      }
      run_.events.pop_back();
    }
    return false;
  }

  void note(const trace::Event& event) {
    if (event.kind == Kind::put) ++serial_[static_cast<std::size_t>(event.subject)];
    if (event.kind != Kind::done) return;
    std::set<analyzer::StepId> next;
    const auto thread = analyzer::ThreadId::of(event.actor);
    for (const analyzer::StepId step : after_[thread]) {
      const Step& at = problem_.steps[step];
      if (at.statement.value != event.statement) continue;
      for (analyzer::StepId each : at.next) lead_to(next, each);
    }
    // A block may begin again.
    if (problem_.threads[thread].parent.valid()) {
      const std::set<analyzer::StepId>& entries = entries_[thread];
      next.insert(entries.begin(), entries.end());
    }
    after_[thread] = next;
  }

  static void mentioned(const pan::Guard& guard, std::set<pan::ConditionId>& conditions) {
    if (guard.kind == pan::Guard::Kind::equals) conditions.insert(guard.condition);
    for (const pan::Guard& term : guard.terms) mentioned(term, conditions);
  }

  std::vector<trace::Event> sayable() const {
    std::vector<trace::Event> all;
    const int threads = static_cast<int>(problem_.threads.size());
    for (const analyzer::ThreadId t : problem_.threads.ids()) {
      for (const analyzer::StepId step : after_[t]) statement(all, t.value, problem_.steps[step]);
    }
    for (const analyzer::DeviceId d : problem_.devices.ids()) {
      const int device = threads + d.value;
      say(all, Kind::busy, device);
      say(all, Kind::idle, device);
      for (const analyzer::ChannelId c : problem_.channels.ids()) {
        const int channel = c.value;
        if (problem_.channels[c].receiver_device == d) say(all, Kind::take, device, -1, channel);
        if (problem_.channels[c].sender_device != d) continue;
        for (Kind kind : {Kind::put, Kind::overrun, Kind::drop}) say(all, kind, device, -1, channel);
      }
    }
    for (std::size_t c = 0; c < problem_.channels.size(); ++c)
      say(all, Kind::drop, -1, -1, static_cast<int>(c));
    return all;
  }

  void statement(std::vector<trace::Event>& all, int thread, const Step& at) const {
    const int is = at.statement.value;
    for (Kind kind : {Kind::ready, Kind::start, Kind::stop, Kind::done, Kind::cancel})
      say(all, kind, thread, is);
    for (const analyzer::ChannelId of : at.channels) {
      const int channel = of.value;
      const bool wait = at.kind == Step::Kind::wait;
      say(all, Kind::block, thread, is, channel);
      say(all, wait ? Kind::take : Kind::put, thread, is, channel);
      say(all, wait ? Kind::give_up : Kind::drop, thread, is, channel);
    }
    std::set<pan::ConditionId> conditions;
    for (const pan::Guard& guard : at.guards) mentioned(guard, conditions);
    if (at.condition.valid()) conditions.insert(at.condition);
    for (pan::ConditionId condition : conditions) {
      for (int value : {0, 1})
        say(all, at.kind == Step::Kind::set ? Kind::set : Kind::read, thread, is, condition.value, value);
    }
    if (at.kind == Step::Kind::fork) say(all, Kind::block, thread, is);
    if (at.kind == Step::Kind::complete) say(all, Kind::complete, thread, is, -1, at.code);
    if (at.kind == Step::Kind::test && at.next.size() <= at.guards.size())
      say(all, Kind::complete, thread, is, -1, problem_.error_code);
  }

  void say(std::vector<trace::Event>& all, Kind kind, int actor, int statement = -1, int subject = -1,
           int value = 0) const {
    const bool message = kind == Kind::put || kind == Kind::take || kind == Kind::drop;
    if (message) {
      const bool next = kind == Kind::put || (kind == Kind::drop && actor >= 0);
      value = serial_[static_cast<std::size_t>(subject)] + (next ? 1 : 0);
    }
    all.push_back({now_, kind, actor, statement, subject, value});
  }

  const analyzer::Problem& problem_;
  trace::Trace run_;
  std::mt19937_64 engine_;
  analyzer::Nanoseconds now_ = 0;
  std::vector<int> serial_;  // by channel: the number of its newest message
  Table<analyzer::ThreadId, std::set<analyzer::StepId>> after_;
  Table<analyzer::ThreadId, std::set<analyzer::StepId>> entries_;
  Kept kept_;
  int rewinds_ = 0;
};

}  // namespace pal::test
