// A program with its names looked up, once: what leads where, and what stands for what.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "operations/model.hpp"

namespace pal::operations {

/// Made in time that grows with the size of the program. The program outlives the graph and keeps its icons,
/// their ids and their connections; parameters may change.
class Graph {
 public:
  explicit Graph(const Program& program);

  const Program& program() const { return program_; }
  const Icon& icon(Place at) const { return program_.operations[at.operation].icons[at.icon]; }

  /// The index of the first icon of this name; nothing if there is none.
  std::optional<std::size_t> find(std::size_t operation, std::string_view id) const;
  /// Where a connection of this operation leads.
  std::optional<std::size_t> target(std::size_t operation, const Connection& connection) const {
    return find(operation, connection.icon);
  }
  /// The first START of the operation.
  std::optional<std::size_t> start(std::size_t operation) const { return operations_[operation].start; }
  /// What a hierarchical icon stands for; nothing if it is not there.
  std::optional<std::size_t> sub_operation(Place at) const { return operations_[at.operation].subs[at.icon]; }
  /// The operation that runs when this one is stopped; nothing if there is none.
  std::optional<std::size_t> on_stop(std::size_t operation) const { return operations_[operation].on_stop; }
  /// The CASE that the token comes to by `next` of the icon, passing MERGEs and delays only.
  std::optional<std::size_t> case_behind(Place at) const { return operations_[at.operation].cases[at.icon]; }
  /// The hierarchical icons that stand for the operation.
  const std::vector<Place>& users(std::size_t operation) const { return operations_[operation].users; }
  /// Where the outputs of an icon lead, in the order of outputs(); those that lead nowhere are left out.
  std::vector<std::size_t> targets(Place at) const;

 private:
  struct Lookup {
    std::unordered_map<std::string_view, std::size_t> ids;
    std::optional<std::size_t> start, on_stop;
    std::vector<std::optional<std::size_t>> subs, cases;
    std::vector<Place> users;
  };
  void find_sub_operations();
  void find_cases(std::size_t operation);

  const Program& program_;
  std::vector<Lookup> operations_;
};

/// All operations, each behind those that its hierarchical icons stand for. No operation contains itself.
std::vector<std::size_t> inner_first(const Graph& graph);

/// Groups of icons, by index, between which one can go round, and single ones that lead to themselves; each
/// group in ascending order. `leads_to[i]`: where one can go from i.
std::vector<std::vector<std::size_t>> circles(const std::vector<std::vector<std::size_t>>& leads_to);

}  // namespace pal::operations
