// What the threads of a run did from when to when, in words, and what happened while they waited.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "analyzer/verdict/verdict.hpp"
#include "pal/trace/slices.hpp"
#include "pal/trace/trace.hpp"

namespace pal::analyzer {

class Narrator {
 public:
  /// How deep waits within waits are explained; deeper ones rarely interest a reader.
  static constexpr int most_depth = 8;

  /// Both must outlive this.
  Narrator(const Problem& problem, const trace::Trace& run);

  /// What a thread did in [from, to], without gaps, added to `out`. For waits it includes what happened
  /// meanwhile, to that depth.
  void tell(ThreadId thread, Nanoseconds from, Nanoseconds to, std::vector<Reason>& out,
            int depth = most_depth) const;

  /// One piece; `actor` and the statement `of`: -1 for none.
  Reason reason(Nanoseconds from, Nanoseconds to, int actor, std::string what, int of) const;
  /// "waits at WTM( … )"
  std::string doing(const trace::Slice& slice) const;

  /// Whether a thread has begun and not ended.
  bool is_at_work(ThreadId thread, Nanoseconds instant) const;

  const trace::Statement& statement(int index) const {
    return run_.statements[static_cast<std::size_t>(index)];
  }
  bool is_device(int actor) const { return run_.actors[static_cast<std::size_t>(actor)].device; }
  const std::vector<trace::Slice>& slices() const { return slices_; }

 private:
  // narrator.cpp
  void interference(const trace::Slice& kept, Nanoseconds from, Nanoseconds to,
                    std::vector<Reason>& out) const;
  void rest(ThreadId thread, Nanoseconds from, Nanoseconds to, std::vector<Reason>& out, int depth) const;
  bool blocks_at_work(ThreadId thread, Nanoseconds from, Nanoseconds to) const;

  // meanwhile.cpp
  std::vector<Reason> meanwhile(const trace::Slice& wait, Nanoseconds from, Nanoseconds to, int depth) const;
  std::optional<int> waited_for(const trace::Slice& wait) const;
  std::optional<int> to_send(const trace::Slice& wait) const;
  bool is_send(const trace::Slice& wait) const;
  std::optional<std::size_t> put_for(const trace::Slice& wait) const;
  std::optional<int> sender_at(const trace::Slice& wait) const;
  std::vector<std::size_t>::const_iterator first_at(const std::vector<std::size_t>& events,
                                                    Nanoseconds instant) const;
  ThreadId last_block(ThreadId thread, Nanoseconds from, Nanoseconds to) const;
  void serves(int device, Nanoseconds from, Nanoseconds to, std::vector<Reason>& out) const;
  std::string works_on(int device, const trace::Slice& slice) const;

  const Problem& problem_;
  const trace::Trace& run_;
  std::vector<trace::Slice> slices_;
  Table<StatementId, bool> sends_;
  Table<ProcessorId, std::vector<trace::Slice>> running_;  // by processor: two do not run on it at one time
  std::vector<std::vector<trace::Slice>> of_actor_;        // by thread and device, in order
  std::vector<std::vector<std::size_t>> takes_;            // events, by the taker, in order
  std::vector<std::vector<std::size_t>> puts_;             // … by the sender
  std::map<std::size_t, std::size_t> put_of_;              // by take
};

}  // namespace pal::analyzer
