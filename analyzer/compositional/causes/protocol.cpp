#include "analyzer/compositional/causes/protocol.hpp"

#include <algorithm>
#include <iterator>

#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

using Kind = Step::Kind;

bool takes(const Step& step, ChannelId channel) {
  return step.kind == Kind::wait &&
         std::find(step.channels.begin(), step.channels.end(), channel) != step.channels.end();
}

bool sends(const Step& step, ChannelId channel) {
  return step.kind == Kind::send && step.channels.front() == channel;
}

StepId entry_of(const Problem& problem, ThreadId thread) {
  return problem.threads[thread].entry;
}

/// Whether the flow comes from a step to such a one.
template <class Such>
bool comes_to(const Problem& problem, StepId from, const Such& such) {
  return follow(problem, {from},
                [&](StepId at) { return such(problem.steps[at]) ? Course::found : Course::goes_on; });
}

/// That, or a block that it begins.
template <class Such>
bool comes_below_to(const Problem& problem, StepId from, const Such& such) {
  return comes_to(problem, from, [&](const Step& step) {
    const auto in_block = [&](ThreadId block) {
      return comes_below_to(problem, entry_of(problem, block), such);
    };
    return such(step) || std::any_of(step.threads.begin(), step.threads.end(), in_block);
  });
}

/// Whether a module sends one answer to each request that it takes, in the thread that has taken it, before
/// it takes the next.
class Answers {
 public:
  Answers(const Problem& problem, ChannelId answer)
      : problem_(problem), answer_(answer), request_(problem.channels[answer].answers) {}

  bool once() {
    const pan::ModuleId module = problem_.channels[answer_].sender_module;
    for (const Thread& thread : problem_.threads) {
      if (thread.module == module && !thread.parent.valid()) reach(thread.entry, none);
    }
    while (!work_.empty()) {
      const StepId at = work_.back();
      work_.pop_back();
      if (!pass(at)) return false;
    }
    return true;
  }

 private:
  /// Whether an answer may be owed, or none: any of these.
  enum Owed : unsigned { none = 1, one = 2 };

  void reach(StepId step, unsigned owed) {
    unsigned& there = owed_[step];
    if ((there | owed) == there) return;
    there |= owed;
    work_.push_back(step);
  }

  bool pass(StepId at) {
    const Step& step = problem_.steps[at];
    const unsigned owed = owed_.at(at);
    if (sends(step, answer_)) {
      reach(step.next.front(), none);
      return owed == one;
    }
    if (step.kind == Kind::fork) return begin_blocks(step, owed);
    if (step.kind == Kind::end && after_.contains(at)) reach(after_.at(at), owed);
    if ((step.kind == Kind::end || takes(step, request_)) && owed != none) return false;
    for (std::size_t i = 0; i < step.next.size(); ++i) {
      const bool taken = step.kind == Kind::wait && i < step.channels.size() && step.channels[i] == request_;
      reach(step.next[i], taken ? one : owed);
    }
    return true;
  }

  /// One of them may serve, if nothing is owed; a cancelled one may leave an answer owed.
  bool begin_blocks(const Step& fork, unsigned owed) {
    ThreadId serving{};
    for (ThreadId block : fork.threads) {
      const auto talks = [this](const Step& step) { return sends(step, answer_) || takes(step, request_); };
      if (!comes_to(problem_, entry_of(problem_, block), talks)) continue;
      if (serving.valid() || owed != none) return false;
      serving = block;
    }
    const StepId after = fork.next.front();
    if (!serving.valid()) {
      reach(after, owed);
      return true;
    }
    follow(problem_, {entry_of(problem_, serving)}, [&](StepId at) {
      if (problem_.steps[at].kind == Kind::end) after_[at] = after;
      return Course::goes_on;
    });
    const auto ends = [this](ThreadId block) { return problem_.threads[block].can_end; };
    const bool cancelled = !ends(serving) && std::any_of(fork.threads.begin(), fork.threads.end(), ends);
    if (cancelled) reach(after, none | one);
    reach(entry_of(problem_, serving), owed);
    return true;
  }

  const Problem& problem_;
  ChannelId answer_;
  ChannelId request_;
  std::map<StepId, unsigned> owed_;
  std::map<StepId, StepId> after_;  // what follows the end of a block that serves
  std::vector<StepId> work_;
};

/// Whether blocks of one CONCURRENT send a request, or wait for its answer, beside one another. So one may
/// take what another asked for, or withdraw what another is about to take.
bool is_shared(const Problem& problem, ChannelId request) {
  const ChannelId answer = problem.channels[request].answer;
  const auto uses = [&](ThreadId block) {
    return comes_to(problem, entry_of(problem, block),
                    [&](const Step& step) { return sends(step, request) || takes(step, answer); });
  };
  return std::any_of(problem.steps.begin(), problem.steps.end(), [&uses](const Step& fork) {
    return std::count_if(fork.threads.begin(), fork.threads.end(), uses) > 1;
  });
}

/// The ways on from a request, in its thread, until its answer is taken or it is withdrawn.
class Asked {
 public:
  Asked(const Problem& problem, StepId send) {
    const ChannelId request = problem.steps[send].channels.front();
    const ChannelId answer = problem.channels[request].answer;
    std::set<StepId> seen;
    std::vector<StepId> open = problem.steps[send].next;
    while (!open.empty()) {
      const StepId at = open.back();
      open.pop_back();
      if (!seen.insert(at).second) continue;
      const Step& step = problem.steps[at];
      again_ = again_ || sends(step, request);
      elsewhere_ = elsewhere_ || step.kind == Kind::fork || step.kind == Kind::end;
      const bool waits = takes(step, answer);
      if (waits) takers_.insert(at);
      for (std::size_t i = 0; i < step.next.size(); ++i) {
        const bool taken = waits && i < step.channels.size() && step.channels[i] == answer;
        const bool withdrawn = waits && i == step.channels.size();
        if (!taken && !withdrawn) open.push_back(step.next[i]);
      }
    }
  }

  /// The waits that may take the answer.
  const std::set<StepId>& takers() const { return takers_; }
  /// The request may be sent again before.
  bool again() const { return again_; }
  /// The thread may begin blocks, or end, before.
  bool elsewhere() const { return elsewhere_; }

 private:
  std::set<StepId> takers_;
  bool again_ = false;
  bool elsewhere_ = false;
};

/// The blocks of a CONCURRENT that are cancelled when the others have ended.
std::vector<ThreadId> cancelled_blocks(const Problem& problem, const Step& fork) {
  const auto loops = [&problem](ThreadId block) { return !problem.threads[block].can_end; };
  std::vector<ThreadId> blocks;
  std::copy_if(fork.threads.begin(), fork.threads.end(), std::back_inserter(blocks), loops);
  return blocks.size() < fork.threads.size() ? blocks : std::vector<ThreadId>{};
}

/// Whether a request may be sent after a block that sent it was cancelled: that may still be served.
bool asked_after_cancelled(const Problem& problem, ChannelId request) {
  const auto asks = [request](const Step& step) { return sends(step, request); };
  return std::any_of(problem.steps.begin(), problem.steps.end(), [&](const Step& fork) {
    const std::vector<ThreadId> cancelled = cancelled_blocks(problem, fork);
    const bool asked = std::any_of(cancelled.begin(), cancelled.end(), [&](ThreadId block) {
      return comes_to(problem, entry_of(problem, block), asks);
    });
    return asked && comes_below_to(problem, fork.next.front(), asks);
  });
}

}  // namespace

std::set<StepId> takers_of_answer(const Problem& problem, StepId send) {
  return Asked(problem, send).takers();
}

namespace {

/// Of a request, whoever sends it. Also if no thread comes to send it: its answer counts as one all the same.
Why why_of_request(const Problem& problem, ChannelId c, const SetAside& set_aside) {
  const Channel& request = problem.channels[c];
  const std::string who = receiver_name(problem, c);
  if (request.receiver_device.valid()) {
    if (!set_aside.has(Withheld::asked_although_it_comes) && !request.served)
      return why(Withheld::asked_although_it_comes, who, request.message);
    return {};
  }
  if (!set_aside.has(Withheld::not_answered_once) && !Answers(problem, request.answer).once())
    return why(Withheld::not_answered_once, who, request.message);
  return {};
}

/// Of a send of a request.
Why why_of_send(const Problem& problem, StepId send, const std::string& who, const SetAside& set_aside) {
  const ChannelId request = problem.steps[send].channels.front();
  const Asked asked(problem, send);
  const std::string& message = problem.channels[request].message;
  const std::string of = receiver_name(problem, request);
  if (!set_aside.has(Withheld::asked_again) && asked.again())
    return why(Withheld::asked_again, who, message, of);
  if (!set_aside.has(Withheld::answered_elsewhere) && asked.elsewhere())
    return why(Withheld::answered_elsewhere, who, message, of);
  return {};
}

/// Of all sends of a request.
Why why_of_sends(const Problem& problem, ChannelId request, const std::string& who,
                 const SetAside& set_aside) {
  const std::string& message = problem.channels[request].message;
  const std::string of = receiver_name(problem, request);
  if (!set_aside.has(Withheld::asked_beside) && is_shared(problem, request))
    return why(Withheld::asked_beside, message, of);
  if (!set_aside.has(Withheld::asked_after_cancelled) && asked_after_cancelled(problem, request))
    return why(Withheld::asked_after_cancelled, who, message, of);
  return {};
}

}  // namespace

Why out_of_turn(const Problem& problem, const Segments& segments, const std::function<bool()>& stop,
                const SetAside& set_aside) {
  for (const ChannelId c : problem.channels.ids()) {
    if (!problem.channels[c].answer.valid()) continue;
    if (stop && stop()) return {};
    if (Why found = why_of_request(problem, c, set_aside); !found.empty()) return found;
  }
  std::set<ChannelId> seen;
  for (const StepId s : problem.steps.ids()) {
    const Step& step = problem.steps[s];
    const ThreadId owner = segments.owner(s);
    if (!owner.valid() || step.kind != Step::Kind::send) continue;
    const ChannelId request = step.channels.front();
    if (!problem.channels[request].answer.valid()) continue;
    if (stop && stop()) return {};
    const std::string& who = problem.threads[owner].name;
    if (Why found = why_of_send(problem, s, who, set_aside); !found.empty()) return found;
    if (!seen.insert(request).second) continue;
    if (Why found = why_of_sends(problem, request, who, set_aside); !found.empty()) return found;
  }
  return {};
}

}  // namespace pal::analyzer::compositional
