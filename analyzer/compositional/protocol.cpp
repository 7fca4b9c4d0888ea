// Who asks whom, and when: the protocol of requests and answers.
#include <algorithm>

#include "analyzer/compositional/forest.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

/// Greatest number of requests of one channel that are open when a module reaches its steps: 0, 1, or 2 for
/// more.
class OpenRequests {
 public:
  OpenRequests(const Problem& problem, int request)
      : problem_(problem),
        request_(request),
        answer_(problem.channels[static_cast<std::size_t>(request)].answer) {}

  /// False: a request is sent while one is open, perhaps.
  bool sequential() {
    const int module = problem_.channels[static_cast<std::size_t>(request_)].sender_module;
    for (const Thread& thread : problem_.threads) {
      if (thread.module == module && thread.parent < 0) reach(thread.entry, 0);
    }
    bool sound = true;
    while (!work_.empty()) {
      const int at = work_.back();
      work_.pop_back();
      sound = pass(at) && sound;
    }
    return sound;
  }

  int at(int step) const {
    const auto known = open_.find(step);
    return known == open_.end() ? 0 : known->second;
  }

 private:
  void reach(int step, int open) {
    const auto [place, fresh] = open_.emplace(step, open);
    if (!fresh && place->second >= open) return;
    place->second = std::max(place->second, open);
    work_.push_back(step);
  }

  bool pass(int index) {
    const Step& step = problem_.steps[static_cast<std::size_t>(index)];
    const int open = open_.at(index);
    switch (step.kind) {
      case Kind::send: {
        const bool asks = step.channels.front() == request_;
        reach(step.next.front(), asks ? 1 : open);
        return !asks || open == 0;
      }
      case Kind::wait: {
        bool waits = false;
        for (std::size_t arm = 0; arm < step.channels.size(); ++arm) {
          const bool answered = step.channels[arm] == answer_;
          waits = waits || answered;
          reach(step.next[arm], answered ? 0 : open);
        }
        if (step.within) reach(step.next.back(), waits ? 0 : open);
        return true;
      }
      case Kind::fork: {
        int asking = 0;
        for (int block : step.threads) {
          reach(problem_.threads[static_cast<std::size_t>(block)].entry, open);
          if (asks(block)) ++asking;
        }
        // Two blocks that ask may both have a request open; one that is cancelled leaves it to be answered.
        if (asking == 0) reach(step.next.front(), open);
        const bool stopped = std::any_of(step.threads.begin(), step.threads.end(), [this](int block) {
          return asks(block) && !problem_.threads[static_cast<std::size_t>(block)].can_end;
        });
        if (stopped) reach(step.next.front(), 2);
        return asking < 2;
      }
      case Kind::end: {
        const int fork = fork_of_end(index);
        if (fork >= 0) reach(problem_.steps[static_cast<std::size_t>(fork)].next.front(), open);
        return true;
      }
      default:
        for (int next : step.next) reach(next, open);
        return true;
    }
  }

  /// The CONCURRENT of the block that ends at a step, if that block asks; -1: there is none.
  int fork_of_end(int end) const {
    for (std::size_t s = 0; s < problem_.steps.size(); ++s) {
      for (int block : problem_.steps[s].threads) {
        if (asks(block) && reaches(block, end)) return static_cast<int>(s);
      }
    }
    return -1;
  }

  bool reaches(int thread, int step) const {
    std::set<int> seen;
    std::vector<int> open{problem_.threads[static_cast<std::size_t>(thread)].entry};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      if (at == step) return true;
      if (!seen.insert(at).second) continue;
      const auto& next = problem_.steps[static_cast<std::size_t>(at)].next;
      open.insert(open.end(), next.begin(), next.end());
    }
    return false;
  }

  bool asks(int thread) const {
    std::set<int> seen;
    std::vector<int> open{problem_.threads[static_cast<std::size_t>(thread)].entry};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      if (!seen.insert(at).second) continue;
      const Step& step = problem_.steps[static_cast<std::size_t>(at)];
      if (step.kind == Kind::send && step.channels.front() == request_) return true;
      for (int block : step.threads) open.push_back(problem_.threads[static_cast<std::size_t>(block)].entry);
      open.insert(open.end(), step.next.begin(), step.next.end());
    }
    return false;
  }

  const Problem& problem_;
  int request_;
  int answer_;
  std::map<int, int> open_;
  std::vector<int> work_;
};

/// Whether a thread, or a block of it, takes the request or sends the answer.
bool talks(const Problem& problem, int thread, int request, int answer) {
  std::set<int> seen;
  std::vector<int> open{problem.threads[static_cast<std::size_t>(thread)].entry};
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    if (!seen.insert(at).second) continue;
    const Step& step = problem.steps[static_cast<std::size_t>(at)];
    if (step.kind == Kind::send && step.channels.front() == answer) return true;
    if (step.kind == Kind::wait &&
        std::find(step.channels.begin(), step.channels.end(), request) != step.channels.end()) {
      return true;
    }
    for (int block : step.threads) open.push_back(problem.threads[static_cast<std::size_t>(block)].entry);
    open.insert(open.end(), step.next.begin(), step.next.end());
  }
  return false;
}

/// Whether a module sends one answer to each request that it takes, before it takes the next.
bool answers_once(const Problem& problem, int answer) {
  const Channel& channel = problem.channels[static_cast<std::size_t>(answer)];
  const int request = channel.answers;
  std::map<int, unsigned> owed;  // bits: none, one, more
  std::vector<int> work;
  const auto reach = [&](int step, unsigned values) {
    unsigned& there = owed[step];
    if ((there | values) == there) return;
    there |= values;
    work.push_back(step);
  };
  for (const Thread& thread : problem.threads) {
    if (thread.module == channel.sender_module && thread.parent < 0) reach(thread.entry, 1);
  }
  while (!work.empty()) {
    const int at = work.back();
    work.pop_back();
    const Step& step = problem.steps[static_cast<std::size_t>(at)];
    const unsigned values = owed.at(at);
    if (step.kind == Kind::send && step.channels.front() == answer) {
      if (values != 2) return false;
      reach(step.next.front(), 1);
      continue;
    }
    int serving = 0;
    for (int block : step.threads) {
      if (!talks(problem, block, request, answer)) continue;
      reach(problem.threads[static_cast<std::size_t>(block)].entry, values);
      ++serving;
    }
    // A block may be cancelled, or end, owing an answer: nobody gives it.
    if (serving > 1 || (serving == 1 && values != 1)) return false;
    for (std::size_t i = 0; i < step.next.size(); ++i) {
      const bool takes = step.kind == Kind::wait && i < step.channels.size() && step.channels[i] == request;
      reach(step.next[i], takes ? (values & 6U) != 0 ? 6U : 2U : values);
    }
  }
  return true;
}

/// The CONCURRENT that starts each thread; -1: none.
std::vector<int> forks_of(const Problem& problem) {
  std::vector<int> started_by(problem.threads.size(), -1);
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    for (int block : problem.steps[s].threads)
      started_by[static_cast<std::size_t>(block)] = static_cast<int>(s);
  }
  return started_by;
}

/// Whether two threads are, or are below, two blocks of one CONCURRENT.
bool side_by_side(const Problem& problem, const std::vector<int>& started_by, int one, int other) {
  for (int a = one; a >= 0; a = problem.threads[static_cast<std::size_t>(a)].parent) {
    for (int b = other; b >= 0; b = problem.threads[static_cast<std::size_t>(b)].parent) {
      const int fork = started_by[static_cast<std::size_t>(a)];
      if (a != b && fork >= 0 && fork == started_by[static_cast<std::size_t>(b)]) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<bool> withdrawn_requests(const Problem& problem) {
  std::vector<bool> withdrawn(problem.channels.size());
  for (const Step& step : problem.steps) {
    if (step.kind != Kind::wait || !step.within) continue;
    for (int channel : step.channels) {
      const int request = problem.channels[static_cast<std::size_t>(channel)].answers;
      if (request >= 0) withdrawn[static_cast<std::size_t>(request)] = true;
    }
  }
  for (const Step& fork : problem.steps) {
    const auto ends = [&problem](int block) {
      return problem.threads[static_cast<std::size_t>(block)].can_end;
    };
    if (std::none_of(fork.threads.begin(), fork.threads.end(), ends)) continue;
    std::set<int> seen;
    std::vector<int> open;
    for (int block : fork.threads) {
      if (!ends(block)) open.push_back(problem.threads[static_cast<std::size_t>(block)].entry);
    }
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      if (!seen.insert(at).second) continue;
      const Step& step = problem.steps[static_cast<std::size_t>(at)];
      if (step.kind == Kind::send &&
          problem.channels[static_cast<std::size_t>(step.channels.front())].answer >= 0)
        withdrawn[static_cast<std::size_t>(step.channels.front())] = true;
      for (int block : step.threads) open.push_back(problem.threads[static_cast<std::size_t>(block)].entry);
      open.insert(open.end(), step.next.begin(), step.next.end());
    }
  }
  return withdrawn;
}

std::vector<bool> shared_requests(const Problem& problem) {
  std::vector<std::set<int>> users(problem.channels.size());
  for (std::size_t t = 0; t < problem.threads.size(); ++t) {
    std::set<int> seen;
    std::vector<int> open{problem.threads[t].entry};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      if (!seen.insert(at).second) continue;
      const Step& step = problem.steps[static_cast<std::size_t>(at)];
      open.insert(open.end(), step.next.begin(), step.next.end());
      for (int channel : step.channels) {
        const Channel& of = problem.channels[static_cast<std::size_t>(channel)];
        if (step.kind == Kind::send && of.answer >= 0)
          users[static_cast<std::size_t>(channel)].insert(static_cast<int>(t));
        if (step.kind == Kind::wait && of.answers >= 0)
          users[static_cast<std::size_t>(of.answers)].insert(static_cast<int>(t));
      }
    }
  }
  const std::vector<int> started_by = forks_of(problem);
  std::vector<bool> shared(problem.channels.size());
  for (std::size_t c = 0; c < shared.size(); ++c) {
    for (int one : users[c]) {
      shared[c] = shared[c] || std::any_of(users[c].begin(), users[c].end(), [&](int other) {
                    return side_by_side(problem, started_by, one, other);
                  });
    }
  }
  return shared;
}

std::vector<bool> sequential_requests(const Problem& problem) {
  std::vector<bool> sequential(problem.channels.size());
  const std::vector<bool> shared = shared_requests(problem);
  for (std::size_t c = 0; c < problem.channels.size(); ++c) {
    const Channel& channel = problem.channels[c];
    if (channel.answer < 0 || channel.sender_module < 0 || shared[c]) continue;
    const bool device = problem.channels[static_cast<std::size_t>(channel.answer)].sender_module < 0;
    sequential[c] = (device || answers_once(problem, channel.answer)) &&
                    OpenRequests(problem, static_cast<int>(c)).sequential();
  }
  return sequential;
}

std::optional<std::set<int>> takers_of_answer(const Problem& problem, int send) {
  const int request = problem.steps[static_cast<std::size_t>(send)].channels.front();
  const int answer = problem.channels[static_cast<std::size_t>(request)].answer;
  std::set<int> takers;
  std::set<int> seen;
  std::vector<int> open = problem.steps[static_cast<std::size_t>(send)].next;
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    if (!seen.insert(at).second) continue;
    const Step& step = problem.steps[static_cast<std::size_t>(at)];
    // Blocks, or what comes after them, may take it.
    if (step.kind == Kind::fork || step.kind == Kind::end) return {};
    if (step.kind == Kind::send && step.channels.front() == request) continue;
    const bool waits = step.kind == Kind::wait &&
                       std::find(step.channels.begin(), step.channels.end(), answer) != step.channels.end();
    if (waits) takers.insert(at);
    for (std::size_t i = 0; i < step.next.size(); ++i) {
      const bool taken = waits && i < step.channels.size() && step.channels[i] == answer;
      const bool withdrawn = waits && i == step.channels.size();
      if (!taken && !withdrawn) open.push_back(step.next[i]);
    }
  }
  return takers;
}

}  // namespace pal::analyzer::compositional
