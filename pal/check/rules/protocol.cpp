// The start of the skill and its completions; contingency methods that nothing executes.
#include <algorithm>
#include <set>
#include <string>

#include "pal/check/report.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/diagnostic_code.hpp"

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
    diagnostics.report(Code::PAL0507, network.skill.where,
                       "no module of skill " + quoted(network.skill.name) + " waits for the coordinator",
                       "begin the skill method with WTM( Coordinator )");
    return;
  }
  for (std::size_t m = 0; m < network.modules.size(); ++m) {
    const auto& module = network.modules[m];
    for (std::size_t n = 0; n < module.body.nodes.size(); ++n) {
      const auto& node = module.body.nodes[n];
      if (!std::holds_alternative<pan::WaitForStart>(node.content)) continue;
      if (module.kind != pan::ModuleKind::skill_module) {
        diagnostics.report(Code::PAL0507, node.where,
                           "a " + kind_text(module.kind) + " is not started by the coordinator",
                           "remove it: only the skill method waits for the coordinator");
      } else if (n != 1) {
        diagnostics.report(Code::PAL0507, node.where,
                           "the coordinator starts a skill once, before anything else",
                           "make this the first statement of the skill method");
      } else if (pan::ModuleId(m) != network.main) {
        auto& finding = diagnostics.report(
            Code::PAL0507, node.where,
            "two modules of skill " + quoted(network.skill.name) + " wait for the coordinator",
            "let one of them be the skill method, and execute the other from it");
        finding.notes.push_back({network.modules[network.main.index()].where, "this is the other"});
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
        diagnostics.report(Code::PAL0506, node.where, "a " + kind_text(module.kind) + " cannot end the skill",
                           "send the completion from the skill module");
      }
      const auto known = std::any_of(network.skill.completions.begin(), network.skill.completions.end(),
                                     [&](const pan::Completion& c) { return c.code == complete->code; });
      if (known) continue;
      auto& finding = diagnostics.report(
          Code::PAL0607, node.where, "the template has no completion " + std::to_string(complete->code),
          "add COMPLETION " + std::to_string(complete->code) + ", or send another code");
      finding.notes.push_back({network.skill.where, "the template is here"});
    }
  }
  bool has_error = false;  // the first one is sent for every fault
  for (const auto& completion : network.skill.completions) {
    const bool for_faults = completion.kind == pan::Completion::Kind::error && !has_error;
    has_error = has_error || for_faults;
    if (for_faults || sent.contains(completion.code)) continue;
    diagnostics.report(Code::PAL0612, completion.where,
                       "nothing sends completion " + std::to_string(completion.code),
                       "send it where the skill ends in this way, or remove it");
  }
}

void check_end(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics) {
  if (!network.main.valid()) return;
  const auto& module = network.modules[network.main.index()];
  const pan::NodeId end(module.body.nodes.size() - 1);
  if (!flow.reached(network.main, end)) return;
  auto& finding = diagnostics.report(
      Code::PAL0504, module.body[end].where, quoted(module.name) + " can get to its end without a completion",
      "send TXM( Completion Protocol 0 ), or another code, on every way to the end");
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
      finding.notes.push_back({node.where, "after this, for one"});
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
      diagnostics.report(Code::PAL0512, network.modules[network.main.index()].where,
                         "skill " + quoted(network.skill.name) + " never completes: no way through " +
                             quoted(network.modules[network.main.index()].name) + " reaches a completion",
                         "let the loop end, or stand in a block of CONCURRENT beside one that ends");
  if (endless != nullptr) finding.notes.push_back({endless->where, "this loop never ends"});
}

void check_contingencies(const pan::Network& network, Diagnostics& diagnostics) {
  for (const auto& module : network.modules) {
    if (module.kind != pan::ModuleKind::contingency_module || module.body.empty() ||
        module.executed_by.valid()) {
      continue;
    }
    diagnostics.report(Code::PAL0508, module.where,
                       "nothing executes contingency module " + quoted(module.name) +
                           ", so it would run at the same time as the skill",
                       "add Execute " + module.name + " where the contingency is met");
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
