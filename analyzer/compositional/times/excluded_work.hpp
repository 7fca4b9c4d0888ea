// The work that never delays a node, though it has its processor and a priority no lower.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/causes/precedence.hpp"

namespace pal::analyzer::compositional {

class ExcludedWork {
 public:
  /// After `stop` has returned true, less is known to be excluded.
  ExcludedWork(const AnalysisContext& context, std::shared_ptr<const Order> order,
               const std::function<bool()>& stop);

  /// Nodes whose work does not count in the busy window of `node`. `done_before_next`: each job of its thread
  /// ends before the next is released. `in_turn`: all that an occurrence of its source triggers ends before
  /// the next occurrence.
  ///
  /// What comes later never counts. Work that is over before the node is released may have held up other
  /// work. Other work that comes once counts in full anyway. Of work that recurs, more may be waiting then
  /// than a window holds. So what is over is left out in two cases.
  /// - All that recurs and counts is released only after that work, in every run.
  /// - The processor is preemptive, and the work has a lower priority than all that recurs and counts. So
  ///   nothing of it was waiting while that work ran.
  std::vector<NodeId> of(NodeId node, bool done_before_next, bool in_turn) const;
  /// By processor.
  const std::vector<NodeId>& nodes_on(ProcessorId processor) const { return nodes_on_[processor]; }

 private:
  using Bits = std::vector<std::uint64_t>;

  bool comes_later(NodeId node, NodeId other) const;
  bool never_overlap(NodeId node, NodeId other, bool done_before_next, bool in_turn) const;
  bool recurs(NodeId node) const;
  bool is_before(NodeId before, const Bits& set) const;
  /// The nodes of a processor that are among these.
  Bits set_of(ProcessorId processor, const std::vector<NodeId>& nodes) const;
  void insert(ProcessorId processor, const std::vector<NodeId>& nodes, Bits& set) const;
  Bits related(NodeId node, bool done_before_next, bool in_turn) const;

  /// A node that takes time, with what tells whether it counts: all nodes of a processor are gone through for
  /// each of them.
  struct Worker {
    NodeId node{};
    std::size_t place = 0;  // in nodes_on_
    int priority = 0;
  };

  AnalysisContext context_;
  Table<ProcessorId, std::vector<NodeId>> nodes_on_;
  Table<ProcessorId, std::vector<Worker>> workers_on_;
  Table<NodeId, std::size_t> place_;  // in nodes_on_
  Table<NodeId, Bits> after_;         // those of its processor that are released only after it is done
  Table<NodeId, std::vector<NodeId>> earlier_;  // those of its processor that are done before it is released
  std::shared_ptr<const Order> order_;
  Table<NodeId, std::vector<NodeId>> never_together_;
};

}  // namespace pal::analyzer::compositional
