#include "pal/pan/dump.hpp"

#include <ostream>
#include <string_view>

#include "pal/support/duration_text.hpp"

namespace pal::pan {

namespace {

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string number_text(double value) {
  auto text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

void dump_texts(const char* word, const std::vector<std::string>& texts, std::ostream& out) {
  for (const auto& text : texts) out << "  " << word << ' ' << quoted(text) << '\n';
}

void dump_names(const char* word, const std::optional<std::vector<std::string>>& names, std::ostream& out) {
  if (!names) return;
  out << "  " << word;
  for (const auto& name : *names) out << (&name == &names->front() ? " " : ", ") << name;
  out << (names->empty() ? " none\n" : "\n");
}

void dump_template(const Network& network, std::ostream& out) {
  const auto& skill = network.skill;
  out << "skill " << skill.name << '\n';
  dump_texts("description", skill.descriptions, out);
  dump_texts("precondition", skill.preconditions, out);
  dump_texts("postcondition", skill.postconditions, out);
  dump_texts("model data", skill.model_data, out);
  if (network.main.valid()) out << "  main " << network.modules[network.main.index()].name << '\n';
  for (const auto& p : skill.parameters) {
    out << "  parameter " << p.name << " : " << (p.location ? "LOCATION" : declared_type(p.type, p.unit))
        << " default ";
    if (p.type == ScalarType::text) {
      out << quoted(p.default_text);
    } else {
      out << number_text(p.default_value) << " range " << number_text(p.low) << " to " << number_text(p.high);
    }
    out << ' ' << quoted(p.description) << '\n';
  }
  for (const auto& c : skill.contingencies) {
    out << "  contingency " << c.number << ' ' << quoted(c.description);
    if (c.method.valid()) out << " method " << network.modules[c.method.index()].name;
    out << '\n';
  }
  for (const auto& c : skill.completions) {
    out << "  completion " << c.code;
    if (c.kind == Completion::Kind::normal) out << " normal";
    if (c.kind == Completion::Kind::contingency) out << " contingency " << c.contingency;
    if (c.kind == Completion::Kind::error) out << " error";
    out << ' ' << quoted(c.description) << '\n';
  }
}

void dump_messages(const Network& network, std::ostream& out) {
  for (const auto& message : network.messages) {
    out << "message " << message.name;
    const char* before = " : ";
    for (const auto& field : message.fields) {
      out << before << field.name << ' ' << declared_type(field.type, field.unit, field.size);
      before = ", ";
    }
    if (message.asks_for.valid()) out << " asks for " << network.messages[message.asks_for.index()].name;
    out << '\n';
  }
}

void dump_names(const Network& network, const char* word, const std::vector<MessageId>& ids,
                std::ostream& out) {
  for (const auto id : ids) out << ' ' << word << ' ' << network.messages[id.index()].name;
}

void dump_channels(const Network& network, std::ostream& out) {
  for (std::size_t i = 0; i < network.channels.size(); ++i) {
    const auto& channel = network.channels[i];
    out << "channel " << i << ' ' << party_name(network, channel.sender) << " -> "
        << party_name(network, channel.receiver) << " : " << network.messages[channel.message.index()].name;
    if (channel.answer.valid()) out << " answered by " << channel.answer.index();
    out << '\n';
  }
}

void dump_module(const Network& network, ModuleId id, std::ostream& out) {
  const auto& module = network.modules[id.index()];
  out << "module " << module.name << " : " << kind_text(module.kind);
  if (module.executed_by.valid()) out << " executed by " << network.modules[module.executed_by.index()].name;
  for (const auto& thread : module.threads) out << " thread " << thread;
  out << '\n';
  dump_texts("description", module.descriptions, out);
  dump_names("sensor driver", module.drivers, out);
  dump_texts("method", module.methods, out);
  dump_names("returns", module.returns, out);
  for (std::size_t i = 0; i < module.body.nodes.size(); ++i) {
    const auto& node = module.body.nodes[i];
    out << "  " << i << ' ' << statement_text(network, id, NodeId(i));
    if (node.mate.valid()) out << " mate " << node.mate.index();
    for (std::size_t k = 0; k < node.out.size(); ++k) {
      out << (k == 0 ? " -> " : ", ");
      if (const auto* choose = std::get_if<Choose>(&node.content)) {
        out << "( " << guard_text(network, choose->guards[k]) << " ) ";
      }
      if (const auto* fork = std::get_if<Fork>(&node.content)) out << module.threads[fork->threads[k]] << ' ';
      out << node.out[k].index();
    }
    out << '\n';
  }
}

std::string step_list(const Network& network, const std::vector<StatementRef>& steps) {
  std::string result;
  for (const auto& step : steps) {
    result += " " + network.modules[step.module.index()].name + "/" + std::to_string(step.node.index());
  }
  return result;
}

std::string channels_text(const std::vector<ChannelId>& channels) {
  std::string text;
  for (const ChannelId channel : channels) {
    text += (text.empty() ? "channel " : ", ") + std::to_string(channel.index());
  }
  return text;
}

std::string known_text(const Network& network, const Known& known) {
  if (const auto* condition = std::get_if<ConditionId>(&known)) {
    return network.conditions[condition->index()].name;
  }
  return channels_text(std::get<std::vector<ChannelId>>(known));
}

std::string named_or_each(const std::string& processor) {
  return processor.empty() ? "each processor" : processor;
}

struct MeasureDump {
  const Network& network;

  std::string operator()(const Response& response) const {
    return "response from " + channels_text(response.of) + " to" + step_list(network, response.at);
  }
  std::string operator()(const Age& age) const {
    return "age of " + known_text(network, age.of) + " at" + step_list(network, age.at);
  }
  std::string operator()(const Reaction& reaction) const {
    return "reaction of " + known_text(network, reaction.of) + " at" + step_list(network, reaction.at);
  }
  std::string operator()(const Passes& passes) const {
    std::string text = "interval of" + step_list(network, passes.at);
    if (passes.least) text += " at least " + std::to_string(passes.least->count()) + " ns";
    if (passes.most) text += " at most " + std::to_string(passes.most->count()) + " ns";
    return text;
  }
  std::string operator()(const Loss& loss) const {
    return "loss of " + party_name(network, loss.of) + " at most " + std::to_string(loss.most) + " in " +
           std::to_string(loss.in);
  }
  std::string operator()(const Completing& completing) const {
    return "duration to completion " + std::to_string(completing.code);
  }
  std::string operator()(const Load& load) const { return "load of " + named_or_each(load.processor); }
  std::string operator()(const BusyPeriod& busy) const {
    return "busy period of " + named_or_each(busy.processor);
  }
};

void dump_requirement(const Network& network, const Requirement& requirement, std::ostream& out) {
  out << "requirement " << requirement.name << " : " << std::visit(MeasureDump{network}, requirement.measure);
  const bool own_limit = std::holds_alternative<Passes>(requirement.measure) ||
                         std::holds_alternative<Loss>(requirement.measure);
  if (!own_limit) out << " at most " << requirement.limit.count() << " ns";
  if (requirement.phase && !requirement.phase->after.empty())
    out << " after" << step_list(network, requirement.phase->after);
  if (requirement.phase && !requirement.phase->during.empty())
    out << " during" << step_list(network, requirement.phase->during);
  out << '\n';
}

struct BehaviourDump {
  std::ostream& out;

  void operator()(const EventDevice& device) const {
    out << "event " << device.message << (device.sporadic ? " sporadic " : " every ")
        << to_text(device.period) << " jitter " << to_text(device.jitter);
    if (device.phase) out << " phase " << to_text(*device.phase);
    if (device.answer_within)
      out << " answer " << device.answer << " within " << to_text(*device.answer_within);
  }
  void operator()(const RequestDevice& device) const {
    out << "on request " << to_text(device.answer) << (device.may_fail ? " or never" : "");
  }
  void operator()(const FrameDevice& device) const {
    out << "frames every " << to_text(device.period) << " collecting " << to_text(device.collecting);
    if (device.phase) out << " phase " << to_text(*device.phase);
  }
};

}  // namespace

std::string declared_type(ScalarType type, const std::string& unit, int size) {
  std::string text = type == ScalarType::real      ? "REAL"
                     : type == ScalarType::integer ? "INTEGER"
                     : type == ScalarType::boolean ? "BOOLEAN"
                                                   : "TEXT";
  if (size != 0) text += '[' + std::to_string(size) + ']';
  return unit.empty() ? text : text + ' ' + unit;
}

void dump(const Network& network, std::ostream& out) {
  dump_template(network, out);
  for (const auto& device : network.devices) {
    out << "device " << device.name << ' ' << quoted(device.description) << '\n';
  }
  dump_messages(network, out);
  for (const auto& condition : network.conditions) {
    out << "condition " << condition.name;
    if (condition.writer.valid()) out << " set by " << network.modules[condition.writer.index()].name;
    dump_names(network, "from", condition.from, out);
    out << ' ' << quoted(condition.description) << '\n';
  }
  for (const auto& activity : network.activities) {
    out << "activity " << activity.name << " of " << network.modules[activity.module.index()].name;
    dump_names(network, "reads", activity.reads, out);
    dump_names(network, "writes", activity.writes, out);
    if (activity.time) out << " time " << to_text(*activity.time);
    out << '\n';
  }
  dump_channels(network, out);
  for (std::size_t i = 0; i < network.modules.size(); ++i) dump_module(network, ModuleId(i), out);
  for (const auto& requirement : network.requirements) dump_requirement(network, requirement, out);
}

void dump(const Environment& environment, std::ostream& out) {
  out << "environment " << environment.name << '\n';
  dump_texts("description", environment.descriptions, out);
  const auto resources = [&](const char* what, const Resources::List& names) {
    if (!names) return;
    out << "  has " << what;
    for (const auto& each : *names) out << ' ' << each;
    out << '\n';
  };
  resources("sensor drivers", environment.resources.sensor_drivers);
  resources("logical sensors", environment.resources.logical_sensors);
  resources("machine controllers", environment.resources.machine_controllers);
  resources("skills", environment.resources.skills);
  for (const auto& p : environment.processors) {
    out << "  processor " << p.name << (p.preemptive ? "" : " nonpreemptive") << '\n';
  }
  for (const auto& device : environment.devices) {
    out << "  device " << device.device << ' ';
    std::visit(BehaviourDump{out}, device.behaviour);
    out << '\n';
  }
  for (const auto& p : environment.placements) {
    out << "  place " << p.thread << " on " << p.processor << " priority " << p.priority << '\n';
  }
  for (const auto& a : environment.activities) {
    out << "  time " << a.activity;
    if (!a.module.empty()) out << " of " << a.module;
    out << " : " << to_text(a.time) << '\n';
  }
  const auto cost = [&](const char* word, const Interval& time) {
    out << "  " << word << ' ' << to_text(time) << '\n';
  };
  cost("cost send", environment.costs.send);
  cost("cost receive", environment.costs.receive);
  cost("cost set", environment.costs.set);
  cost("cost read", environment.costs.read);
  cost("cost test", environment.costs.test);
  cost("latency within processor", environment.latency.within_processor);
  cost("latency between processors", environment.latency.between_processors);
}

}  // namespace pal::pan
