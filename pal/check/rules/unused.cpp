#include "pal/check/rules/unused.hpp"

#include <set>
#include <string>
#include <variant>

#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"

namespace pal::check {
namespace {

/// Names that the skills use, by sort.
struct Used {
  std::set<std::string> messages;
  std::set<std::string> conditions;
  std::set<std::string> parties;  // modules and devices
  std::set<std::string> activities;
};

Used used_by(const std::vector<const pan::Network*>& skills) {
  Used used;
  for (const pan::Network* skill : skills) {
    for (const auto& message : skill->messages) used.messages.insert(message.name);
    for (const auto& condition : skill->conditions) used.conditions.insert(condition.name);
    for (const auto& module : skill->modules) used.parties.insert(module.name);
    for (const auto& device : skill->devices) used.parties.insert(device.name);
    for (const auto& activity : skill->activities) used.activities.insert(activity.name);
  }
  return used;
}

class UnusedCheck {
 public:
  UnusedCheck(const std::vector<const pan::Network*>& skills, Diagnostics& diagnostics)
      : used_(used_by(skills)), diagnostics_(diagnostics) {}

  void check(const syntax::Tree& tree) {
    for (const auto& unit : tree.units) {
      if (const auto* message = std::get_if<syntax::MessageUnit>(&unit)) {
        declared("message", message->name, used_.messages);
      } else if (const auto* condition = std::get_if<syntax::ConditionUnit>(&unit)) {
        declared("condition", condition->name, used_.conditions);
      } else if (const auto* device = std::get_if<syntax::DeviceUnit>(&unit)) {
        declared("device", device->name, used_.parties);
      }
    }
  }

  void check(const pan::Environment& environment) {
    for (const auto& device : environment.devices) {
      if (!used_.parties.contains(device.device)) given("device", device.device, device.where, used_.parties);
    }
    for (const auto& time : environment.activities) {
      if (!used_.activities.contains(time.activity))
        given("activity", time.activity, time.where, used_.activities);
    }
    for (const auto& placement : environment.placements) {
      const std::string module = placement.thread.substr(0, placement.thread.find_first_of("./"));
      if (!used_.parties.contains(module)) given("module", module, placement.where, used_.parties);
    }
  }

 private:
  void declared(const char* what, const syntax::Name& name, const std::set<std::string>& used) {
    if (name.text.empty() || used.contains(name.text)) return;
    diagnostics_.report(Finding::never_used, name.where, what, name.text);
  }

  void given(const char* what, const std::string& name, SourceSpan where,
             const std::set<std::string>& known) {
    diagnostics_.report(Finding::figure_for_nothing, where, what, name)
        .suggest(nearest(name, {known.begin(), known.end()}));
  }

  Used used_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_unused(const syntax::Tree& tree, const std::vector<const pan::Network*>& skills,
                  const std::vector<const pan::Environment*>& environments, Diagnostics& diagnostics) {
  if (skills.empty()) return;
  UnusedCheck check(skills, diagnostics);
  check.check(tree);
  for (const auto* environment : environments) check.check(*environment);
}

}  // namespace pal::check
