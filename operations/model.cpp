#include "operations/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "pal/support/file_system.hpp"

namespace pal::operations {
namespace {

// In the order of IconKind.
const std::vector<std::string>& kind_names() {
  static const std::vector<std::string> names{"start", "skill", "case",      "merge",   "delay",
                                              "wait",  "test",  "operation", "restart", "exit"};
  return names;
}

}  // namespace

std::optional<std::size_t> find_icon(const Operation& operation, const std::string& id) {
  for (std::size_t i = 0; i < operation.icons.size(); ++i)
    if (operation.icons[i].id == id) return i;
  return std::nullopt;
}

std::optional<std::size_t> find_sub_operation(const Program& program, const Operation& from,
                                              const Icon& icon) {
  const std::string file = icon.file.empty() ? from.from : resolve_path(from.from, icon.file);
  for (std::size_t i = 0; i < program.operations.size(); ++i) {
    const Operation& candidate = program.operations[i];
    if (candidate.from != file) continue;
    // A file alone means its first operation.
    if (icon.operation.empty() || candidate.name == icon.operation) return i;
  }
  return std::nullopt;
}

std::vector<Place> find_path(const Program& program, const std::string& path) {
  std::vector<Place> places;
  std::optional<std::size_t> operation = 0;
  for (std::size_t begin = 0; begin <= path.size();) {
    if (!operation) return {};
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const Operation& here = program.operations[*operation];
    const auto icon = find_icon(here, path.substr(begin, end - begin));
    if (!icon) return {};
    places.push_back({*operation, *icon});
    operation = here.icons[*icon].kind == IconKind::sub_operation
                    ? find_sub_operation(program, here, here.icons[*icon])
                    : std::nullopt;
    begin = end + 1;
  }
  return places;
}

std::vector<Connection> outputs(const Icon& icon) {
  std::vector<Connection> result;
  const auto add = [&](const Connection& connection) {
    if (connection.connected()) result.push_back(connection);
  };
  add(icon.next);
  for (const Way& way : icon.ways) add(way.to);
  add(icon.otherwise);
  add(icon.error);
  return result;
}

int code_of(const Icon& test, double reading) {
  return static_cast<int>(
      std::count_if(test.limits.begin(), test.limits.end(), [&](double limit) { return reading >= limit; }));
}

bool is_met(const Icon& wait, double reading) {
  return (!wait.at_least || reading >= *wait.at_least) && (!wait.at_most || reading <= *wait.at_most);
}

std::string condition_text(const Icon& wait) {
  if (wait.at_least && wait.at_most) return fmt::format("from {} to {}", *wait.at_least, *wait.at_most);
  return wait.at_least ? fmt::format("at least {}", *wait.at_least)
                       : fmt::format("at most {}", wait.at_most.value_or(0));
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

std::string to_text(const Parameter& parameter) {
  return parameter.count_of.empty() ? to_text(parameter.value) : "the count of " + parameter.count_of;
}

}  // namespace pal::operations
