#include "analyzer/compositional/causes/cloned_blocks.hpp"

#include <map>

namespace pal::analyzer::compositional {
namespace {

class BlockCloner {
 public:
  explicit BlockCloner(const Problem& problem)
      : made_(problem), begun_(problem.threads.size()), owner_(problem.steps.size(), -1) {
    for (std::size_t t = 0; t < problem.threads.size(); ++t) own(static_cast<int>(t));
  }

  Problem run() {
    // Copies come behind what they are copies of, and are looked at in their turn.
    for (std::size_t s = 0; s < made_.steps.size(); ++s) {
      if (owner_[s] < 0) continue;
      for (std::size_t i = 0; i < made_.steps[s].threads.size(); ++i) {
        const int block = made_.steps[s].threads[i];
        if (begun_[static_cast<std::size_t>(block)]) {
          const int copy = copied(block, owner_[s]);
          made_.steps[s].threads[i] = copy;
          begun_[static_cast<std::size_t>(copy)] = true;
        }
        begun_[static_cast<std::size_t>(block)] = true;
      }
    }
    return std::move(made_);
  }

 private:
  /// Marks the steps that the thread goes through itself.
  void own(int thread) {
    std::vector<int> open{made_.threads[static_cast<std::size_t>(thread)].entry};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      int& owner = owner_[static_cast<std::size_t>(at)];
      if (owner == thread) continue;
      owner = thread;
      const std::vector<int>& next = made_.steps[static_cast<std::size_t>(at)].next;
      open.insert(open.end(), next.begin(), next.end());
    }
  }

  /// The block once more, begun by `parent`. Its own blocks are still those of the first.
  int copied(int block, int parent) {
    const int copy = static_cast<int>(made_.threads.size());
    Thread thread = made_.threads[static_cast<std::size_t>(block)];
    thread.parent = parent;
    std::map<int, int> copies;
    std::vector<int> open{thread.entry};
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      if (!copies.emplace(at, static_cast<int>(made_.steps.size())).second) continue;
      Step step = made_.steps[static_cast<std::size_t>(at)];
      open.insert(open.end(), step.next.begin(), step.next.end());
      made_.steps.push_back(std::move(step));
      owner_.push_back(copy);
      for (Requirement& requirement : made_.requirements) {
        if (!requirement.at.empty()) requirement.at.push_back(requirement.at[static_cast<std::size_t>(at)]);
      }
    }
    for (const auto& [from, to] : copies) {
      for (int& next : made_.steps[static_cast<std::size_t>(to)].next) next = copies.at(next);
    }
    thread.entry = copies.at(thread.entry);
    made_.threads.push_back(std::move(thread));
    begun_.push_back(false);
    return copy;
  }

  Problem made_;
  std::vector<bool> begun_;  // by thread
  std::vector<int> owner_;   // by step; -1: no thread gets there
};

}  // namespace

Problem clone_shared_blocks(const Problem& problem) {
  return BlockCloner(problem).run();
}

}  // namespace pal::analyzer::compositional
