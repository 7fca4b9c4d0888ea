#include "analyzer/load/load_account.hpp"

#include <algorithm>
#include <map>

#include "analyzer/verdict/sentence.hpp"
#include "pal/trace/slices.hpp"

namespace pal::analyzer {
namespace {

/// A turn takes at most this many times the time of the load.
constexpr Nanoseconds most_times = 1'000;

struct Share {
  int actor;
  int statement;
  Nanoseconds work;
};

/// Work on the processor since `from`, by thread and statement, longest first.
std::vector<Share> shares(const Problem& problem, ProcessorId processor,
                          const std::vector<trace::Slice>& slices, Nanoseconds from) {
  std::map<std::pair<int, int>, Nanoseconds> by;
  for (const trace::Slice& slice : slices) {
    const bool here = slice.state == trace::State::running && slice.to_ns > from &&
                      problem.threads[ThreadId::of(slice.actor)].processor == processor;
    if (here) by[{slice.actor, slice.statement}] += slice.to_ns - std::max<Nanoseconds>(slice.from_ns, from);
  }
  std::vector<Share> all;
  for (const auto& [who, work] : by) all.push_back({who.first, who.second, work});
  std::stable_sort(all.begin(), all.end(), [](const Share& a, const Share& b) { return a.work > b.work; });
  return all;
}

Addend addend(const trace::Trace& run, const Share& share, Nanoseconds turn) {
  Addend made;
  made.amount = per_second({share.work, turn});
  made.actor = run.actors[static_cast<std::size_t>(share.actor)].name;
  made.what = "runs";
  if (share.statement >= 0) {
    const trace::Statement& statement = run.statements[static_cast<std::size_t>(share.statement)];
    made.what += " " + statement.text;
    made.file = statement.file;
    made.line = statement.line;
  }
  made.what += ", " + milliseconds(share.work) + " in every " + milliseconds(turn);
  return made;
}

}  // namespace

std::vector<Addend> load_account(const Problem& problem, ProcessorId processor, const LoadBound& load) {
  std::vector<Addend> all;
  if (!load.exact || !load.witness || load.most.work == 0 || load.witness->trace.events.empty()) return all;
  const trace::Trace& run = load.witness->trace;
  const std::vector<trace::Slice> slices = trace::slices(run);
  const Nanoseconds end = run.events.back().time_ns;
  for (Nanoseconds times = 1; times <= most_times && times * load.most.time <= end; ++times) {
    const Nanoseconds turn = times * load.most.time;
    const std::vector<Share> found = shares(problem, processor, slices, end - turn);
    Nanoseconds work = 0;
    for (const Share& share : found) work += share.work;
    if (work != times * load.most.work) continue;
    Nanoseconds rest = per_second(load.most);
    for (const Share& share : found) {
      all.push_back(addend(run, share, turn));
      rest -= all.back().amount;
    }
    all.front().amount += rest;
    break;
  }
  return all;
}

}  // namespace pal::analyzer
