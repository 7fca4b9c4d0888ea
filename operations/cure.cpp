#include "operations/cure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace pal::operations {
namespace {

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string free_name(const Operation& operation, const std::string& wanted) {
  std::string name = wanted;
  for (int i = 2; find_icon(operation, name); ++i) name = fmt::format("{}-{}", wanted, i);
  return name;
}

bool ends_so(const Icon& icon, bool normal) {
  if (icon.kind != IconKind::exit) return false;
  if (!icon.code) return normal;
  return icon.code->source.written() && (icon.code->number == 0) == normal;
}

}  // namespace

std::vector<Edit> renamed(SourceSpan where, const std::optional<std::string>& near) {
  if (!near || !where.valid()) return {};
  return {{where, quoted(*near)}};
}

std::vector<Edit> led_to_exit(const Graph& graph, Place at, const char* field, bool normal) {
  const Icon& icon = graph.icon(at);
  const auto extent = extent_of(graph.program(), icon.where);
  if (!extent || extent->icon != icon.id) return {};
  const Operation& operation = graph.program().operations[at.operation];
  const auto there = std::find_if(operation.icons.begin(), operation.icons.end(),
                                  [&](const Icon& each) { return ends_so(each, normal); });
  const std::uint32_t end = extent->where.end;
  const auto insertion = [&](std::uint32_t place, std::string text) {
    return Edit{{extent->where.file, place, place}, std::move(text)};
  };
  const std::string exit =
      there != operation.icons.end() ? there->id : free_name(operation, normal ? "done" : "failed");
  std::vector<Edit> edits{insertion(end - 1, fmt::format(", \"{}\": {}", field, quoted(exit)))};
  if (there != operation.icons.end()) return edits;
  constexpr double right = 256, down = 112;
  const std::string place =
      icon.at ? fmt::format(", \"at\": [{}, {}]", icon.at->x + right, icon.at->y + (normal ? 0 : down)) : "";
  edits.push_back(insertion(end, fmt::format(", {{\"id\": {}, \"kind\": \"exit\"{}{}}}", quoted(exit),
                                             normal ? "" : ", \"code\": 1", place)));
  return edits;
}

std::vector<Edit> started(const Graph& graph, std::size_t operation) {
  const Operation& here = graph.program().operations[operation];
  if (here.icons.empty()) return {};
  const Icon& first = here.icons.front();
  const auto extent = extent_of(graph.program(), first.where);
  if (!extent || extent->icon != first.id) return {};
  constexpr double left = 168;
  const std::string place =
      first.at ? fmt::format(", \"at\": [{}, {}]", first.at->x - left, first.at->y) : "";
  const std::uint32_t begin = extent->where.begin;
  return {{{extent->where.file, begin, begin},
           fmt::format("{{\"id\": {}, \"kind\": \"start\", \"next\": {}{}}}, ",
                       quoted(free_name(here, "start")), quoted(first.id), place)}};
}

}  // namespace pal::operations
