// The start of the skill and its completions; contingency methods that nothing executes.
#include <algorithm>
#include <set>

#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

bool may_complete(pan::ModuleKind kind) {
  return kind == pan::ModuleKind::skill_module || kind == pan::ModuleKind::contingency_module;
}

void check_start(const pan::Network& network, Diagnostics& diagnostics) {
  if (!network.main.valid()) {
    const auto is_method = [](const pan::Module& m) { return m.kind == pan::ModuleKind::skill_module; };
    const bool has_method = std::any_of(network.modules.begin(), network.modules.end(), is_method);
    if (!has_method) return;  // the template has a finding for that
    diagnostics.report(Finding::nothing_waits_for_coordinator, network.skill.where, network.skill.name);
    return;
  }
  for (std::size_t m = 0; m < network.modules.size(); ++m) {
    const auto& module = network.modules[m];
    for (std::size_t n = 0; n < module.body.nodes.size(); ++n) {
      const auto& node = module.body.nodes[n];
      if (!std::holds_alternative<pan::WaitForStart>(node.content)) continue;
      if (module.kind != pan::ModuleKind::skill_module) {
        diagnostics.report(Finding::not_started_by_coordinator, node.where, kind_text(module.kind));
      } else if (n != 1) {
        diagnostics.report(Finding::coordinator_starts_once, node.where);
      } else if (pan::ModuleId(m) != network.main) {
        auto& finding = diagnostics.report(Finding::two_wait_for_coordinator, node.where, network.skill.name);
        finding.note(network.modules[network.main.index()].where, Remark::the_other);
      }
    }
  }
}

void check_codes(const pan::Network& network, Diagnostics& diagnostics) {
  std::set<int> sent;
  for (const auto& module : network.modules) {
    for (const auto& node : module.body.nodes) {
      const auto* complete = std::get_if<pan::Complete>(&node.content);
      if (complete == nullptr) continue;
      sent.insert(complete->code);
      if (!may_complete(module.kind)) {
        diagnostics.report(Finding::cannot_end_skill, node.where, kind_text(module.kind));
      }
      const auto known = std::any_of(network.skill.completions.begin(), network.skill.completions.end(),
                                     [&](const pan::Completion& c) { return c.code == complete->code; });
      if (known) continue;
      auto& finding = diagnostics.report(Finding::completion_not_in_template, node.where, complete->code);
      finding.note(network.skill.where, Remark::template_here);
    }
  }
  bool has_error = false;  // the first one is sent for every fault
  for (const auto& completion : network.skill.completions) {
    const bool for_faults = completion.kind == pan::Completion::Kind::error && !has_error;
    has_error = has_error || for_faults;
    if (for_faults || sent.contains(completion.code)) continue;
    diagnostics.report(Finding::completion_never_sent, completion.where, completion.code);
  }
}

void check_end(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics) {
  if (!network.main.valid()) return;
  const auto& module = network.modules[network.main.index()];
  const pan::NodeId end(module.body.nodes.size() - 1);
  if (!flow.reached(network.main, end)) return;
  auto& finding = diagnostics.report(Finding::end_without_completion, module.body[end].where, module.name);
  // The statements after which nothing comes but the end.
  std::set<pan::NodeId> joins{end};
  for (auto i = end.index(); i-- > 0;) {
    const pan::NodeId id(i);
    const auto& node = module.body[id];
    if (!flow.reached(network.main, id) || !node.where.valid()) continue;
    const auto next = flow.next(network.main, id);
    const bool leads =
        std::any_of(next.begin(), next.end(), [&](pan::NodeId to) { return joins.contains(to); });
    if (!leads) continue;
    if (std::holds_alternative<pan::Merge>(node.content)) {
      joins.insert(id);
    } else {
      finding.note(node.where, Remark::after_this);
      return;
    }
  }
}

/// No way through the method, or through what it executes, reaches a completion.
void check_completes(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics) {
  if (!network.main.valid()) return;
  const pan::Node* endless = nullptr;
  for (std::size_t m = 0; m < network.modules.size(); ++m) {
    const auto& body = network.modules[m].body;
    for (std::size_t n = 0; n < body.nodes.size(); ++n) {
      if (!flow.reached(pan::ModuleId(m), pan::NodeId(n))) continue;
      const auto& node = body.nodes[n];
      if (std::holds_alternative<pan::Complete>(node.content)) return;
      // Its end is where the flow stops, if it gets that far.
      if (pan::ModuleId(m) == network.main && std::holds_alternative<pan::End>(node.content) &&
          n + 1 == body.nodes.size())
        return;
      const auto* until = std::get_if<pan::Until>(&node.content);
      if (pan::ModuleId(m) == network.main && until != nullptr && !until->guard) endless = &node;
    }
  }
  auto& finding =
      diagnostics.report(Finding::skill_never_completes, network.modules[network.main.index()].where,
                         network.skill.name, network.modules[network.main.index()].name);
  if (endless != nullptr) finding.note(endless->where, Remark::loop_endless);
}

void check_contingencies(const pan::Network& network, Diagnostics& diagnostics) {
  for (const auto& module : network.modules) {
    if (module.kind != pan::ModuleKind::contingency_module || module.body.empty() ||
        module.executed_by.valid()) {
      continue;
    }
    diagnostics.report(Finding::contingency_not_executed, module.where, module.name);
  }
}

}  // namespace

void check_protocol(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics) {
  check_start(network, diagnostics);
  check_codes(network, diagnostics);
  check_end(network, flow, diagnostics);
  check_completes(network, flow, diagnostics);
  check_contingencies(network, diagnostics);
}

}  // namespace pal::check
