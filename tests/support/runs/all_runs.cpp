#include "tests/support/runs/all_runs.hpp"

#include <deque>
#include <unordered_map>

#include "pal/pan/times.hpp"

namespace pal::test {

using namespace pan;
using namespace runs;

namespace {

constexpr std::size_t start = static_cast<std::size_t>(-1);

bool busier(const Ratio& a, const Ratio& b) {
  return a.work * b.time > b.work * a.time;
}

}  // namespace

AllRuns::AllRuns(const Network& network, const Environment& environment, Wanted wanted, Duration unit,
                 int cap)
    : network_(network),
      environment_(with_times_of(network, environment)),
      wanted_(std::move(wanted)),
      unit_(unit),
      cap_(cap) {
  const auto process = [&](const Party& party) {
    const auto* module = std::get_if<ModuleId>(&party);
    if (module != nullptr && !network.modules[module->index()].body.empty()) return -1;
    const std::string name = party_name(network, party);
    for (std::size_t p = 0; p < processes_.size(); ++p) {
      if (processes_[p].name == name) return static_cast<int>(p);
    }
    Process made;
    made.name = name;
    for (const DeviceTiming& timing : environment.devices) {
      if (timing.device == name) made.timing = &timing;
    }
    processes_.push_back(made);
    return static_cast<int>(processes_.size()) - 1;
  };
  request_of_.assign(network.channels.size(), -1);
  for (std::size_t c = 0; c < network.channels.size(); ++c) {
    const Channel& channel = network.channels[c];
    sender_process_.push_back(process(channel.sender));
    receiver_process_.push_back(process(channel.receiver));
    if (channel.answer.valid()) request_of_[channel.answer.index()] = static_cast<int>(c);
  }
  for (std::size_t c = 0; c < network.channels.size(); ++c) {
    const Channel& channel = network.channels[c];
    if (sender_process_[c] >= 0) {
      Process& from = processes_[ix(sender_process_[c])];
      const auto* event =
          from.timing == nullptr ? nullptr : std::get_if<EventDevice>(&from.timing->behaviour);
      if (event != nullptr && network.messages[channel.message.index()].name == event->message)
        from.event = static_cast<int>(c);
    }
    if (receiver_process_[c] >= 0 && channel.answer.valid()) {
      Process& to = processes_[ix(receiver_process_[c])];
      if (to.timing != nullptr && !std::holds_alternative<EventDevice>(to.timing->behaviour))
        to.requests.push_back(static_cast<int>(c));
    }
  }
}

Seen AllRuns::enumerate(std::size_t most) {
  Seen seen;
  greatest_ = least_ = -1;
  std::unordered_map<std::string, std::size_t> known;
  std::vector<Arrival> arrivals;
  std::vector<Stretch> stretches;       // load: between states; the work is told by the busy processors
  std::vector<std::vector<bool>> busy;  // load: by state and processor
  std::deque<std::pair<State, std::size_t>> todo;
  bool long_before = false;
  std::optional<Arrival> best;   // of what was measured last as the greatest (the least), or failed
  std::vector<Stretch> waiting;  // between states in which one event waits long; work is time
  bool unanswered = false;
  const bool loads = wanted_.kind == Wanted::Kind::load;
  std::int64_t before = -1;
  std::int64_t before_least = -1;
  const auto arrived = [&](std::size_t from, const AllDecisions& every) {
    const bool new_best = wanted_.kind == Wanted::Kind::least ? least_ != before_least : greatest_ > before;
    if ((s_.failed || new_best) && !seen.failed) best = Arrival{from, every.decided()};
    before = greatest_;
    before_least = least_;
    seen.failed = seen.failed || s_.failed;
    if (s_.ended || s_.failed) return;
    const auto [entry, fresh] = known.emplace(key(s_), arrivals.size());
    if (loads && from != start) stretches.push_back({from, entry->second, 0, passed_});
    if (long_before && !old_gone_ && waits_long(s_))
      waiting.push_back({from, entry->second, passed_, passed_});
    if (!fresh) return;
    arrivals.push_back({from, every.decided()});
    if (loads) {
      busy.emplace_back();
      for (int running : s_.running) busy.back().push_back(running >= 0);
    }
    todo.emplace_back(s_, arrivals.size() - 1);
  };
  try {
    AllDecisions every;
    decisions_ = &every;
    do {
      begin();
      arrived(start, every);
    } while (known.size() <= most && every.next());
    while (!todo.empty() && known.size() <= most) {
      const auto [from, index] = std::move(todo.front());
      todo.pop_front();
      long_before = waits_long(from);
      AllDecisions each;
      decisions_ = &each;
      do {
        s_ = from;
        old_gone_ = false;
        if (!step()) {
          unanswered = unanswered || (wanted_.kind == Wanted::Kind::response && !from.births.empty());
          break;
        }
        arrived(index, each);
      } while (each.next());
    }
    seen.complete = todo.empty() && !sporadic();
  } catch (const TooMuch&) {
    seen.complete = false;
  }
  seen.unanswered = unanswered || greatest_ratio(arrivals.size(), waiting).work > 0;
  seen.greatest = greatest_;
  seen.least = least_;
  seen.states = known.size();
  if (loads) seen.load = load(stretches, busy);
  if (best && tell) retell(arrivals, *best);
  return seen;
}

/// The greatest fraction of time, on any way round, that one of the processors is busy.
Ratio AllRuns::load(const std::vector<Stretch>& stretches, const std::vector<std::vector<bool>>& busy) const {
  Ratio greatest;
  for (int p : wanted_.processors) {
    std::vector<Stretch> of = stretches;
    for (Stretch& each : of) each.work = busy[each.from][ix(p)] ? each.time : 0;
    const Ratio found = greatest_ratio(busy.size(), of);
    if (busier(found, greatest)) greatest = found;
  }
  return greatest;
}

/// The run that ends with `last`, once more with its story.
void AllRuns::retell(const std::vector<Arrival>& arrivals, const Arrival& last) {
  std::vector<std::vector<int>> path{last.decided};
  for (std::size_t at = last.from; at != start; at = arrivals[at].from) path.push_back(arrivals[at].decided);
  story.clear();
  telling_ = true;
  for (std::size_t i = path.size(); i-- > 0;) {
    RecordedDecisions again(path[i]);
    decisions_ = &again;
    if (i + 1 == path.size()) {
      begin();
    } else {
      step();
    }
  }
  telling_ = false;
}

Seen AllRuns::walk(Decisions& decisions, int things) {
  Seen seen;
  greatest_ = least_ = -1;
  decisions_ = &decisions;
  telling_ = tell;
  try {
    begin();
    for (int i = 0; i < things && step(); ++i) {
    }
  } catch (const TooMuch&) {
  }
  seen.failed = s_.failed;
  seen.greatest = greatest_;
  seen.least = least_;
  return seen;
}

}  // namespace pal::test
