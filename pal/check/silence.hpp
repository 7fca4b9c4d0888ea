// What a thread can pass without waiting for anything and without doing an activity.
#pragma once

#include <vector>

#include "pal/pan/flow.hpp"
#include "pal/pan/network.hpp"

namespace pal::frontend {

/// The statements of a network on which nothing pauses. Nothing is assumed of conditions, as in Flow.
class Silence {
 public:
  Silence(const pan::Network& network, const pan::Flow& flow);

  /// Takes no time and lets nobody else go on. A CONCURRENT can pass in silence if each of its blocks that
  /// can end can do so, an Execute if its module has a silent way from its start to its end.
  bool silent(pan::ModuleId module, pan::NodeId node) const;

  /// Nodes that can come after a silent one, the blocks of a CONCURRENT left out.
  std::vector<pan::NodeId> next(pan::ModuleId module, pan::NodeId node) const;

 private:
  bool passes(pan::ModuleId module, pan::NodeId from, pan::NodeId end) const;
  bool fork_passes(pan::ModuleId module, pan::NodeId fork) const;

  const pan::Network& network_;
  const pan::Flow& flow_;
  std::vector<bool> modules_;             // by module: it has a silent way
  std::vector<std::vector<bool>> forks_;  // by module and node
};

}  // namespace pal::frontend
