#include "analyzer/compositional/times.hpp"

#include <algorithm>

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;
using Release = Node::Release;

constexpr int most_passes = 400;

/// Raises all times together until they agree. Each pass derives the latest releases from the latest effects,
/// and these from the work that the releases can pile up (J. C. Palencia, M. González Harbour 1998; the
/// argument that the least solution bounds every run is in docs/compositional.md).
class Solver {
 public:
  Solver(const Problem& problem, const Forest& forest, const Conduct& conduct, const std::vector<bool>& at,
         const std::function<bool()>& stop)
      : problem_(problem),
        forest_(forest),
        conduct_(conduct),
        at_(at),
        stop_(stop),
        windows_(preemptive(problem)) {}

  Times run() {
    times_.nodes.resize(forest_.nodes.size());
    times_.trouble.resize(problem_.threads.size());
    blocked_.assign(problem_.threads.size(), false);
    for (std::size_t t = 0; t < problem_.threads.size(); ++t) times_.trouble[t] = conduct_.threads[t].trouble;
    for (std::size_t n = 0; n < forest_.nodes.size(); ++n) prepare(static_cast<int>(n));
    earliest();
    for (NodeTimes& each : times_.nodes) each.latest = each.earliest;
    register_tasks();
    senders();
    do {
      solve();
      if (times_.interrupted) return std::move(times_);
    } while (find_trouble());
    sources();
    times_.windows = std::move(windows_);
    return std::move(times_);
  }

 private:
  static std::vector<bool> preemptive(const Problem& problem) {
    std::vector<bool> all;
    for (const pan::Processor& processor : problem.processors) all.push_back(processor.preemptive);
    return all;
  }
  const Node& node(int n) const { return forest_.nodes[static_cast<std::size_t>(n)]; }
  NodeTimes& times(int n) { return times_.nodes[static_cast<std::size_t>(n)]; }
  const Segment& segment(int n) const { return forest_.segment_of(node(n)); }
  const Source& source(int n) const { return forest_.sources[static_cast<std::size_t>(node(n).source)]; }
  const Step& step_at(int step) const { return problem_.steps[static_cast<std::size_t>(step)]; }
  const ThreadConduct& conduct(int thread) const {
    return conduct_.threads[static_cast<std::size_t>(thread)];
  }
  int sent_channel(int n) const { return step_at(node(n).sends.front()).channels.front(); }

  void prepare(int n) {
    const Segment& of = segment(n);
    NodeTimes& mine = times(n);
    mine.effects.assign(of.steps.size(), NodeTimes::unknown);
    mine.arrivals.assign(of.waits.size(), 0);
    for (std::size_t s = 0; s < of.steps.size(); ++s) {
      const auto step = static_cast<std::size_t>(of.steps[s].step);
      const Kind kind = problem_.steps[step].kind;
      const bool asked = at_[step] || kind == Kind::send || kind == Kind::set || kind == Kind::wait ||
                         kind == Kind::complete || may_match_nothing(problem_.steps[step]);
      if (asked) mine.effects[s] = 0;
    }
  }

  // -- the earliest ---------------------------------------------------------------------------------------

  Range device_time(int device) const {
    const auto& behaviour = problem_.devices[static_cast<std::size_t>(device)].behaviour;
    if (const auto* request = std::get_if<pan::RequestDevice>(&behaviour)) {
      return {request->answer.best.count(), request->answer.worst.count()};
    }
    if (const auto* frames = std::get_if<pan::FrameDevice>(&behaviour)) {
      return {frames->collecting.count(), frames->period.count() + frames->collecting.count()};
    }
    return {0, never};
  }

  /// Distance from the send to where its message, or the device's answer to it, can be taken.
  Range way(int n) const {
    if (node(n).device >= 0) return device_time(node(n).device);
    return latency(problem_, sent_channel(n), forest_.thread_of(node(n).cause), forest_.thread_of(n));
  }

  Nanoseconds best_arrival(int before, int wait) const {
    const Segment& of = segment(before);
    for (const Segment::Arrival& each : of.waits) {
      if (each.step == wait) return each.best;
    }
    for (const Segment::Arrival& each : of.forks) {
      if (each.step == wait) return each.best;
    }
    return 0;
  }

  Nanoseconds best_effect(int n, int step) const {
    for (const Segment::Passed& each : segment(n).steps) {
      if (each.step == step) return each.best;
    }
    return 0;
  }

  /// Lower bounds, each got from lower bounds; the last ones are the greatest.
  void earliest() {
    for (int pass = 0; pass < 50; ++pass) {
      bool changed = false;
      for (std::size_t i = 0; i < forest_.nodes.size(); ++i) {
        const int n = static_cast<int>(i);
        Nanoseconds value = 0;
        if (node(n).release == Release::message) {
          Nanoseconds sent = never;
          for (int send : node(n).sends) sent = std::min(sent, best_effect(node(n).cause, send));
          value = times(node(n).cause).earliest + sent + way(n).best;
        }
        const auto& previous = conduct_.previous[i];
        if (!previous.empty()) {
          const int wait = segment(n).beginning.step;
          Nanoseconds soonest = never;
          for (int before : previous) {
            soonest = std::min(soonest, times(before).earliest + best_arrival(before, wait));
          }
          const bool gives_up = segment(n).beginning.kind == Beginning::Kind::give_up;
          value = std::max(value, soonest + (gives_up ? step_at(wait).within.value_or(0) : 0));
        } else if (node(n).release == Release::fork) {
          value = times(node(n).cause).earliest + best_arrival(node(n).cause, node(n).cause_step);
        }
        changed = changed || value != times(n).earliest;
        times(n).earliest = value;
      }
      if (!changed) return;
    }
  }

  // -- the work of each processor -------------------------------------------------------------------------

  void register_tasks() {
    task_.resize(forest_.nodes.size());
    std::vector<Transaction> transactions(forest_.sources.size());
    for (std::size_t s = 0; s < forest_.sources.size(); ++s)
      transactions[s].period = forest_.sources[s].period;
    for (std::size_t i = 0; i < forest_.nodes.size(); ++i) {
      const int n = static_cast<int>(i);
      const Thread& thread = problem_.threads[static_cast<std::size_t>(forest_.thread_of(n))];
      auto& tasks = transactions[static_cast<std::size_t>(node(n).source)].tasks;
      task_[i] = static_cast<int>(tasks.size());
      tasks.push_back({thread.processor, thread.priority, segment(n).worst, times(n).earliest, 0});
    }
    for (Transaction& transaction : transactions) windows_.add(std::move(transaction));
    threads_on_.resize(problem_.processors.size());
    for (std::size_t t = 0; t < problem_.threads.size(); ++t) {
      threads_on_[static_cast<std::size_t>(problem_.threads[t].processor)].push_back(static_cast<int>(t));
    }
  }

  /// However late a node's causes are: what can have piled up on the way to it is one message a slot and one
  /// a thread.
  Nanoseconds greatest_jitter(int n) const {
    const Source& of = source(n);
    if (of.period == never) return never;
    return of.jitter + (2 * node(n).depth + 2) * of.period;
  }

  void announce(int n) {
    const Nanoseconds jitter = times(n).latest >= never ? never : times(n).latest - times(n).earliest;
    windows_.set_jitter(node(n).source, task_[static_cast<std::size_t>(n)],
                        std::min(jitter, greatest_jitter(n)));
  }

  /// The longest that threads of lower priority keep a processor that is not preemptive, once they have it.
  Nanoseconds blocking(int n) {
    const Thread& mine = problem_.threads[static_cast<std::size_t>(forest_.thread_of(n))];
    if (problem_.processors[static_cast<std::size_t>(mine.processor)].preemptive) return 0;
    Nanoseconds longest = 0;
    for (int t : threads_on_[static_cast<std::size_t>(mine.processor)]) {
      if (problem_.threads[static_cast<std::size_t>(t)].priority < mine.priority) {
        longest = std::max(longest, burst_[static_cast<std::size_t>(t)]);
      }
    }
    return longest;
  }

  void bursts() {
    burst_.assign(problem_.threads.size(), 0);
    for (std::size_t t = 0; t < problem_.threads.size(); ++t) {
      const int processor = problem_.threads[t].processor;
      if (!problem_.processors[static_cast<std::size_t>(processor)].preemptive) {
        burst_[t] = burst(static_cast<int>(t));
      }
    }
  }

  /// A thread goes on without a pause as long as it finds messages.
  Nanoseconds burst(int t) {
    Nanoseconds once = 0;
    Nanoseconds late = 0;
    for (int n : conduct(t).nodes) {
      once += segment(n).worst;
      late = std::max(late, times(n).finish >= never ? never : times(n).finish - times(n).earliest);
    }
    if (conduct(t).rounds.size() <= 1 &&
        (conduct(t).rounds.empty() || at_home_again(conduct(t).rounds.front()))) {
      return once;
    }
    if (once == 0) return 0;
    Nanoseconds length = once;
    for (int round = 0; round < 1'000; ++round) {
      Nanoseconds next = 0;
      for (int n : conduct(t).nodes) {
        const Transaction& of = windows_.transaction(node(n).source);
        const Nanoseconds count = BusyWindows::releases(
            of, of.tasks[static_cast<std::size_t>(task_[static_cast<std::size_t>(n)])], plus(length, late));
        if (segment(n).worst > 0 && count >= never) return never;
        next += count * segment(n).worst;
      }
      if (next <= length) return length;
      length = next;
    }
    return never;
  }

  // -- the latest -----------------------------------------------------------------------------------------

  Nanoseconds arrival(int n, int wait) {
    const Segment& of = segment(n);
    for (std::size_t w = 0; w < of.waits.size(); ++w) {
      if (of.waits[w].step == wait) return times(n).arrivals[w];
    }
    return times(n).finish;
  }

  /// When a thread is at home for the first time.
  Nanoseconds ready(int thread) {
    const ThreadConduct& of = conduct(thread);
    Nanoseconds latest = 0;
    for (int n : of.nodes) {
      const int round = conduct_.round[static_cast<std::size_t>(n)];
      const bool in_round = std::find(of.rounds.begin(), of.rounds.end(), round) != of.rounds.end();
      if (!in_round) latest = std::max(latest, arrival(n, of.home));
    }
    return latest;
  }

  Nanoseconds latest_send(int n, const std::vector<int>& sends) const {
    Nanoseconds latest = 0;
    for (int send : sends) latest = std::max(latest, latest_effect(forest_, times_, n, send));
    return latest;
  }

  Nanoseconds latest_release(int n) {
    const Node& of = node(n);
    const int thread = forest_.thread_of(n);
    if (blocked_[static_cast<std::size_t>(thread)]) return never;
    const int round = conduct_.round[static_cast<std::size_t>(n)];
    const Beginning& begins = segment(n).beginning;
    // Trouble with rounds is none before they begin.
    const bool waited = segment(round).beginning.kind == Beginning::Kind::arm ||
                        segment(round).beginning.kind == Beginning::Kind::give_up;
    if (waited && !times_.trouble[static_cast<std::size_t>(thread)].empty()) return never;
    switch (of.release) {
      case Release::root: {
        if (source(n).kind != Source::Kind::event) return 0;
        // The device is closed until its one taker is at home.
        return std::max(
            {source(n).jitter, held_back(thread), source(n).roots.size() == 1 ? 0 : ready(thread)});
      }
      case Release::fork: {
        const Nanoseconds begun = arrival(of.cause, of.cause_step);
        return begins.kind == Beginning::Kind::joined ? std::max(begun, blocks_over(of)) : begun;
      }
      case Release::limit:
        return plus(arrival(of.cause, of.cause_step), step_at(of.cause_step).within.value_or(0));
      case Release::message:
        break;
    }
    Nanoseconds latest = plus(latest_send(of.cause, of.sends), way(n).worst);
    if (of.device >= 0) latest = plus(latest, device_queue(n));
    const auto& previous = conduct_.previous[static_cast<std::size_t>(n)];
    if (previous.empty()) return round == n ? std::max({latest, ready(thread), held_back(thread)}) : never;
    for (int before : previous) latest = std::max(latest, arrival(before, begins.step));
    return latest;
  }

  /// When all blocks that a node's cause has started have ended or stopped.
  Nanoseconds blocks_over(const Node& joined) {
    Nanoseconds latest = 0;
    Nanoseconds stopping = 0;
    for (int block : step_at(joined.cause_step).threads) {
      if (!problem_.threads[static_cast<std::size_t>(block)].can_end) {
        stopping = std::max(stopping, stops_within(block));
        continue;
      }
      const bool troubled = !times_.trouble[static_cast<std::size_t>(block)].empty() ||
                            blocked_[static_cast<std::size_t>(block)];
      if (troubled || conduct(block).home >= 0 || !ends_straight(problem_, block)) return never;
      for (int n : conduct(block).nodes) {
        const Node& begun = node(conduct_.round[static_cast<std::size_t>(n)]);
        if (begun.cause == joined.cause && segment(n).ends) latest = std::max(latest, times(n).finish);
      }
    }
    return plus(latest, stopping);
  }

  /// A block that is cancelled finishes what it has begun, as do its own.
  Nanoseconds stops_within(int block) const {
    const Thread& of = problem_.threads[static_cast<std::size_t>(block)];
    Nanoseconds longest = windows_.level(of.processor, of.priority);
    for (std::size_t t = 0; t < problem_.threads.size(); ++t) {
      if (problem_.threads[t].parent == block) longest = std::max(longest, stops_within(static_cast<int>(t)));
    }
    return longest;
  }

  /// How long a request may wait for a device that answers on request.
  Nanoseconds device_queue(int n) {
    const Device& device = problem_.devices[static_cast<std::size_t>(node(n).device)];
    const int request = sent_channel(n);
    // What is asked for twice may find the answer's slot full.
    if (!conduct_.sequential[static_cast<std::size_t>(request)]) return never;
    return answer_queue(device, request);
  }

  Nanoseconds answer_queue(const Device& device, int request) const {
    const auto* behaviour = std::get_if<pan::RequestDevice>(&device.behaviour);
    if (behaviour == nullptr) return 0;
    // It takes any of those that wait: the others could be served again and again before this one.
    if (device.requests.size() > 1) return never;
    return may_withdraw(request) ? behaviour->answer.worst.count() : 0;
  }

  /// Until when a send may have to wait for its slot: the message before it is taken a period earlier than
  /// its own.
  Nanoseconds held(int n, int send) const {
    const Nanoseconds period = source(n).period;
    if (step_at(send).kind != Kind::send || period == never) return 0;
    const int channel = step_at(send).channels.front();
    if (conduct_.never_full[static_cast<std::size_t>(channel)]) return 0;
    Nanoseconds latest = 0;
    for (int effect : node(n).effects) {
      const auto& sends = node(effect).sends;
      if (node(effect).device >= 0 || std::find(sends.begin(), sends.end(), send) == sends.end()) continue;
      const Nanoseconds taken = times_.nodes[static_cast<std::size_t>(effect)].effects.front();
      latest = std::max(latest, taken >= never ? never : taken - period);
    }
    return latest;
  }

  /// A thread that was held in the last send of its round is at home that much later.
  Nanoseconds held_back(int thread) const {
    Nanoseconds latest = 0;
    for (int n : conduct(thread).nodes) {
      for (const Segment::Passed& passed : segment(n).steps) {
        const Nanoseconds until = held(n, passed.step);
        latest = std::max(latest, until >= never ? never : until - source(n).period);
      }
    }
    return latest;
  }

  bool update(int n) {
    NodeTimes& mine = times(n);
    const NodeTimes before = mine;
    mine.latest = std::max(mine.latest, latest_release(n));
    // Later than what can pile up: something on the way does not keep pace.
    if (mine.latest < never && mine.latest - mine.earliest > greatest_jitter(n)) mine.latest = never;
    announce(n);
    const Segment& of = segment(n);
    const Nanoseconds keeps = mine.latest >= never ? 0 : blocking(n);
    std::map<Nanoseconds, Nanoseconds> known;
    const auto done = [&](Nanoseconds part) {
      if (mine.latest >= never) return never;
      if (of.steps.empty()) return mine.latest;  // reaching a wait needs no processor
      const auto [place, fresh] = known.emplace(part, 0);
      if (fresh)
        place->second = windows_.finish(node(n).source, task_[static_cast<std::size_t>(n)], part, keeps);
      return place->second;
    };
    for (std::size_t s = 0; s < of.steps.size(); ++s) {
      if (mine.effects[s] == NodeTimes::unknown) continue;
      mine.effects[s] = std::max({mine.effects[s], done(of.steps[s].worst), held(n, of.steps[s].step)});
    }
    for (std::size_t w = 0; w < of.waits.size(); ++w) {
      mine.arrivals[w] = std::max(mine.arrivals[w], done(of.waits[w].worst));
    }
    mine.finish = std::max(mine.finish, done(of.worst));
    return mine.latest != before.latest || mine.finish != before.finish || mine.effects != before.effects ||
           mine.arrivals != before.arrivals;
  }

  /// Nodes whose work a change of node's release can delay stand on its processor.
  void solve() {
    for (std::size_t n = 0; n < forest_.nodes.size(); ++n) announce(static_cast<int>(n));
    std::vector<bool> dirty(problem_.processors.size(), true);
    for (int pass = 0; pass < most_passes; ++pass) {
      bursts();
      std::vector<bool> now = dirty;
      dirty.assign(dirty.size(), false);
      bool changed = false;
      for (std::size_t i = 0; i < forest_.nodes.size(); ++i) {
        const int n = static_cast<int>(i);
        if (stop_ && i % 64 == 0 && stop_()) {
          times_.interrupted = true;
          return;
        }
        const auto processor = static_cast<std::size_t>(
            problem_.threads[static_cast<std::size_t>(forest_.thread_of(n))].processor);
        const Nanoseconds latest = std::max(times(n).latest, latest_release(n));
        if (!now[processor] && latest == times(n).latest) continue;
        if (update(n)) {
          changed = true;
          dirty[processor] = true;
          now[processor] = true;
        }
      }
      if (!changed) return;
    }
    // Times that go on rising have no bound: give them up, and see what is left.
    for (std::size_t n = 0; n < forest_.nodes.size(); ++n) {
      NodeTimes& mine = times(static_cast<int>(n));
      mine.latest = mine.finish = never;
      for (Nanoseconds& each : mine.effects) each = each == NodeTimes::unknown ? each : never;
      mine.arrivals.assign(mine.arrivals.size(), never);
    }
  }

  // -- what the times rest on -----------------------------------------------------------------------------

  struct Put {
    int node;
    int step;
  };

  void senders() {
    puts_.resize(problem_.channels.size());
    for (std::size_t i = 0; i < forest_.nodes.size(); ++i) {
      for (const Segment::Passed& passed : segment(static_cast<int>(i)).steps) {
        if (step_at(passed.step).kind != Kind::send) continue;
        puts_[static_cast<std::size_t>(step_at(passed.step).channels.front())].push_back(
            {static_cast<int>(i), passed.step});
      }
    }
  }

  bool take_in_time(int n, Nanoseconds put) {
    const Source& of = source(n);
    if (of.period == never) return times(n).effects.front() < never;
    return times(n).effects.front() < plus(of.period, put);
  }

  /// Whether every message of the channel is taken before the next is put.
  bool slot_is_free(std::size_t channel) {
    const Channel& of = problem_.channels[channel];
    if (of.receiver_device >= 0 && !of.served) return true;
    if (conduct_.never_full[channel]) return true;
    const auto& puts = puts_[channel];
    if (puts.empty()) return true;
    const int n = puts.front().node;
    for (const Put& put : puts) {
      if (put.node != n) return false;
    }
    if (source(n).period == never && puts.size() == 1) return true;  // one message, ever
    for (const Put& put : puts) {
      bool taken = false;
      for (int effect : node(n).effects) {
        const auto& sends = node(effect).sends;
        if (std::find(sends.begin(), sends.end(), put.step) == sends.end()) continue;
        taken = true;
        const bool in_time = take_in_time(effect, earliest_effect(forest_, times_, n, put.step));
        if (!in_time && !may_be_held(n, put.step, effect)) return false;
      }
      if (!taken) return false;
      for (const Put& other : puts) {
        if (&other != &put && comes_after(problem_, segment(n), put.step, other.step)) return false;
      }
    }
    return true;
  }

  /// Whether it is known what a wait for the slot does: the send ends its thread's only kind of round.
  bool may_be_held(int n, int send, int taker) const {
    const ThreadConduct& of = conduct(forest_.thread_of(n));
    const Step& step = step_at(send);
    return times_.nodes[static_cast<std::size_t>(taker)].effects.front() < never && of.rounds.size() == 1 &&
           !of.waits_within && conduct_.round[static_cast<std::size_t>(n)] == of.rounds.front() &&
           step.next.front() == of.home;
  }

  /// Whether the round that `n` begins is over before the next one is asked for.
  bool at_home_again(int n) {
    const Source& of = source(n);
    if (of.kind == Source::Kind::loop && of.thread == forest_.thread_of(n) && node(n).cause < 0) return true;
    if (of.period == never) return true;
    Nanoseconds last = 0;
    for (int other : conduct(forest_.thread_of(n)).nodes) {
      if (conduct_.round[static_cast<std::size_t>(other)] == n) last = std::max(last, times(other).finish);
    }
    return last < plus(of.period, times(n).earliest);
  }

  bool find_trouble() {
    bool found = false;
    const auto say = [&](int thread, const std::string& why) {
      std::string& trouble = times_.trouble[static_cast<std::size_t>(thread)];
      if (!trouble.empty()) return;
      trouble = problem_.threads[static_cast<std::size_t>(thread)].name + " " + why;
      found = true;
    };
    for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
      if (slot_is_free(c)) continue;
      for (const Put& put : puts_[c]) {
        const int statement = step_at(put.step).statement;
        blocked_[static_cast<std::size_t>(forest_.thread_of(put.node))] = true;
        say(forest_.thread_of(put.node),
            "may find the slot full at " +
                (statement < 0 ? std::string("a send")
                               : problem_.statements[static_cast<std::size_t>(statement)].text));
      }
    }
    for (std::size_t t = 0; t < problem_.threads.size(); ++t) {
      const ThreadConduct& of = conduct_.threads[t];
      if (!of.waits_within || of.rounds.empty() || of.asked_by_one) continue;
      if (of.rounds.size() > 1) {
        say(static_cast<int>(t), "begins rounds for several reasons, and waits within them");
      } else if (!at_home_again(of.rounds.front())) {
        say(static_cast<int>(t), "may still be waiting within one round when the next is due");
      }
    }
    return found;
  }

  // -- sources --------------------------------------------------------------------------------------------

  void sources() {
    for (std::size_t s = 0; s < forest_.sources.size(); ++s) {
      const Source& of = forest_.sources[s];
      bool taken = !of.roots.empty() && of.kind == Source::Kind::event && of.roots.size() == 1;
      for (int root : of.roots) taken = taken && take_in_time(root, 0);
      times_.no_overrun.push_back(taken);
      Nanoseconds gap = never;
      Nanoseconds first = never;
      if (of.kind == Source::Kind::event && of.regular && taken) {
        gap = of.period;
        first = plus(ready(forest_.thread_of(of.roots.front())), of.period);
      } else if (of.kind == Source::Kind::loop) {
        loop_gaps(s, gap, first);
      }
      times_.longest_gap.push_back(gap);
      times_.first.push_back(first);
    }
  }

  void loop_gaps(std::size_t s, Nanoseconds& gap, Nanoseconds& first) {
    const Source& of = forest_.sources[s];
    if (!times_.trouble[static_cast<std::size_t>(of.thread)].empty()) return;
    Nanoseconds around = 0;
    Nanoseconds begin = 0;
    bool comes = false;
    const int wait = forest_.segments[of.segment].beginning.step;
    for (const Source::Feed& feed : of.feeds) {
      if (feed.node < 0) return;
      const Node& from = node(feed.node);
      const Source& by = forest_.sources[static_cast<std::size_t>(from.source)];
      Nanoseconds at = 0;
      if (feed.wait >= 0) {
        at = plus(arrival(feed.node, feed.wait), step_at(feed.wait).within.value_or(0));
      } else {
        const int channel = step_at(feed.sends.front()).channels.front();
        at = latest_send(feed.node, feed.sends);
        if (feed.device >= 0) {
          const bool one = conduct_.sequential[static_cast<std::size_t>(channel)];
          at = plus(at, device_time(feed.device).worst);
          at = plus(at, one ? answer_queue(problem_.devices[static_cast<std::size_t>(feed.device)], channel)
                            : never);
        } else {
          at = plus(at, latency(problem_, channel, forest_.thread_of(feed.node), of.thread).worst);
        }
      }
      if (from.source == static_cast<int>(s)) {
        around = std::max(around, at);
        comes = true;
      } else if (by.kind == Source::Kind::start) {
        begin = std::max(begin, at);
      } else {
        return;
      }
    }
    if (!comes) return;
    // The thread itself must be back, too.
    for (int n : conduct(of.thread).nodes) {
      for (std::size_t w = 0; w < segment(n).waits.size(); ++w) {
        if (segment(n).waits[w].step != wait) continue;
        if (node(n).source == static_cast<int>(s)) around = std::max(around, times(n).arrivals[w]);
        if (source(n).kind == Source::Kind::start) begin = std::max(begin, times(n).arrivals[w]);
      }
    }
    gap = around;
    first = begin;
  }

  bool may_withdraw(int request) const {
    const int answer = problem_.channels[static_cast<std::size_t>(request)].answer;
    return std::any_of(problem_.steps.begin(), problem_.steps.end(), [&](const Step& step) {
      return step.kind == Kind::wait && step.within &&
             std::find(step.channels.begin(), step.channels.end(), answer) != step.channels.end();
    });
  }

  const Problem& problem_;
  const Forest& forest_;
  const Conduct& conduct_;
  const std::vector<bool>& at_;
  const std::function<bool()>& stop_;
  BusyWindows windows_;
  std::vector<int> task_;
  std::vector<bool> blocked_;  // by thread: it may have to wait in a send
  std::vector<std::vector<int>> threads_on_;
  std::vector<Nanoseconds> burst_;
  std::vector<std::vector<Put>> puts_;
  Times times_;
};

std::size_t place_of(const Segment& segment, int step) {
  for (std::size_t s = 0; s < segment.steps.size(); ++s) {
    if (segment.steps[s].step == step) return s;
  }
  return segment.steps.size();
}

}  // namespace

Times times_of(const Problem& problem, const Forest& forest, const Conduct& conduct,
               const std::vector<bool>& at, const std::function<bool()>& stop) {
  return Solver(problem, forest, conduct, at, stop).run();
}

Nanoseconds latest_effect(const Forest& forest, const Times& times, int node, int step) {
  const std::size_t place = place_of(forest.segment_of(forest.nodes[static_cast<std::size_t>(node)]), step);
  const auto& effects = times.nodes[static_cast<std::size_t>(node)].effects;
  return place < effects.size() && effects[place] != NodeTimes::unknown ? effects[place] : never;
}

Nanoseconds earliest_effect(const Forest& forest, const Times& times, int node, int step) {
  const Segment& segment = forest.segment_of(forest.nodes[static_cast<std::size_t>(node)]);
  const std::size_t place = place_of(segment, step);
  return times.nodes[static_cast<std::size_t>(node)].earliest +
         (place < segment.steps.size() ? segment.steps[place].best : 0);
}

}  // namespace pal::analyzer::compositional
