// Paths of a thread that take no time: no wait and no activity.
#pragma once

#include <vector>

#include "pal/pan/flow.hpp"
#include "pal/pan/network.hpp"

namespace pal::check {

/// The statements of a network that take no time. Conditions may have any value, as in Flow.
class ZeroTimePaths {
 public:
  ZeroTimePaths(const pan::Network& network, const pan::Flow& flow);

  /// Takes no time and gives the processor to no other thread. A CONCURRENT can take no time if each of its
  /// blocks that can end can do so. An Execute can if its module has a zero-time path from its start to its
  /// end.
  bool takes_no_time(pan::ModuleId module, pan::NodeId node) const;

  /// Nodes that can come after one that takes no time, the blocks of a CONCURRENT left out.
  std::vector<pan::NodeId> next(pan::ModuleId module, pan::NodeId node) const;

 private:
  bool passes(pan::ModuleId module, pan::NodeId from, pan::NodeId end) const;
  bool fork_passes(pan::ModuleId module, pan::NodeId fork) const;

  const pan::Network& network_;
  const pan::Flow& flow_;
  std::vector<bool> modules_;             // by module: it has a zero-time path
  std::vector<std::vector<bool>> forks_;  // by module and node
};

}  // namespace pal::check
