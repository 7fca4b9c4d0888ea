#include "operations/graph.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "pal/support/file_system.hpp"

namespace pal::operations {

Graph::Graph(const Program& program) : program_(program), operations_(program.operations.size()) {
  for (std::size_t o = 0; o < operations_.size(); ++o) {
    const auto& icons = program.operations[o].icons;
    Lookup& lookup = operations_[o];
    lookup.ids.reserve(icons.size());
    for (std::size_t i = 0; i < icons.size(); ++i) {
      lookup.ids.emplace(icons[i].id, i);
      if (icons[i].kind == IconKind::start && !lookup.start) lookup.start = i;
    }
  }
  find_sub_operations();
  for (std::size_t o = 0; o < operations_.size(); ++o) find_cases(o);
}

std::optional<std::size_t> Graph::find(std::size_t operation, std::string_view id) const {
  const auto& ids = operations_[operation].ids;
  const auto found = ids.find(id);
  if (found == ids.end()) return std::nullopt;
  return found->second;
}

std::vector<std::size_t> Graph::targets(Place at) const {
  std::vector<std::size_t> result;
  for (const Connection& output : outputs(icon(at)))
    if (const auto to = target(at.operation, output)) result.push_back(*to);
  return result;
}

void Graph::find_sub_operations() {
  std::map<std::pair<std::string, std::string>, std::size_t> by_name;
  std::map<std::string, std::size_t> first_of_file;
  for (std::size_t o = 0; o < program_.operations.size(); ++o) {
    const Operation& operation = program_.operations[o];
    by_name.emplace(std::pair(operation.from, operation.name), o);
    first_of_file.emplace(operation.from, o);
  }
  const auto find_operation = [&](const Operation& from, const std::string& named_file,
                                  const std::string& name) -> std::optional<std::size_t> {
    const std::string file = named_file.empty() ? from.from : resolve_path(from.from, named_file);
    // A file alone means its first operation.
    if (name.empty()) {
      const auto first = first_of_file.find(file);
      return first == first_of_file.end() ? std::nullopt : std::optional(first->second);
    }
    const auto named = by_name.find({file, name});
    return named == by_name.end() ? std::nullopt : std::optional(named->second);
  };
  for (std::size_t o = 0; o < program_.operations.size(); ++o) {
    const Operation& operation = program_.operations[o];
    operations_[o].subs.resize(operation.icons.size());
    if (operation.on_stop.given())
      operations_[o].on_stop = find_operation(operation, operation.on_stop.file, operation.on_stop.operation);
    for (std::size_t i = 0; i < operation.icons.size(); ++i) {
      const Icon& icon = operation.icons[i];
      if (icon.kind != IconKind::sub_operation) continue;
      const auto found = find_operation(operation, icon.file, icon.operation);
      operations_[o].subs[i] = found;
      if (found) operations_[*found].users.push_back({o, i});
    }
  }
}

void Graph::find_cases(std::size_t operation) {
  const auto& icons = program_.operations[operation].icons;
  auto& cases = operations_[operation].cases;
  cases.resize(icons.size());
  std::vector<bool> known(icons.size(), false);
  for (std::size_t i = 0; i < icons.size(); ++i) {
    // Along the line until something that is known, then the answer back along it.
    std::vector<std::size_t> passed;
    std::optional<std::size_t> at = i, answer;
    while (at && !known[*at]) {
      known[*at] = true;
      passed.push_back(*at);
      const auto next = target(operation, icons[*at].next);
      at.reset();
      if (!next) break;
      if (icons[*next].kind == IconKind::branch) {
        answer = next;
      } else if (icons[*next].kind == IconKind::merge || icons[*next].kind == IconKind::delay) {
        at = next;
      }
    }
    if (at && !answer) answer = cases[*at];
    for (const std::size_t each : passed) cases[each] = answer;
  }
}

std::vector<std::size_t> inner_first(const Graph& graph) {
  const auto& operations = graph.program().operations;
  std::vector<std::size_t> order;
  std::vector<bool> seen(operations.size(), false);
  for (std::size_t root = 0; root < operations.size(); ++root) {
    if (seen[root]) continue;
    seen[root] = true;
    std::vector<Place> walk{{root, 0}};  // the next icon to look at
    while (!walk.empty()) {
      const Place at = walk.back();
      if (at.icon == operations[at.operation].icons.size()) {
        order.push_back(at.operation);
        walk.pop_back();
        continue;
      }
      ++walk.back().icon;
      if (const auto sub = graph.sub_operation(at); sub && !seen[*sub]) {
        seen[*sub] = true;
        walk.push_back({*sub, 0});
      }
    }
  }
  return order;
}

std::vector<std::vector<std::size_t>> circles(const std::vector<std::vector<std::size_t>>& leads_to) {
  // Tarjan's strongly connected components, without recursion.
  constexpr auto unseen = static_cast<std::size_t>(-1);
  std::vector<std::size_t> number(leads_to.size(), unseen), lowest(leads_to.size(), 0), open;
  std::vector<bool> is_open(leads_to.size(), false);
  std::vector<std::vector<std::size_t>> result;
  std::size_t count = 0;
  std::vector<std::pair<std::size_t, std::size_t>> walk;  // where, and the next edge there
  for (std::size_t root = 0; root < leads_to.size(); ++root) {
    if (number[root] != unseen) continue;
    walk.emplace_back(root, 0);
    while (!walk.empty()) {
      auto& [here, edge] = walk.back();
      if (edge == 0) {
        number[here] = lowest[here] = count++;
        open.push_back(here);
        is_open[here] = true;
      }
      if (edge < leads_to[here].size()) {
        const std::size_t to = leads_to[here][edge++];
        if (number[to] == unseen) {
          walk.emplace_back(to, 0);
        } else if (is_open[to]) {
          lowest[here] = std::min(lowest[here], number[to]);
        }
        continue;
      }
      const std::size_t done = here;
      walk.pop_back();
      if (!walk.empty()) lowest[walk.back().first] = std::min(lowest[walk.back().first], lowest[done]);
      if (lowest[done] != number[done]) continue;
      std::vector<std::size_t> group;
      std::size_t member = unseen;
      while (member != done) {
        member = open.back();
        open.pop_back();
        is_open[member] = false;
        group.push_back(member);
      }
      const auto& own = leads_to[done];
      if (group.size() == 1 && std::find(own.begin(), own.end(), done) == own.end()) continue;
      std::sort(group.begin(), group.end());
      result.push_back(std::move(group));
    }
  }
  return result;
}

}  // namespace pal::operations
