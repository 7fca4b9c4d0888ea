#include "pal/syntax/print.hpp"

#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>

#include "pal/pan/dump.hpp"
#include "pal/support/duration_text.hpp"
#include "pal/syntax/format.hpp"
#include "pal/syntax/requirement_text.hpp"

namespace pal::syntax {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string list(const std::vector<Name>& names) {
  std::string result;
  for (const auto& name : names) result += (result.empty() ? "" : ", ") + name.text;
  return result;
}

std::string list_or_none(const std::vector<Name>& names) {
  return names.empty() ? "NONE" : list(names);
}

std::string with_text(const std::string& text) {
  return text.empty() ? std::string() : " " + quoted(text);
}

/// Writes the words of a tree, a line for each that the layout begins a line with; the layout is not its
/// business.
class Printer {
 public:
  explicit Printer(std::ostream& out) : out_(out) {}

  void operator()(const Uses& uses) { line("USES " + quoted(uses.path)); }

  void operator()(const MessageUnit& message) {
    line("MESSAGE " + message.name.text + " : " + payload(message));
  }

  void operator()(const ConditionUnit& condition) {
    const auto from = condition.from.empty() ? std::string() : " FROM " + list(condition.from);
    line("CONDITION " + condition.name.text + from + with_text(condition.description));
  }

  void operator()(const DeviceUnit& device) {
    line("DEVICE " + device.name.text + with_text(device.description));
  }

  void operator()(const ModuleUnit& module) {
    line(title(module.kind) + ": " + module.name.text);
    for (const auto& text : module.descriptions) line("DESCRIPTION " + quoted(text));
    const auto& sensor = module.sensor;
    if (sensor.drivers) line("SENSOR DRIVER " + list_or_none(sensor.drivers->names));
    texts("METHOD", sensor.methods);
    if (sensor.returns) line("RETURNS " + list_or_none(sensor.returns->names));
    for (const auto& activity : module.activities) {
      line("ACTIVITY " + activity.name.text +
           (activity.reads.empty() ? "" : " READS " + list(activity.reads)) +
           (activity.writes.empty() ? "" : " WRITES " + list(activity.writes)) +
           (activity.time ? " TIME " + to_text(*activity.time) : ""));
    }
    if (!module.has_body) return;
    line("BEGIN");
    statements(module.body);
    line("END");
  }

  void operator()(const SkillUnit& skill) {
    line("SKILL " + skill.name.text);
    texts("DESCRIPTION", skill.descriptions);
    texts("PRECONDITION", skill.preconditions);
    texts("POSTCONDITION", skill.postconditions);
    names("SENSOR DRIVER", skill.sensor_drivers);
    names("MACHINE CONTROLLER", skill.machine_controllers);
    names("LOGICAL SENSOR", skill.logical_sensors);
    texts("MODEL DATA", skill.model_data);
    names("SKILL METHOD", skill.skill_methods);
    for (const auto& c : skill.contingencies) {
      line("CONTINGENCY " + std::to_string(c.number) + " " + quoted(c.description) +
           (c.method ? " METHOD " + c.method->text : ""));
    }
    for (const auto& p : skill.parameters) parameter(p);
    for (const auto& c : skill.completions) {
      const auto kind = c.kind == pan::Completion::Kind::normal ? std::string(" NORMAL")
                        : c.kind == pan::Completion::Kind::error
                            ? std::string(" ERROR")
                            : " CONTINGENCY " + std::to_string(c.contingency);
      line("COMPLETION " + std::to_string(c.code) + kind + with_text(c.description));
    }
    for (const auto& r : skill.requirements) line(requirement_text(r));
    line("END SKILL");
  }

  void operator()(const EnvironmentUnit& environment) {
    line("ENVIRONMENT " + environment.name.text);
    texts("DESCRIPTION", environment.descriptions);
    const auto& has = environment.resources;
    if (has.sensor_drivers) line("SENSOR DRIVER " + list_or_none(has.sensor_drivers->names));
    if (has.logical_sensors) line("LOGICAL SENSOR " + list_or_none(has.logical_sensors->names));
    if (has.machine_controllers) line("MACHINE CONTROLLER " + list_or_none(has.machine_controllers->names));
    if (has.skills) line("GENERIC SKILL " + list_or_none(has.skills->names));
    for (const auto& p : environment.processors)
      line("PROCESSOR " + p.name + (p.preemptive ? "" : " NONPREEMPTIVE"));
    for (const auto& d : environment.devices) {
      line("DEVICE " + d.device + " " + std::visit([](const auto& b) { return behaviour(b); }, d.behaviour));
    }
    for (const auto& p : environment.placements) {
      line("PLACE " + p.thread + " ON " + p.processor + " PRIORITY " + std::to_string(p.priority));
    }
    for (const auto& t : environment.activities) {
      line("TIME " + t.activity + (t.module.empty() ? "" : " OF " + t.module) + " : " + to_text(t.time));
    }
    for (const auto& c : environment.costs) line(cost(c.kind) + " " + to_text(c.time));
    line("END ENVIRONMENT");
  }

 private:
  void line(const std::string& text) { out_ << text << '\n'; }

  void texts(const char* slot, const std::vector<std::string>& all) {
    for (const auto& text : all) line(slot + (" " + quoted(text)));
  }

  void names(const char* slot, const std::vector<Name>& all) {
    if (!all.empty()) line(slot + (" " + list(all)));
  }

  static std::string type(const pan::Field& field) {
    return pan::declared_type(field.type, field.unit, field.size);
  }

  static std::string payload(const MessageUnit& message) {
    if (message.fields.empty()) return "SIGNAL";
    if (message.field_names.empty()) return type(message.fields.front());
    std::string result;
    for (std::size_t i = 0; i < message.fields.size(); ++i) {
      const auto& field = message.fields[i];
      const bool last = i + 1 == message.fields.size() || !pan::of_one_type(field, message.fields[i + 1]);
      result += field.name + (!last ? ", " : " : " + type(field));
      if (last && i + 1 != message.fields.size()) result += "; ";
    }
    return result;
  }

  void parameter(const Parameter& p) {
    const auto literal = [](const Literal& value) {
      if (value.text) return quoted(*value.text);
      if (value.digits.empty()) return std::string(value.value != 0 ? "TRUE" : "FALSE");
      return value.digits + (value.unit.empty() ? "" : " " + value.unit);
    };
    auto text =
        "PARAMETER " + p.name.text + " : " + (p.location ? "LOCATION" : pan::declared_type(p.type, p.unit));
    if (p.default_value) text += " DEFAULT " + literal(*p.default_value);
    if (p.low && p.high) text += " RANGE " + literal(*p.low) + " TO " + literal(*p.high);
    line(text + with_text(p.description));
  }

  static std::string behaviour(const pan::EventDevice& d) {
    std::string text = "EVENT " + d.message + (d.sporadic ? " SPORADIC " : " EVERY ") + to_text(d.period);
    if (d.jitter != Duration{}) text += " JITTER " + to_text(d.jitter);
    if (d.phase) text += " PHASE " + to_text(*d.phase);
    if (d.answer_within) text += " ANSWER " + d.answer + " WITHIN " + to_text(*d.answer_within);
    return text;
  }
  static std::string behaviour(const pan::RequestDevice& d) {
    return "ON REQUEST " + to_text(d.answer) + (d.may_fail ? " OR NEVER" : "");
  }
  static std::string behaviour(const pan::FrameDevice& d) {
    std::string text = "FRAMES EVERY " + to_text(d.period) + " COLLECTING " + to_text(d.collecting);
    return d.phase ? text + " PHASE " + to_text(*d.phase) : text;
  }

  static std::string cost(CostItem::Kind kind) {
    switch (kind) {
      case CostItem::Kind::send:
        return "COST SEND";
      case CostItem::Kind::receive:
        return "COST RECEIVE";
      case CostItem::Kind::set:
        return "COST SET";
      case CostItem::Kind::read:
        return "COST READ";
      case CostItem::Kind::test:
        return "COST TEST";
      case CostItem::Kind::latency_within:
        return "LATENCY WITHIN PROCESSOR";
      case CostItem::Kind::latency_between:
        return "LATENCY BETWEEN PROCESSORS";
    }
    return {};
  }

  void statements(const Statements& list) {
    for (const auto& statement : list) {
      line(head(statement));
      std::visit([&](const auto& content) { rest(content); }, statement.content);
    }
  }

  // What follows the head of a compound statement; nothing for the others.
  template <class Simple>
  void rest(const Simple&) {}

  void rest(const WaitBranches& wait) {
    if (wait.first) {
      for (const auto& arm : wait.arms) {
        line("( " + spelling(arm.source.message) + " from " + spelling(arm.source.from) + " ):");
        statements(arm.body);
      }
    } else if (!wait.arms.empty()) {
      statements(wait.arms.front().body);
    }
    if (wait.within) {
      line("ELSE");
      statements(wait.otherwise);
    }
    line("END WTM");
  }

  void rest(const Choose& choose) {
    for (const auto& arm : choose.arms) {
      line("( " + spelling(arm.guard) + " ):");
      statements(arm.body);
    }
    line("END CASE");
  }

  void rest(const Repeat& repeat) {
    statements(repeat.body);
    line(repeat.until ? "UNTIL( " + spelling(*repeat.until) + " )" : "UNTIL( forever )");
  }

  void rest(const Concurrent& concurrent) {
    for (const auto& block : concurrent.blocks) {
      line("BEGIN");
      statements(block.body);
      line("END");
    }
    line("END CONCURRENT");
  }

  std::ostream& out_;
};

}  // namespace

void print(const Tree& tree, std::ostream& out) {
  std::ostringstream words;
  Printer printer(words);
  for (const auto& unit : tree.units) std::visit(printer, unit);
  SourceManager sources;
  Diagnostics diagnostics;
  const auto text = format(sources, sources.add("", words.str()), diagnostics);
  out << (text ? *text : words.str());
}

}  // namespace pal::syntax
