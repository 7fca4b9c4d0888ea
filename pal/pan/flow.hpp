// Where the flow of a module can go: the basis of all checks of bodies, and of code that depends on their
// ends.
#pragma once

#include <vector>

#include "pal/pan/network.hpp"

namespace pal::pan {

/// The flow of every module of a network. Nothing is assumed of conditions: a guard may hold or not.
class Flow {
 public:
  explicit Flow(const Network& network);

  /// Nodes that can come next. After a completion there are none, nor after Execute of a module that cannot
  /// end. After CONCURRENT there are the blocks and, if one of them can end, END CONCURRENT.
  std::vector<NodeId> next(ModuleId module, NodeId node) const;

  /// From the module's start.
  bool reached(ModuleId module, NodeId node) const { return reached_[module.index()][node.index()]; }

  /// True if the flow from the module's start can reach its end.
  bool can_end(ModuleId module) const { return can_end_[module.index()]; }

  /// True if a block of the CONCURRENT at `fork` can end, so that its END CONCURRENT can be reached.
  bool fork_can_end(ModuleId module, NodeId fork) const {
    return fork_can_end_[module.index()][fork.index()];
  }
  /// True if the flow from `first`, the first node of a block, can reach the end of that block.
  bool block_can_end(ModuleId module, NodeId first) const;

  /// The end of the block that begins at `first`.
  NodeId block_end(ModuleId module, NodeId first) const;

 private:
  void visit_forks(ModuleId module);
  std::vector<bool> reach(ModuleId module, NodeId from) const;

  const Network& network_;
  std::vector<bool> can_end_;                    // by module
  std::vector<std::vector<bool>> fork_can_end_;  // by module and node
  std::vector<std::vector<bool>> reached_;
};

/// The modules, each after those that it executes. Modules that execute one another in a circle come last; no
/// network without errors has such.
std::vector<ModuleId> executed_first(const Network& network);

/// A statement that a person wrote: not a start, an end, or a place where branches join.
bool is_statement(const Content& content);

}  // namespace pal::pan
