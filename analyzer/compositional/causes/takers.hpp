// Which waits receive which messages.
#pragma once

#include <set>
#include <vector>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// A branch of a wait that receives messages from a channel.
struct Taker {
  ThreadId thread;
  StepId step;
  int arm;
};

class Takers {
 public:
  Takers(const Problem& problem, const Segments& segments);

  /// All receivers of a channel.
  const std::vector<Taker>& of(ChannelId channel) const { return takers_[channel]; }

  /// The waits that may receive the answers to the requests `sends`.
  std::set<StepId> after(const std::vector<StepId>& sends) const;

  /// Whether the last request is received at `wait` on all paths of a thread to each of `steps`.
  bool last_taken_at(const std::vector<StepId>& steps, ChannelId request, StepId wait) const;

 private:
  const Problem& problem_;
  Table<ChannelId, std::vector<Taker>> takers_;  // by channel
  Table<StepId, std::vector<StepId>> before_;    // by step: those that it comes after in its thread
};

}  // namespace pal::analyzer::compositional
