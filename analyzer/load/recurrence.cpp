#include "analyzer/load/recurrence.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace pal::analyzer {
namespace {

/// Strongly connected components (R. E. Tarjan, 1972), without recursion.
class Components {
 public:
  Components(std::size_t nodes, const std::vector<Edge>& edges)
      : next_(nodes), of_(nodes, -1), low_(nodes), number_(nodes, -1) {
    for (const Edge& edge : edges) next_[static_cast<std::size_t>(edge.from)].push_back(edge.to);
    for (std::size_t n = 0; n < nodes; ++n) {
      if (number_[n] < 0) visit(static_cast<int>(n));
    }
  }

  int of(int node) const { return of_[static_cast<std::size_t>(node)]; }
  int count() const { return count_; }

 private:
  void visit(int root) {
    std::vector<std::pair<int, std::size_t>> calls{{root, 0}};
    while (!calls.empty()) {
      const int node = calls.back().first;
      const auto n = static_cast<std::size_t>(node);
      if (calls.back().second == 0) {
        number_[n] = low_[n] = numbered_++;
        stack_.push_back(node);
      }
      bool descended = false;
      while (calls.back().second < next_[n].size()) {
        const int to = next_[n][calls.back().second++];
        const auto t = static_cast<std::size_t>(to);
        if (number_[t] < 0) {
          calls.emplace_back(to, 0);
          descended = true;
          break;
        }
        if (of_[t] < 0) low_[n] = std::min(low_[n], number_[t]);
      }
      if (descended) continue;
      if (low_[n] == number_[n]) {
        for (;;) {
          const int member = stack_.back();
          stack_.pop_back();
          of_[static_cast<std::size_t>(member)] = count_;
          if (member == node) break;
        }
        ++count_;
      }
      calls.pop_back();
      if (!calls.empty()) {
        const auto above = static_cast<std::size_t>(calls.back().first);
        low_[above] = std::min(low_[above], low_[n]);
      }
    }
  }

  std::vector<std::vector<int>> next_;
  std::vector<int> of_;
  std::vector<int> low_;
  std::vector<int> number_;
  std::vector<int> stack_;
  int numbered_ = 0;
  int count_ = 0;
};

/// Sets of things that belong together.
class Groups {
 public:
  explicit Groups(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0U); }
  std::size_t of(std::size_t thing) const {
    while (above_[thing] != thing) thing = above_[thing];
    return thing;
  }
  void join(std::size_t a, std::size_t b) { above_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> above_;
};

}  // namespace

std::vector<Recurrence> recurrences(const ZoneGraph& graph) {
  const Components components(graph.classes().size(), graph.edges());
  std::vector<Recurrence> all(static_cast<std::size_t>(components.count()));
  std::vector<bool> repeats(all.size());
  std::vector<bool> entered(graph.classes().size());
  std::vector<std::set<int>> fired(all.size());
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    const auto to = static_cast<std::size_t>(components.of(edge.to));
    if (components.of(edge.from) == components.of(edge.to)) {
      repeats[to] = true;
      fired[to].insert(edge.timer);
      all[to].edges.push_back(static_cast<int>(e));
    } else {
      entered[static_cast<std::size_t>(edge.to)] = true;
    }
  }
  for (std::size_t c = 0; c < graph.classes().size(); ++c) {
    if (graph.classes()[c].parent >= 0) continue;
    entered[static_cast<std::size_t>(graph.current(static_cast<int>(c)))] = true;
  }
  for (std::size_t c = 0; c < graph.classes().size(); ++c) {
    if (graph.classes()[c].replaced_by >= 0) continue;
    Recurrence& of = all[static_cast<std::size_t>(components.of(static_cast<int>(c)))];
    of.classes.push_back(static_cast<int>(c));
    if (entered[c]) of.entries.push_back(static_cast<int>(c));
  }
  std::vector<Recurrence> found;
  for (std::size_t r = 0; r < all.size(); ++r) {
    if (!repeats[r]) continue;
    all[r].fired.assign(fired[r].begin(), fired[r].end());
    found.push_back(std::move(all[r]));
  }
  return found;
}

std::uint64_t position(const Slice& slice, const State& state) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const ThreadId t : slice.threads.ids()) {
    if (!slice.threads[t]) continue;
    const ThreadState& of = state.threads[t];
    const auto word = static_cast<std::uint64_t>(of.step + 1) << 8U | static_cast<std::uint64_t>(of.status);
    hash = (hash ^ word) * 0x100000001b3U;
    hash ^= hash >> 29U;
  }
  return hash;
}

Slice slice_of(const Machine& machine, const ZoneGraph& graph, const Recurrence& recurrence,
               ProcessorId processor) {
  const Problem& problem = machine.problem();
  const std::size_t threads = problem.threads.size();
  const std::size_t devices = problem.devices.size();
  const std::size_t channels = problem.channels.size();

  // Where each thread can be, and whether it comes and goes.
  Table<ThreadId, std::set<StepId>> steps(threads);
  Table<ThreadId, bool> off(threads);
  std::set<int> places;
  for (int c : recurrence.classes) places.insert(graph.classes()[static_cast<std::size_t>(c)].state);
  for (int p : places) {
    const State& state = graph.places()[static_cast<std::size_t>(p)].state;
    for (const ThreadId t : problem.threads.ids()) {
      if (state.threads[t].status == Status::off) {
        off[t] = true;
      } else {
        steps[t].insert(state.threads[t].at());
      }
    }
  }
  Table<ThreadId, bool> active(threads);
  for (int timer : recurrence.fired) {
    if (machine.is_of_thread(timer)) active[machine.thread_of(timer)] = true;
  }
  // Blocks that begin again and again belong to their parent and to one another.
  Groups groups(threads + devices + channels);
  for (const ThreadId t : problem.threads.ids()) {
    const ThreadId parent = problem.threads[t].parent;
    if (!parent.valid() || !off[t] || steps[t].empty()) continue;
    active[t] = active[parent] = true;
    groups.join(t.index(), parent.index());
    for (const ThreadId s : problem.threads.ids()) {
      if (problem.threads[s].parent == parent && !steps[s].empty()) {
        active[s] = true;
        groups.join(s.index(), t.index());
      }
    }
  }
  const auto device = [&](DeviceId d) { return threads + d.index(); };
  const auto channel = [&](ChannelId c) { return threads + devices + c.index(); };
  for (const ChannelId c : problem.channels.ids()) {
    const Channel& of = problem.channels[c];
    if (of.sender_device.valid()) groups.join(channel(c), device(of.sender_device));
    if (of.receiver_device.valid()) groups.join(channel(c), device(of.receiver_device));
  }
  for (const ThreadId t : problem.threads.ids()) {
    if (!active[t]) continue;
    for (const ThreadId s : problem.threads.ids()) {
      if (s == t) break;
      if (active[s] && problem.threads[s].processor == problem.threads[t].processor)
        groups.join(s.index(), t.index());
    }
    for (StepId step : steps[t]) {
      for (ChannelId c : problem.steps[step].channels) {
        groups.join(t.index(), channel(c));
        const Channel& of = problem.channels[c];
        if (of.answers.valid()) groups.join(t.index(), channel(of.answers));
        if (of.answer.valid()) groups.join(t.index(), channel(of.answer));
      }
    }
  }

  Slice slice;
  slice.threads.assign(threads, false);
  slice.channels.assign(channels, false);
  slice.devices.assign(devices, false);
  slice.left_out.assign(threads, false);
  slice.steps.assign(problem.steps.size(), false);
  slice.timers.assign(static_cast<std::size_t>(machine.timer_count()), false);
  std::size_t group = threads + devices + channels;
  for (const ThreadId t : problem.threads.ids()) {
    if (active[t] && problem.threads[t].processor == processor) group = groups.of(t.index());
  }
  if (group == threads + devices + channels) return slice;
  for (const ThreadId t : problem.threads.ids()) {
    slice.threads[t] = active[t] && groups.of(t.index()) == group;
    slice.left_out[t] = active[t] && !slice.threads[t];
    slice.timers[t.index()] = slice.threads[t];
    if (slice.threads[t]) {
      for (const StepId step : steps[t]) slice.steps[step] = true;
    }
    if (!slice.left_out[t]) continue;
    for (StepId step : steps[t]) {
      const Step& of = problem.steps[step];
      if (of.kind == Step::Kind::set)
        slice.free_conditions |= std::uint64_t{1} << static_cast<unsigned>(of.condition.index());
    }
  }
  for (const ChannelId c : problem.channels.ids()) {
    slice.channels[c] = groups.of(channel(c)) == group;
    const auto flight = static_cast<std::size_t>(machine.flight_timer(c));
    slice.timers[flight] = slice.timers[flight + 1] = slice.channels[c];
  }
  for (const DeviceId d : problem.devices.ids()) {
    slice.devices[d] = groups.of(device(d)) == group;
    slice.timers[static_cast<std::size_t>(machine.next_timer(d))] = slice.devices[d];
    slice.timers[static_cast<std::size_t>(machine.service_timer(d))] = slice.devices[d];
  }
  for (int p : places)
    slice.positions.insert(position(slice, graph.places()[static_cast<std::size_t>(p)].state));
  return slice;
}

}  // namespace pal::analyzer
