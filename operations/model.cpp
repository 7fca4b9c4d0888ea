#include "operations/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "pal/support/file_system.hpp"

namespace pal::operations {
namespace {

// In the order of IconKind.
const std::vector<std::string>& kind_names() {
  static const std::vector<std::string> names{"start",     "skill",   "case",     "merge", "delay",
                                              "wait",      "test",    "question", "zero",  "planned",
                                              "operation", "restart", "exit"};
  return names;
}

std::optional<std::size_t> find_operation(const Program& program, const Operation& from,
                                          const std::string& named_file, const std::string& name) {
  const std::string file = named_file.empty() ? from.from : resolve_path(from.from, named_file);
  for (std::size_t i = 0; i < program.operations.size(); ++i) {
    const Operation& candidate = program.operations[i];
    if (candidate.from != file) continue;
    // A file alone means its first operation.
    if (name.empty() || candidate.name == name) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> find_icon(const Operation& operation, const std::string& id) {
  for (std::size_t i = 0; i < operation.icons.size(); ++i)
    if (operation.icons[i].id == id) return i;
  return std::nullopt;
}

std::optional<std::size_t> find_sub_operation(const Program& program, const Operation& from,
                                              const Icon& icon) {
  return find_operation(program, from, icon.file, icon.operation);
}

std::vector<Place> find_path(const Program& program, const std::string& path) {
  std::vector<Place> places;
  std::optional<std::size_t> operation = 0;
  for (std::size_t begin = 0; begin <= path.size();) {
    if (!operation) return {};
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const Operation& here = program.operations[*operation];
    const std::string id = path.substr(begin, end - begin);
    begin = end + 1;
    if (id == on_stop_in_path) {
      operation = find_operation(program, here, here.on_stop.file, here.on_stop.operation);
      continue;
    }
    const auto icon = find_icon(here, id);
    if (!icon) return {};
    places.push_back({*operation, *icon});
    operation = here.icons[*icon].kind == IconKind::sub_operation
                    ? find_sub_operation(program, here, here.icons[*icon])
                    : std::nullopt;
  }
  return places;
}

std::vector<Connection> outputs(const Icon& icon) {
  std::vector<Connection> result;
  const auto add = [&](const Connection& connection) {
    if (connection.connected()) result.push_back(connection);
  };
  add(icon.next);
  for (const Way& way : icon.ways) add(way.to);  // of a question: its answers
  add(icon.otherwise);
  add(icon.error);
  return result;
}

std::optional<Extent> extent_of(const Program& program, SourceSpan where) {
  const auto order = [](const Extent& each, SourceSpan place) {
    return std::pair(each.where.file, each.where.end) <= std::pair(place.file, place.begin);
  };
  const auto found = std::lower_bound(program.extents.begin(), program.extents.end(), where, order);
  if (found == program.extents.end() || found->where.file != where.file || found->where.begin > where.begin)
    return std::nullopt;
  return *found;
}

std::string code_text(int code) {
  return code == any_code ? "any other" : std::to_string(code);
}

std::string condition_text(const Condition& condition) {
  if (condition.at_least && condition.at_most)
    return fmt::format("from {} to {}", to_text(*condition.at_least), to_text(*condition.at_most));
  if (condition.at_least) return "at least " + to_text(*condition.at_least);
  return condition.at_most ? "at most " + to_text(*condition.at_most) : "";
}

std::string subject_text(const Condition& condition) {
  return condition.sensor.empty() ? to_text(condition.value.source) : condition.sensor;
}

std::string conditions_text(const Icon& icon) {
  std::string text;
  for (const Condition& each : icon.conditions) {
    if (!text.empty()) text += icon.combination == Combination::any ? " or " : " and ";
    text += fmt::format("{} {}", subject_text(each), condition_text(each));
  }
  return text;
}

std::string subjects_text(const Icon& icon) {
  std::string text = icon.sensor;
  for (const Condition& each : icon.conditions) text += (text.empty() ? "" : ", ") + subject_text(each);
  return text;
}

std::string question_text(const Icon& icon) {
  if (icon.kind != IconKind::planned) return icon.text;
  std::string values;
  for (const pan::Parameter& each : icon.planned) {
    const std::string value = each.type == pan::ScalarType::text ? each.default_text
                              : each.type == pan::ScalarType::boolean
                                  ? std::string(each.default_value != 0 ? "true" : "false")
                                  : fmt::format("{:g}", each.default_value);
    values += fmt::format("{}{} = {}{}{}", values.empty() ? "" : ", ", each.name, value,
                          each.unit.empty() ? "" : " ", each.unit);
  }
  return icon.skill + (values.empty() ? "" : fmt::format(" ({})", values)) +
         (icon.note.empty() ? "" : ": " + icon.note);
}

const char* name(IconKind kind) {
  return kind_names()[static_cast<std::size_t>(kind)].c_str();
}

std::optional<IconKind> icon_kind(const std::string& name) {
  const auto& names = kind_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<IconKind>(found - names.begin());
}

const std::vector<std::string>& icon_kind_names() {
  return kind_names();
}

Value parse_value(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem == std::errc() && end == text.data() + text.size()) return number;
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') return text.substr(1, text.size() - 2);
  return text;
}

std::string to_text(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return "\"" + std::get<std::string>(value) + "\"";
}

std::string to_text(const Source& source) {
  switch (source.kind) {
    case Source::Kind::count:
      return "the count of " + source.icon;
    case Source::Kind::argument:
      return "the argument " + source.name;
    case Source::Kind::output:
      return source.name + " of " + source.icon;
    case Source::Kind::written:
      break;
  }
  return {};
}

std::string to_text(const Parameter& parameter) {
  return parameter.source.written() ? to_text(parameter.value) : to_text(parameter.source);
}

std::string to_text(const Amount& amount) {
  return amount.source.written() ? fmt::format("{}", amount.number) : to_text(amount.source);
}

}  // namespace pal::operations
