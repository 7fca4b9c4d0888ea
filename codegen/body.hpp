// From the graph of a module back to statements inside statements.
#pragma once

#include <optional>
#include <vector>

#include "codegen/names.hpp"
#include "codegen/plan.hpp"
#include "pal/pan/flow.hpp"

namespace pal::codegen {

/// Where things of the network stand in the plan.
struct Indices {
  std::vector<std::optional<std::size_t>> messages;  // none: no fields
  std::vector<std::optional<std::size_t>> modules;   // none: no body
  /// Of each module, as Module::threads: those of the plan, one for each thread that runs it.
  std::vector<std::vector<std::vector<std::size_t>>> threads;
};

/// Fills body, methods, messages and blocks of one module of the plan. Says for the threads of its blocks
/// whether they can end, and adds its rows to Plan::statements.
void plan_body(const pan::Network& network, const pan::Flow& flow, pan::ModuleId module,
               const pan::Environment& environment, const SourceManager& sources, const Indices& indices,
               Diagnostics& diagnostics, Scope& rows, Plan& plan);

}  // namespace pal::codegen
