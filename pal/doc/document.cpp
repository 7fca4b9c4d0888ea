#include "pal/doc/document.hpp"

#include <array>
#include <charconv>
#include <utility>

#include "pal/doc/parts.hpp"
#include "pal/pan/dot.hpp"
#include "pal/pan/dump.hpp"

namespace pal::doc {

Line text(std::string words) {
  return {{std::move(words), false}};
}
Line code(std::string name) {
  return {{std::move(name), true}};
}
Line codes(const std::vector<std::string>& names) {
  Line line;
  for (const auto& name : names) {
    if (!line.empty()) line.push_back({", ", false});
    line.push_back({name, true});
  }
  return line;
}
Line operator+(Line left, const Line& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

Section paragraphs(std::string title, const std::vector<std::string>& texts) {
  Paragraphs all;
  for (const auto& each : texts) all.lines.push_back(text(each));
  return texts.empty() ? Section{std::move(title), {}} : Section{std::move(title), {std::move(all)}};
}
Section items(std::string title, std::vector<Line> lines) {
  if (lines.empty()) return {std::move(title), {}};
  return {std::move(title), {Items{std::move(lines)}}};
}
Section table(std::string title, Table table) {
  if (table.rows.empty()) return {std::move(title), {}};
  return {std::move(title), {std::move(table)}};
}

Line named(const std::string& name, const std::vector<std::string>& descriptions) {
  auto line = code(name);
  for (const auto& each : descriptions)
    line = line + text((&each == &descriptions.front() ? ": " : " ") + each);
  return line;
}

std::string type_text(pan::ScalarType type, const std::string& unit, int size) {
  const std::string word = type == pan::ScalarType::real      ? "real"
                           : type == pan::ScalarType::integer ? "integer"
                           : type == pan::ScalarType::boolean ? "boolean"
                                                              : "text";
  const std::string each = size == 0 ? word : std::to_string(size) + " x " + word;
  return unit.empty() ? each : each + ", in " + unit;
}

std::string content_of(const pan::Message& message) {
  if (message.fields.empty()) return "no value; that it comes is all";
  std::string result;
  for (std::size_t i = 0; i < message.fields.size(); ++i) {
    const auto& field = message.fields[i];
    const bool last = i + 1 == message.fields.size() || !pan::of_one_type(field, message.fields[i + 1]);
    const bool unnamed = message.fields.size() == 1 && (field.name.empty() || field.name == "value");
    result += unnamed ? "" : field.name + (last ? ": " : ", ");
    if (!last) continue;
    result += type_text(field.type, field.unit, field.size) + (i + 1 == message.fields.size() ? "" : "; ");
  }
  return result;
}

namespace {

std::string number(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

class Writer {
 public:
  Writer(const pan::Network& network, const SourceManager& sources) : network_(network), sources_(sources) {}

  Document run() {
    Document result{network_.skill.name, {}};
    result.parts.push_back(skill_template());
    for (std::size_t i = 0; i < network_.modules.size(); ++i) {
      if (network_.modules[i].kind != pan::ModuleKind::logical_sensor) continue;
      result.parts.push_back(sensor_part(network_, pan::ModuleId(i)));
    }
    result.parts.push_back(pictures());
    return result;
  }

 private:
  Part skill_template() const {
    const auto& skill = network_.skill;
    Part part{"Generic Skill Template", {}};
    const auto add = [&](Section section) { part.sections.push_back(std::move(section)); };
    add({"Generic Skill Name", {Paragraphs{{code(skill.name)}}}});
    add(paragraphs("Textual Description", skill.descriptions));
    add(paragraphs("Preconditions", skill.preconditions));
    add(paragraphs("Postconditions", skill.postconditions));
    add(items("Sensors", modules_with_devices(pan::ModuleKind::sensor_driver)));
    add(items("Robotic Machines", modules_with_devices(pan::ModuleKind::machine_controller)));
    add(paragraphs("Model Data", skill.model_data));
    add(items("Logical Sensors", modules_of(pan::ModuleKind::logical_sensor)));
    add(items("Skill Methods", modules_of(pan::ModuleKind::skill_module)));
    add(items("Contingency Descriptions", contingencies(false)));
    add(items("Contingency Methods", contingencies(true)));
    add(table("Parameter List", parameters()));
    add(table("Completion Protocol", completions()));
    add(table("Requirements", requirements()));
    add(table("Messages", messages()));
    add(table("Process Conditions", conditions()));
    add(table("Activities", activities()));
    return part;
  }

  const std::string& name(pan::ModuleId id) const { return network_.modules[id.index()].name; }

  std::vector<Line> modules_of(pan::ModuleKind kind) const {
    std::vector<Line> lines;
    for (const auto& module : network_.modules) {
      if (module.kind == kind) lines.push_back(named(module.name, module.descriptions));
    }
    return lines;
  }

  /// Each with the devices that it talks with.
  std::vector<Line> modules_with_devices(pan::ModuleKind kind) const {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < network_.modules.size(); ++i) {
      const auto& module = network_.modules[i];
      if (module.kind != kind) continue;
      auto line = named(module.name, module.descriptions);
      for (const auto device : devices_of(pan::ModuleId(i))) {
        const auto& known = network_.devices[device.index()];
        line = line + text(". It drives ") + code(known.name) +
               text(known.description.empty() ? "" : ", " + known.description);
      }
      lines.push_back(std::move(line));
    }
    return lines;
  }

  std::vector<pan::DeviceId> devices_of(pan::ModuleId module) const {
    std::vector<bool> talks(network_.devices.size());
    for (const auto& channel : network_.channels) {
      const auto mark = [&](const pan::Party& one, const pan::Party& other) {
        const auto* device = std::get_if<pan::DeviceId>(&other);
        if (device != nullptr && one == pan::Party(module)) talks[device->index()] = true;
      };
      mark(channel.sender, channel.receiver);
      mark(channel.receiver, channel.sender);
    }
    std::vector<pan::DeviceId> result;
    for (std::size_t i = 0; i < talks.size(); ++i) {
      if (talks[i]) result.emplace_back(i);
    }
    return result;
  }

  std::vector<Line> contingencies(bool methods) const {
    std::vector<Line> lines;
    for (const auto& each : network_.skill.contingencies) {
      auto line = text("C" + std::to_string(each.number) + ": ");
      if (!methods) {
        line = line + text(each.description);
      } else if (each.method.valid()) {
        line = line + named(name(each.method), network_.modules[each.method.index()].descriptions);
      }
      lines.push_back(std::move(line));
    }
    return lines;
  }

  Table parameters() const {
    Table table{{"", "Parameter", "Type", "Default", "Range", "Meaning"}, {}};
    int count = 0;
    for (const auto& p : network_.skill.parameters) {
      const bool boolean = p.type == pan::ScalarType::boolean;
      if (p.type == pan::ScalarType::text) {
        table.rows.push_back(
            {text("P" + std::to_string(++count)), code(p.name),
             text(p.location ? "location" : type_text(p.type, {})), code("\"" + p.default_text + "\""),
             text("up to " + std::to_string(pan::longest_text) + " characters"), text(p.description)});
        continue;
      }
      const auto figure = [&](double value) {
        return boolean ? std::string(value != 0 ? "TRUE" : "FALSE") : number(value);
      };
      table.rows.push_back({text("P" + std::to_string(++count)), code(p.name),
                            text(type_text(p.type, p.unit)), text(figure(p.default_value)),
                            text(boolean ? "FALSE or TRUE" : figure(p.low) + " to " + figure(p.high)),
                            text(p.description)});
    }
    return table;
  }

  Table completions() const {
    Table table{{"Code", "Ending", "Meaning"}, {}};
    for (const auto& c : network_.skill.completions) {
      const auto kind = c.kind == pan::Completion::Kind::normal ? std::string("normal completion")
                        : c.kind == pan::Completion::Kind::error
                            ? std::string("error")
                            : "contingency C" + std::to_string(c.contingency);
      table.rows.push_back({text(std::to_string(c.code)), text(kind), text(c.description)});
    }
    return table;
  }

  Table requirements() const {
    Table table{{"Name", "Requirement"}, {}};
    for (const auto& r : network_.requirements) {
      table.rows.push_back({code(r.name), code(as_written(r.where))});
    }
    return table;
  }

  /// What follows the name, on one line and without comments.
  std::string as_written(SourceSpan where) const {
    std::string result;
    bool in_comment = false;
    auto written = sources_.text(where);
    written.remove_prefix(std::min(written.find(':'), written.size() - 1) + 1);
    for (const char c : written) {
      if (c == '#') in_comment = true;
      if (c == '\n' || c == '\r') in_comment = false;
      const bool space =
          in_comment || c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
      if (!space) {
        result += c;
      } else if (!result.empty() && result.back() != ' ') {
        result += ' ';
      }
    }
    return result;
  }

  Table messages() const {
    Table table{{"Message", "Content", "Ways"}, {}};
    for (std::size_t i = 0; i < network_.messages.size(); ++i) {
      const auto& message = network_.messages[i];
      if (message.asks_for.valid()) continue;
      std::string ways;
      for (const auto& channel : network_.channels) {
        if (channel.message != pan::MessageId(i)) continue;
        ways += (ways.empty() ? "" : ", ") + party_name(network_, channel.sender) + " → " +
                party_name(network_, channel.receiver);
      }
      table.rows.push_back({code(message.name), text(content_of(message)), text(ways)});
    }
    return table;
  }

  std::vector<std::string> names_of(const std::vector<pan::MessageId>& messages) const {
    std::vector<std::string> result;
    for (const auto id : messages) result.push_back(network_.messages[id.index()].name);
    return result;
  }

  Table conditions() const {
    Table table{{"Condition", "Meaning", "Set by", "From"}, {}};
    for (const auto& c : network_.conditions) {
      table.rows.push_back({code(c.name), text(c.description),
                            c.writer.valid() ? code(name(c.writer)) : Line{}, codes(names_of(c.from))});
    }
    return table;
  }

  Table activities() const {
    Table table{{"Activity", "Module", "Reads", "Writes"}, {}};
    for (const auto& a : network_.activities) {
      table.rows.push_back(
          {code(a.name), code(name(a.module)), codes(names_of(a.reads)), codes(names_of(a.writes))});
    }
    return table;
  }

  Part pictures() const {
    Part part{"Process Activity Networks", {}};
    for (std::size_t i = 0; i < network_.modules.size(); ++i) {
      const auto& module = network_.modules[i];
      if (module.body.empty()) continue;
      const auto title = module.name + ", " + kind_text(module.kind);
      part.sections.push_back({title,
                               {Picture{"Process Activity Network of " + module.name,
                                        network_.skill.name + "." + module.name + ".pan.svg",
                                        to_dot(network_, pan::ModuleId(i))}}});
    }
    return part;
  }

  const pan::Network& network_;
  const SourceManager& sources_;
};

}  // namespace

Document document(const pan::Network& network, const SourceManager& sources) {
  return Writer(network, sources).run();
}

}  // namespace pal::doc
