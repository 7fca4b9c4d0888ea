#include "codegen/plan.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "codegen/body.hpp"
#include "codegen/file_names.hpp"
#include "codegen/names.hpp"
#include "codegen/placement.hpp"
#include "codegen/promises.hpp"
#include "codegen/runners.hpp"
#include "pal/pan/dump.hpp"
#include "pal/pan/threads.hpp"
#include "pal/pan/times.hpp"
#include "pal/support/finding.hpp"

namespace pal::codegen {

namespace {

constexpr std::size_t most_threads = 20'000;  // as the analysis

bool is_device(const pan::Network& network, const pan::Party& party) {
  const auto* module = std::get_if<pan::ModuleId>(&party);
  return module == nullptr || network.modules[module->index()].body.empty();
}

/// The skill's namespace stands inside pal::skills, and must not hide what generated code names.
std::string namespace_name(const std::string& skill) {
  static constexpr std::array taken{"channel", "condition", "description", "pal",       "runtime",
                                    "skills",  "statement", "std",         "thread_of", "wiring"};
  const std::string name = snake_case(skill);
  return std::find(taken.begin(), taken.end(), name) == taken.end() ? name : name + "_skill";
}

class Planner {
 public:
  Planner(const pan::Network& network, const pan::Environment& environment, const SourceManager& sources,
          Diagnostics& diagnostics)
      : network_(network),
        flow_(network),
        environment_(environment),
        sources_(sources),
        diagnostics_(diagnostics) {}

  std::optional<Plan> plan() {
    const std::size_t errors = diagnostics_.errors();
    plan_.name = namespace_name(network_.skill.name);
    plan_.file = snake_words(network_.skill.name);
    plan_.skill_class = types_.unique(camel_case(network_.skill.name) + "Skill");
    plan_.skill = network_.skill;
    plan_.environment = environment_;
    parameters();
    messages();
    conditions();
    channels();
    modules();
    if (!threads()) return std::nullopt;
    bodies();
    stores();
    devices();
    if (diagnostics_.errors() != errors) return std::nullopt;
    plan_requirements(network_, plan_);
    return std::move(plan_);
  }

 private:
  void parameters() {
    Scope scope;
    for (const pan::Parameter& parameter : network_.skill.parameters) {
      plan_.parameters.push_back({scope.unique(snake_case(parameter.name)), parameter});
    }
  }

  void messages() {
    for (const pan::Message& message : network_.messages) {
      indices_.messages.emplace_back();
      if (message.fields.empty()) continue;
      indices_.messages.back() = plan_.messages.size();
      PlannedMessage planned;
      planned.type = types_.unique(camel_case(message.name));
      planned.variable = variables_.unique(snake_case(message.name));
      planned.pal_name = message.name;
      Scope fields({"fields", "field_count", "from_fields", "message", "numbers"});
      for (const pan::Field& field : message.fields) {
        const std::string name = field.name.empty() ? "value" : field.name;
        planned.fields.push_back(
            {fields.unique(snake_case(name)), field.name, field.type, field.unit, field.size});
      }
      plan_.messages.push_back(std::move(planned));
    }
  }

  void conditions() {
    Scope scope;
    for (const pan::Condition& condition : network_.conditions) {
      plan_.conditions.push_back({scope.unique(snake_case(condition.name)), condition.name});
    }
  }

  /// Its events answer no request: one to it is a message like any other.
  bool sends_events(const std::string& device) const {
    return std::any_of(
        environment_.devices.begin(), environment_.devices.end(), [&device](const pan::DeviceTiming& timing) {
          return timing.device == device && std::holds_alternative<pan::EventDevice>(timing.behaviour);
        });
  }

  void channels() {
    Scope scope;
    for (const pan::Channel& channel : network_.channels) {
      PlannedChannel planned;
      planned.sender = pan::party_name(network_, channel.sender);
      planned.message = network_.messages[channel.message.index()].name;
      planned.receiver = pan::party_name(network_, channel.receiver);
      planned.constant =
          scope.unique(snake_words(planned.message + " from " + planned.sender + " to " + planned.receiver));
      planned.fields = indices_.messages[channel.message.index()];
      const bool asks = network_.messages[channel.message.index()].asks_for.valid();
      planned.request = asks && !sends_events(planned.receiver);
      if (planned.request && channel.answer.valid()) planned.answer = channel.answer.index();
      planned.from_device = is_device(network_, channel.sender);
      planned.to_device = is_device(network_, channel.receiver);
      for (const auto* party : {&channel.sender, &channel.receiver}) {
        const std::string& name = pan::party_name(network_, *party);
        const bool known = std::find(plan_.devices.begin(), plan_.devices.end(), name) != plan_.devices.end();
        if (is_device(network_, *party) && !known) plan_.devices.push_back(name);
      }
      plan_.channels.push_back(std::move(planned));
    }
  }

  void modules() {
    for (const pan::Module& module : network_.modules) {
      indices_.modules.emplace_back();
      if (module.body.empty()) continue;
      indices_.modules.back() = plan_.modules.size();
      PlannedModule planned;
      planned.type = types_.unique(camel_case(module.name));
      planned.variable = variables_.unique(snake_case(module.name));
      planned.words = snake_words(module.name);
      planned.pal_name = module.name;
      planned.kind = pan::kind_text(module.kind);
      if (module.where.valid())
        planned.file = file_name(sources_, module.where.file, network_.skill.where.file);
      planned.executed = module.executed_by.valid();
      plan_.modules.push_back(std::move(planned));
    }
  }

  /// By module, in the order of the text; the blocks that one thread begins together.
  bool threads() {
    const std::vector<pan::SkillThread> found = pan::threads_of(network_, most_threads);
    if (found.size() > most_threads) {
      diagnostics_.report(Finding::too_many_threads, network_.skill.where, network_.skill.name);
      return false;
    }
    std::vector<std::size_t> order(found.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto rank = [&found](std::size_t t) {
      return std::tuple(found[t].module.index(), found[t].runner.value_or(0), found[t].index);
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    std::vector<std::size_t> place(found.size());
    for (std::size_t t = 0; t < order.size(); ++t) place[order[t]] = t;
    for (const pan::Module& module : network_.modules) indices_.threads.emplace_back(module.threads.size());
    Scope scope;
    for (const std::size_t from : order) {
      const pan::SkillThread& thread = found[from];
      PlannedThread planned;
      planned.constant = scope.unique(snake_case(thread.name));
      planned.pal_name = thread.name;
      planned.module = *indices_.modules[thread.module.index()];
      planned.can_end = flow_.can_end(thread.module);  // a block's own end is found with its body
      if (thread.parent) planned.parent = place[*thread.parent];
      if (thread.runner) planned.runner = place[*thread.runner];
      indices_.threads[thread.module.index()][thread.index].push_back(plan_.threads.size());
      plan_.threads.push_back(std::move(planned));
    }
    place_threads(environment_, diagnostics_, plan_.threads);
    return true;
  }

  void bodies() {
    Scope rows;
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      if (network_.modules[m].body.empty()) continue;
      plan_body(network_, flow_, pan::ModuleId(m), environment_, sources_, indices_, diagnostics_, rows,
                plan_);
      PlannedModule& module = plan_.modules[*indices_.modules[m]];
      // By the module's own name: a message of that name takes no part in it.
      const std::string own = camel_case(module.pal_name);
      if (!module.methods.empty()) module.interface = types_.unique(own + "Activities");
      for (PlannedMethod& method : module.methods) {
        if (method.writes.size() > 1) {
          method.result_type = types_.unique(own + camel_case(method.name) + "Result");
        }
      }
      for (PlannedModule::Block& block : module.blocks) {
        if (block.threads.size() > 1)
          block.chooser = types_.unique(snake_case("thread of " + module.words + " " + block.function));
      }
    }
    find_runners(plan_);
  }

  void stores() {
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      if (!indices_.modules[m] || !network_.modules[m].executed_by.valid()) continue;
      PlannedModule& executed = plan_.modules[*indices_.modules[m]];
      const std::size_t keeper = *indices_.modules[outermost(m)];
      executed.keeper = plan_.modules[keeper].keeper = keeper;
      for (const std::size_t user : {keeper, *indices_.modules[m]}) {
        for (const std::size_t message : plan_.modules[user].messages) add(store_of(keeper), message);
      }
    }
  }

  /// After all other types, whose names do not depend on which modules talk to devices.
  void devices() {
    for (const std::string& name : plan_.devices) {
      PlannedDevice planned;
      planned.type = types_.unique(camel_case(name) + "Device");
      planned.pal_name = name;
      for (const pan::Device& device : network_.devices) {
        if (device.name == name) planned.description = device.description;
      }
      Scope scope;
      for (const PlannedChannel& channel : plan_.channels) {
        const bool to = channel.to_device && channel.receiver == name;
        const bool from = channel.from_device && channel.sender == name;
        const bool known =
            std::any_of(planned.ports.begin(), planned.ports.end(), [&](const PlannedDevice::Port& port) {
              return port.message == channel.message && port.to_device == to;
            });
        if ((!to && !from) || known) continue;
        planned.ports.push_back(
            {scope.unique(snake_words(channel.message)), channel.message, to, channel.fields});
      }
      plan_.device_classes.push_back(std::move(planned));
    }
  }

  /// Executes a module, or modules that do, and is not executed.
  std::size_t outermost(std::size_t module) const {
    while (network_.modules[module].executed_by.valid())
      module = network_.modules[module].executed_by.index();
    return module;
  }

  PlannedStore& store_of(std::size_t keeper) {
    for (PlannedStore& store : plan_.stores) {
      if (store.keeper == keeper) return store;
    }
    const PlannedModule& module = plan_.modules[keeper];
    plan_.stores.push_back({types_.unique(module.type + "Messages"),
                            variables_.unique(module.variable + "_messages"),
                            keeper,
                            {}});
    return plan_.stores.back();
  }

  static void add(PlannedStore& store, std::size_t message) {
    const auto known = std::find(store.messages.begin(), store.messages.end(), message);
    if (known == store.messages.end()) store.messages.push_back(message);
  }

  const pan::Network& network_;
  pan::Flow flow_;
  const pan::Environment& environment_;
  const SourceManager& sources_;
  Diagnostics& diagnostics_;
  Plan plan_;
  Indices indices_;
  // Besides our own: macros of the C library that look like names of types.
  Scope types_{{"Parameters", "NULL", "EOF", "NAN", "INFINITY", "BUFSIZ", "RAND_MAX", "CHAR_BIT"}};
  Scope variables_{{"activities", "messages", "parameters"}};
};

}  // namespace

bool is_plain(const PlannedMessage& message) {
  return std::all_of(message.fields.begin(), message.fields.end(), [](const PlannedField& field) {
    return field.size == 0 && field.type != pan::ScalarType::text;
  });
}

std::optional<Plan> make_plan(const pan::Network& network, const pan::Environment& environment,
                              const SourceManager& sources, Diagnostics& diagnostics) {
  const pan::Environment whole = pan::with_times_of(network, environment);
  return Planner(network, whole, sources, diagnostics).plan();
}

}  // namespace pal::codegen
