// Modules that begin with something other than a wait.

#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/pan/flow.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

/// A module starts on a message that asks it to (thesis, section 3.3).
void check_starts(const pan::Network& network, Diagnostics& diagnostics) {
  for (std::size_t m = 0; m < network.modules.size(); ++m) {
    const auto& module = network.modules[m];
    const pan::ModuleId id(m);
    if (module.body.empty() || module.executed_by.valid() || id == network.main) continue;
    if (module.kind == pan::ModuleKind::skill_module || module.kind == pan::ModuleKind::contingency_module)
      continue;  // these have findings of their own
    for (const auto& node : module.body.nodes) {
      const bool silent = std::holds_alternative<pan::Start>(node.content) ||
                          std::holds_alternative<pan::Loop>(node.content) ||
                          std::holds_alternative<pan::Nothing>(node.content);
      if (silent) continue;
      // What blocks begin with is theirs to say.
      if (std::holds_alternative<pan::Wait>(node.content) ||
          std::holds_alternative<pan::Fork>(node.content) || std::holds_alternative<pan::End>(node.content) ||
          std::holds_alternative<pan::WaitForStart>(node.content))
        break;
      diagnostics.report(Finding::starts_unasked, node.where, kind_text(module.kind), module.name);
      break;
    }
  }
}

}  // namespace pal::check
