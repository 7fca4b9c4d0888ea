// Sets of threads by number: a search meets few different ones, in many states.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "pal/check/deadlock/threads.hpp"

namespace pal::check::deadlock {

class ThreadSets {
 public:
  /// 0 is the number of the empty set.
  ThreadSets() { number_of({}); }

  std::uint32_t number_of(const Threads& set) {
    const auto [entry, fresh] = numbers_.emplace(set, static_cast<std::uint32_t>(sets_.size()));
    if (fresh) sets_.push_back(set);
    return entry->second;
  }
  const Threads& operator[](std::uint32_t number) const { return sets_[number]; }

  /// The number of the set with these threads more.
  std::uint32_t with(std::uint32_t number, const Threads& more) {
    const Threads all = sets_[number] | more;
    return all == sets_[number] ? number : number_of(all);
  }

 private:
  std::vector<Threads> sets_;
  std::unordered_map<Threads, std::uint32_t> numbers_;
};

}  // namespace pal::check::deadlock
