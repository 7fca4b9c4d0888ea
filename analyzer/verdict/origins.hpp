// Where the knowledge of a thread came from: for ages, reactions and responses.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "pal/trace/trace.hpp"

namespace pal::analyzer {

/// A thing that is carried along: when it was born, and by which event of the run.
struct Origin {
  Nanoseconds born = 0;
  std::size_t event = 0;
  int number = -1;  // in the order of birth; -1: nothing
};

/// What one thread got, when, and by which event. The event is a take, a read, the beginning as a block, or
/// the effect of a statement that uses what its module keeps of a message.
struct Gained {
  std::size_t event = 0;
  Origin what;
};

/// Follows a run, and records which thread knew which event, sample or condition of a requirement since when.
class Origins {
 public:
  Origins(const Problem& problem, const Requirement& requirement, const trace::Trace& run);

  /// What `thread` had last got before the event with index `before`; nothing, if it had nothing.
  std::optional<Gained> gained(ThreadId thread, std::size_t before) const;
  /// The put of the message that event `take` takes.
  std::optional<std::size_t> put_of(std::size_t take) const;
  /// The event that left the message, whose value the statement with event `use` got its sample from;
  /// nothing: it got none from there.
  std::optional<std::size_t> kept_since(std::size_t use) const;
  /// The set whose value event `read` reads; nothing: it dates from the start.
  std::optional<std::size_t> set_of(std::size_t read) const;
  /// The first birth after `born`.
  std::optional<Origin> next_birth(Nanoseconds born) const;

 private:
  struct Known {
    Origin what;
    std::size_t event = 0;
  };

  void follow(std::size_t index);
  const Step* step_of(const trace::Event& event) const;
  void use(std::size_t index);
  void gain(ThreadId thread, std::size_t event, const Origin& what);
  Origin birth(std::size_t event);
  /// What the answer carries that its device gives now: it belongs to the oldest request that the device has
  /// taken.
  Origin answered(ChannelId request);
  bool is_source(ChannelId channel) const;
  const Origin& known(ThreadId thread) const;

  const Problem& problem_;
  const Requirement& requirement_;
  const trace::Trace& run_;
  Table<ThreadId, std::vector<Gained>> threads_;
  Table<ThreadId, bool> reads_;                     // by thread: it has read the requirement's condition
  std::map<std::pair<int, int>, Origin> messages_;  // by channel and serial number
  std::map<std::pair<int, int>, std::size_t> puts_;
  // By channel: what the answers to the requests will carry that were taken and not answered yet.
  Table<ChannelId, std::deque<Origin>> requests_;
  Table<KeptId, Known> kept_;  // by what modules keep, and the event that left it there
  std::map<std::pair<ThreadId, StatementId>, StepId> steps_;  // by thread and statement
  std::map<std::size_t, std::size_t> kept_since_;
  Table<ConditionId, Origin> conditions_;
  Table<ConditionId, std::optional<std::size_t>> sets_;  // the last
  std::map<std::size_t, std::optional<std::size_t>> set_of_;
  std::map<std::size_t, std::size_t> put_of_;
  std::vector<Origin> births_;
};

}  // namespace pal::analyzer
