#include "analyzer/compositional/causes/cloned_blocks.hpp"

#include <map>

namespace pal::analyzer::compositional {
namespace {

class BlockCloner {
 public:
  explicit BlockCloner(const Problem& problem)
      : made_(problem), begun_(problem.threads.size()), owner_(problem.steps.size()) {
    for (const ThreadId t : problem.threads.ids()) own(t);
  }

  Problem run() {
    // Copies come behind what they are copies of, and are looked at in their turn.
    for (StepId s{0}; made_.steps.contains(s); s = StepId(s.index() + 1)) {
      if (!owner_[s].valid()) continue;
      for (std::size_t i = 0; i < made_.steps[s].threads.size(); ++i) {
        const ThreadId block = made_.steps[s].threads[i];
        if (begun_[block]) {
          const ThreadId copy = copied(block, owner_[s]);
          made_.steps[s].threads[i] = copy;
          begun_[copy] = true;
        }
        begun_[block] = true;
      }
    }
    return std::move(made_);
  }

 private:
  /// Marks the steps that the thread goes through itself.
  void own(ThreadId thread) {
    std::vector<StepId> open{made_.threads[thread].entry};
    while (!open.empty()) {
      const StepId at = open.back();
      open.pop_back();
      ThreadId& owner = owner_[at];
      if (owner == thread) continue;
      owner = thread;
      const std::vector<StepId>& next = made_.steps[at].next;
      open.insert(open.end(), next.begin(), next.end());
    }
  }

  /// The block once more, begun by `parent`. Its own blocks are still those of the first.
  ThreadId copied(ThreadId block, ThreadId parent) {
    const ThreadId copy = ThreadId(made_.threads.size());
    Thread thread = made_.threads[block];
    thread.parent = parent;
    std::map<StepId, StepId> copies;
    std::vector<StepId> open{thread.entry};
    while (!open.empty()) {
      const StepId at = open.back();
      open.pop_back();
      if (!copies.emplace(at, made_.steps.size()).second) continue;
      Step step = made_.steps[at];
      open.insert(open.end(), step.next.begin(), step.next.end());
      made_.steps.push_back(std::move(step));
      owner_.push_back(copy);
      for (Requirement& requirement : made_.requirements) {
        if (!requirement.at.empty()) requirement.at.push_back(requirement.at[at]);
      }
    }
    for (const auto& [from, to] : copies) {
      for (StepId& next : made_.steps[to].next) next = copies.at(next);
    }
    thread.entry = copies.at(thread.entry);
    made_.threads.push_back(std::move(thread));
    begun_.push_back(false);
    return copy;
  }

  Problem made_;
  Table<ThreadId, bool> begun_;
  Table<StepId, ThreadId> owner_;  // none: no thread gets there
};

}  // namespace

Problem clone_shared_blocks(const Problem& problem) {
  return BlockCloner(problem).run();
}

}  // namespace pal::analyzer::compositional
