// Which waits receive which messages.
#pragma once

#include <set>
#include <vector>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// A branch of a wait that receives messages from a channel.
struct Taker {
  int thread;
  int step;
  int arm;
};

class Takers {
 public:
  Takers(const Problem& problem, const Segments& segments);

  /// All receivers of a channel.
  const std::vector<Taker>& of(int channel) const { return takers_[static_cast<std::size_t>(channel)]; }

  /// The waits that may receive the answers to the requests `sends`.
  std::set<int> after(const std::vector<int>& sends) const;

  /// Whether the last request is received at `wait` on all paths of a thread to each of `steps`.
  bool last_taken_at(const std::vector<int>& steps, int request, int wait) const;

 private:
  const Problem& problem_;
  std::vector<std::vector<Taker>> takers_;  // by channel
  std::vector<std::vector<int>> before_;    // by step: those that it comes after in its thread
};

}  // namespace pal::analyzer::compositional
