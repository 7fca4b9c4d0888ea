#include "pal/doc/document.hpp"

#include <array>
#include <charconv>
#include <utility>

#include "pal/doc/facts.hpp"
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
    add(items("Sensors", modules_of(pan::ModuleKind::sensor_driver)));
    add(items("Robotic Machines", modules_of(pan::ModuleKind::machine_controller)));
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
    for (std::size_t i = 0; i < network_.modules.size(); ++i) {
      if (network_.modules[i].kind == kind) lines.push_back(line_of(network_, pan::ModuleId(i)));
    }
    return lines;
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

  /// A row of a thing: its name, and its facts.
  void add_row(Table& table, const std::string& name, const std::vector<Fact>& facts) const {
    std::vector<Line> row{code(name)};
    for (const auto& fact : facts) row.push_back(fact.line);
    table.rows.push_back(std::move(row));
    if (table.heads.size() > 1) return;
    for (const auto& fact : facts) table.heads.push_back(fact.head);
  }

  Table messages() const {
    Table table{{"Message"}, {}};
    for (std::size_t i = 0; i < network_.messages.size(); ++i) {
      const auto& message = network_.messages[i];
      if (!message.asks_for.valid()) add_row(table, message.name, facts_of(network_, pan::MessageId(i)));
    }
    return table;
  }

  Table conditions() const {
    Table table{{"Condition"}, {}};
    for (std::size_t i = 0; i < network_.conditions.size(); ++i)
      add_row(table, network_.conditions[i].name, facts_of(network_, pan::ConditionId(i)));
    return table;
  }

  Table activities() const {
    Table table{{"Activity"}, {}};
    for (std::size_t i = 0; i < network_.activities.size(); ++i)
      add_row(table, network_.activities[i].name, facts_of(network_, pan::ActivityId(i)));
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
