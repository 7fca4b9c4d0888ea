#include "analyzer/verdict/narrator.hpp"

#include <algorithm>

namespace pal::analyzer {

using trace::Kind;

namespace {

/// By processor: the threads that ran on it, in order. Two do not at one time.
Table<ProcessorId, std::vector<trace::Slice>> running_on(const Problem& problem,
                                                         const std::vector<trace::Slice>& slices) {
  Table<ProcessorId, std::vector<trace::Slice>> by_processor(problem.processors.size());
  for (const trace::Slice& slice : slices) {
    if (slice.state != trace::State::running || slice.to_ns == slice.from_ns) continue;
    const ProcessorId processor = problem.threads[ThreadId::of(slice.actor)].processor;
    by_processor[processor].push_back(slice);
  }
  return by_processor;
}

/// By thread and device: what it did, in order.
std::vector<std::vector<trace::Slice>> by_actor(const trace::Trace& trace,
                                                const std::vector<trace::Slice>& slices) {
  std::vector<std::vector<trace::Slice>> by(trace.actors.size());
  for (const trace::Slice& slice : slices) by[static_cast<std::size_t>(slice.actor)].push_back(slice);
  return by;
}

}  // namespace

Narrator::Narrator(const Problem& problem, const trace::Trace& run)
    : problem_(problem),
      run_(run),
      slices_(trace::slices(run)),
      sends_(problem.statements.size()),
      running_(running_on(problem, slices_)),
      of_actor_(by_actor(run, slices_)),
      takes_(run.actors.size()),
      puts_(run.actors.size()) {
  for (const Step& step : problem.steps) {
    if (step.kind == Step::Kind::send && step.statement.valid()) sends_[step.statement] = true;
  }
  std::map<std::pair<int, int>, std::size_t> under_way;  // by channel and serial number
  for (std::size_t e = 0; e < run.events.size(); ++e) {
    const trace::Event& event = run.events[e];
    if (event.actor < 0) continue;
    if (event.kind == Kind::put) {
      under_way[{event.subject, event.value}] = e;
      puts_[static_cast<std::size_t>(event.actor)].push_back(e);
    } else if (event.kind == Kind::take) {
      takes_[static_cast<std::size_t>(event.actor)].push_back(e);
      const auto put = under_way.find({event.subject, event.value});
      if (put != under_way.end()) put_of_[e] = put->second;
    }
  }
}

Reason Narrator::reason(Nanoseconds from, Nanoseconds to, int actor, std::string what, int of) const {
  Reason made;
  made.from = from;
  made.to = to;
  if (actor >= 0) made.actor = run_.actors[static_cast<std::size_t>(actor)].name;
  made.what = std::move(what);
  if (of >= 0) {
    made.statement = statement(of).text;
    made.file = statement(of).file;
    made.line = statement(of).line;
  }
  return made;
}

std::string Narrator::doing(const trace::Slice& slice) const {
  const std::string text = slice.statement < 0 ? "" : statement(slice.statement).text;
  switch (slice.state) {
    case trace::State::running:
      return slice.ending == trace::Ending::preempted ? "runs " + text + " until it is preempted"
                                                      : "runs " + text;
    case trace::State::ready:
      return "is kept from its processor at " + text;
    case trace::State::waiting:
      return "waits at " + text;
    case trace::State::serving:
      return "serves";
  }
  return {};
}

bool Narrator::is_at_work(ThreadId thread, Nanoseconds instant) const {
  const std::vector<trace::Slice>& own = of_actor_[thread.index()];
  return std::any_of(own.begin(), own.end(), [instant](const trace::Slice& slice) {
    return slice.from_ns <= instant && slice.to_ns >= instant;
  });
}

/// The threads that kept another from its processor in [from, to], piece by piece.
void Narrator::interference(const trace::Slice& kept, Nanoseconds from, Nanoseconds to,
                            std::vector<Reason>& out) const {
  const ProcessorId processor = problem_.threads[ThreadId::of(kept.actor)].processor;
  const std::vector<trace::Slice>& here = running_[processor];
  auto at = std::partition_point(here.begin(), here.end(),
                                 [from](const trace::Slice& slice) { return slice.to_ns <= from; });
  for (; at != here.end() && at->from_ns <= from && from < to; ++at) {
    const trace::Slice& slice = *at;
    if (slice.actor == kept.actor) continue;
    const Nanoseconds end = std::min<Nanoseconds>(slice.to_ns, to);
    const std::string by = run_.actors[static_cast<std::size_t>(slice.actor)].name;
    out.push_back(reason(from, end, kept.actor,
                         "is kept from its processor by " + by + ", which " + doing(slice), slice.statement));
    from = end;
  }
  if (from < to) out.push_back(reason(from, to, kept.actor, doing(kept), kept.statement));
}

/// What a thread did in [from, to], without gaps. Into waits it is told what happened meanwhile, to that
/// depth.
void Narrator::tell(ThreadId thread, Nanoseconds from, Nanoseconds to, std::vector<Reason>& out,
                    int depth) const {
  Nanoseconds at = from;
  const std::vector<trace::Slice>& own = of_actor_[thread.index()];
  auto next = std::partition_point(own.begin(), own.end(),
                                   [from](const trace::Slice& slice) { return slice.to_ns <= from; });
  for (; next != own.end() && next->from_ns < to; ++next) {
    const trace::Slice& slice = *next;
    if (slice.to_ns <= at) continue;
    if (slice.from_ns > at) rest(thread, at, slice.from_ns, out, depth);
    const Nanoseconds end = std::min<Nanoseconds>(slice.to_ns, to);
    const Nanoseconds begin = std::max<Nanoseconds>(slice.from_ns, at);
    if (slice.state == trace::State::ready) {
      interference(slice, begin, end, out);
    } else {
      out.push_back(reason(begin, end, thread.value, doing(slice), slice.statement));
      if (slice.state == trace::State::waiting && slice.statement >= 0)
        out.back().kind = is_send(slice) ? Reason::Kind::waits_for_room : Reason::Kind::waits_for_message;
      if (slice.state == trace::State::waiting && depth > 0)
        out.back().inside = meanwhile(slice, begin, end, depth - 1);
    }
    at = end;
  }
  if (at < to) rest(thread, at, to, out, depth);
}

/// What kept a thread in [from, to], in which it has no slices. It waited for its blocks. Or it is itself a
/// block that has not begun; then it is what its parent did.
void Narrator::rest(ThreadId thread, Nanoseconds from, Nanoseconds to, std::vector<Reason>& out,
                    int depth) const {
  const ThreadId parent = problem_.threads[thread].parent;
  if (blocks_at_work(thread, from, to)) {
    out.push_back(reason(from, to, thread.value, "waits for its blocks", -1));
    const ThreadId block = last_block(thread, from, to);
    if (block.valid() && depth > 0) tell(block, from, to, out.back().inside, depth - 1);
  } else if (parent.valid()) {
    tell(parent, from, to, out, depth);
  } else {
    out.push_back(reason(from, to, thread.value, "has not begun", -1));
  }
}

bool Narrator::blocks_at_work(ThreadId thread, Nanoseconds from, Nanoseconds to) const {
  for (const ThreadId block : problem_.threads.ids()) {
    if (problem_.threads[block].parent != thread) continue;
    const std::vector<trace::Slice>& own = of_actor_[block.index()];
    const auto next = std::partition_point(own.begin(), own.end(),
                                           [from](const trace::Slice& slice) { return slice.to_ns <= from; });
    const bool works = next != own.end() && next->from_ns < to;
    if (works || blocks_at_work(block, from, to)) return true;
  }
  return false;
}

}  // namespace pal::analyzer
