// What of a module's body is drawn, which nodes follow each other beyond the flow itself, and which stand in
// one column.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pal/pan/graph.hpp"

namespace pal::pan {

class DotFlow {
 public:
  /// The CONCURRENT whose block ends somewhere, and the block's number.
  struct Block {
    std::size_t fork;
    std::size_t number;
  };

  /// The body of a module; it must outlive this.
  explicit DotFlow(const Graph& body);

  /// Does the node have a place in the picture? Ends of blocks do not, because the bar shows them. A node
  /// that no flow reaches has one only if a statement stands there.
  bool drawn(std::size_t node) const { return (reached_[node] || whole_) && !ends_[node]; }
  /// Does some flow reach this node?
  bool reached(std::size_t node) const { return reached_[node]; }
  std::optional<Block> block_ended_by(std::size_t node) const { return ends_[node]; }
  /// The node behind an UNTIL( forever ), if it is drawn.
  std::optional<std::size_t> behind(std::size_t until) const;
  /// Nodes that follow each other without a branch between have one column: they are drawn on one straight
  /// line.
  std::size_t column(std::size_t node) const { return columns_[node]; }

 private:
  void find_ends();
  void find_reached();
  void find_columns();
  bool goes_on_forever(std::size_t node) const;
  /// What follows `until` in the text: not the next arm, but where the arms meet.
  std::size_t next_in_text(std::size_t until) const;

  const Graph& body_;
  std::vector<std::optional<Block>> ends_;
  std::vector<NodeId> meets_;  // of the first node of an arm, if it is not the first arm: where the arms meet
  std::vector<bool> reached_;
  bool whole_ = false;
  std::vector<std::size_t> columns_;
};

}  // namespace pal::pan
