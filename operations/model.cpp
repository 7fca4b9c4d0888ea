#include "operations/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pal/support/file_system.hpp"

namespace pal::operations {
namespace {

// In the order of IconKind.
const std::vector<std::string>& kind_names() {
  static const std::vector<std::string> names{"start", "skill",     "case",    "merge",
                                              "delay", "operation", "restart", "exit"};
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

std::string to_text(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return "\"" + std::get<std::string>(value) + "\"";
}

std::string to_text(const Parameter& parameter) {
  return parameter.count_of.empty() ? to_text(parameter.value) : "the count of " + parameter.count_of;
}

}  // namespace pal::operations
