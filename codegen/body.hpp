// From the graph of a module back to statements inside statements.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "codegen/names.hpp"
#include "codegen/plan.hpp"

namespace pal::codegen {

constexpr std::size_t no_thread = std::numeric_limits<std::size_t>::max();

/// Where things of the network stand in the plan.
struct Indices {
  std::vector<std::optional<std::size_t>> messages;  // none: no fields
  std::vector<std::optional<std::size_t>> modules;   // none: no body
  std::vector<std::vector<std::size_t>> threads;     // of each module, as Module::threads
};

/// Fills body, methods, messages and blocks of one module of the plan, and adds its rows to Plan::statements.
void plan_body(const pan::Network& network, pan::ModuleId module, const pan::Environment& environment,
               const SourceManager& sources, const Indices& indices, Diagnostics& diagnostics, Scope& rows,
               Plan& plan);

/// Fills PlannedThread::parent: whose CONCURRENT begins a block, in its module or in one that it executes.
void find_parents(Plan& plan);

/// Fills PlannedThread::can_end: whether the flow of each block can reach its end.
void find_ends(Plan& plan);

}  // namespace pal::codegen
