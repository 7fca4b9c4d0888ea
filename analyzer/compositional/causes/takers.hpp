// Who takes which message.
#pragma once

#include <set>
#include <vector>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// A branch of a wait that takes messages from a channel.
struct Taker {
  int thread;
  int step;
  int arm;
};

class Takers {
 public:
  Takers(const Problem& problem, const Segments& segments);

  /// All that take from a channel.
  const std::vector<Taker>& of(int channel) const { return takers_[static_cast<std::size_t>(channel)]; }

  /// The waits that may take the answers to what `sends` ask for.
  std::set<int> after(const std::vector<int>& sends) const;

  /// Whether on all ways of a thread to each of `steps` the last request is taken at `wait`.
  bool last_taken_at(const std::vector<int>& steps, int request, int wait) const;

 private:
  const Problem& problem_;
  std::vector<std::vector<Taker>> takers_;  // by channel
  std::vector<std::vector<int>> before_;    // by step: those that it comes after in its thread
};

}  // namespace pal::analyzer::compositional
