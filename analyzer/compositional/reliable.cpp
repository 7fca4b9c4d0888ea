// Which threads always come home.
#include <algorithm>

#include "analyzer/compositional/measures.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

class Reliability {
 public:
  explicit Reliability(const View& view) : view_(view), problem_(view.problem) {}

  /// The greatest set of threads each of which relies on members alone.
  std::vector<bool> run() {
    const std::size_t count = problem_.threads.size();
    std::vector<std::vector<int>> relies(count);
    reliable_.assign(count, false);
    for (std::size_t t = 0; t < count; ++t) {
      const ThreadConduct& of = view_.conduct.threads[t];
      reliable_[t] = of.home >= 0 && !of.leaves && view_.times.trouble[t].empty() &&
                     servers(static_cast<int>(t), relies[t]);
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t t = 0; t < count; ++t) {
        const bool sound = std::all_of(relies[t].begin(), relies[t].end(), [&](int other) {
          return reliable_[static_cast<std::size_t>(other)] &&
                 !view_.conduct.threads[static_cast<std::size_t>(other)].may_be_cancelled;
        });
        if (!reliable_[t] || sound) continue;
        reliable_[t] = false;
        changed = true;
      }
    }
    return reliable_;
  }

 private:
  const Step& step_at(int step) const { return problem_.steps[static_cast<std::size_t>(step)]; }

  /// The threads that answer what `thread` waits for; false: something that it waits for may never come.
  bool servers(int thread, std::vector<int>& relies) const {
    const ThreadConduct& of = view_.conduct.threads[static_cast<std::size_t>(thread)];
    std::set<int> waits;
    for (int n : of.nodes) {
      const Node& node = view_.forest.nodes[static_cast<std::size_t>(n)];
      for (const Segment::Arrival& wait : view_.forest.segment_of(node).waits) waits.insert(wait.step);
    }
    for (int n : of.nodes) {
      const Node& node = view_.forest.nodes[static_cast<std::size_t>(n)];
      for (int effect : node.effects) {
        // A message that nobody takes would stop its sender, sooner or later.
        const Node& taker = view_.forest.nodes[static_cast<std::size_t>(effect)];
        if (taker.release != Node::Release::message || taker.device >= 0) continue;
        const int channel = step_at(taker.sends.front()).channels.front();
        if (view_.conduct.never_full[static_cast<std::size_t>(channel)]) continue;
        relies.push_back(view_.forest.thread_of(effect));
      }
    }
    for (int wait : waits) {
      const Step& step = step_at(wait);
      if (step.within || (wait == of.home && !goes_on_by_itself(of))) continue;
      if (step.channels.size() != 1) return false;
      const int answer = step.channels.front();
      const Channel& channel = problem_.channels[static_cast<std::size_t>(answer)];
      if (channel.answers < 0 || !view_.conduct.sequential[static_cast<std::size_t>(channel.answers)])
        return false;
      if (!surely_asked(thread, wait, channel.answers, answer)) return false;
      if (channel.sender_device >= 0) {
        if (std::holds_alternative<pan::EventDevice>(
                problem_.devices[static_cast<std::size_t>(channel.sender_device)].behaviour)) {
          return false;
        }
        continue;
      }
      if (!view_.conduct.never_full[static_cast<std::size_t>(answer)]) return false;
      const int server = taker_of(channel.answers);
      if (server < 0) return false;
      relies.push_back(server);
    }
    return true;
  }

  bool goes_on_by_itself(const ThreadConduct& of) const {
    return std::any_of(of.rounds.begin(), of.rounds.end(), [&](int n) {
      const Node& node = view_.forest.nodes[static_cast<std::size_t>(n)];
      return view_.forest.sources[static_cast<std::size_t>(node.source)].kind == Source::Kind::loop &&
             node.cause < 0;
    });
  }

  /// The one thread that takes a request, at home; -1: there is none.
  int taker_of(int request) const {
    int server = -1;
    for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
      const Step& step = problem_.steps[s];
      if (step.kind != Kind::wait) continue;
      if (std::find(step.channels.begin(), step.channels.end(), request) == step.channels.end()) continue;
      const int owner = view_.forest.segments.owner(static_cast<int>(s));
      if (owner < 0) continue;
      if (server >= 0 || view_.conduct.threads[static_cast<std::size_t>(owner)].home != static_cast<int>(s))
        return -1;
      server = owner;
    }
    return server;
  }

  /// Whether the thread has sent the request, and not taken the answer, whenever it comes to the wait.
  bool surely_asked(int thread, int wait, int request, int answer) const {
    std::vector<int> open{problem_.threads[static_cast<std::size_t>(thread)].entry};
    for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
      const Step& step = problem_.steps[s];
      if (view_.forest.segments.owner(static_cast<int>(s)) != thread || step.kind != Kind::wait) continue;
      for (std::size_t arm = 0; arm < step.channels.size(); ++arm) {
        if (step.channels[arm] != answer) continue;
        open.push_back(step.next[arm]);
        if (step.within) open.push_back(step.next.back());
      }
    }
    std::set<int> seen;
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      if (at == wait) return false;
      const Step& step = step_at(at);
      if ((step.kind == Kind::send && step.channels.front() == request) || !seen.insert(at).second) continue;
      open.insert(open.end(), step.next.begin(), step.next.end());
    }
    return true;
  }

  const View view_;
  const Problem& problem_;
  std::vector<bool> reliable_;
};

}  // namespace

std::vector<bool> reliable_threads(const Problem& problem, const Forest& forest, const Conduct& conduct,
                                   const Times& times) {
  const std::vector<bool> none;
  return Reliability({problem, forest, conduct, times, none}).run();
}

}  // namespace pal::analyzer::compositional
