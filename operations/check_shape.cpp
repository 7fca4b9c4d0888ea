// The drawing of an operation: icons without a way in or out, loops, ends that are not reached.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "operations/check.hpp"
#include "operations/check_values.hpp"
#include "operations/cure.hpp"
#include "operations/graph.hpp"
#include "operations/suggestion.hpp"
#include "pal/support/finding.hpp"

namespace pal::operations {
namespace {

/// The checks of one operation that look at its names and lines.
class OperationShape {
 public:
  OperationShape(const Graph& graph, std::size_t index, Suggestions& suggestions, Diagnostics& diagnostics)
      : graph_(graph),
        index_(index),
        operation_(graph.program().operations[index]),
        suggestions_(suggestions),
        diagnostics_(diagnostics) {}

  void check_names() {
    for (std::size_t i = 0; i < operation_.icons.size(); ++i) {
      const Icon& icon = operation_.icons[i];
      if (icon.id == on_stop_in_path)
        diagnostics_.report(Finding::reserved_icon_name, icon.where, on_stop_in_path);
      const auto first = graph_.find(index_, icon.id);
      if (*first == i) continue;
      diagnostics_.report(Finding::second_icon_of_name, icon.where, icon.id)
          .note(operation_.icons[*first].where, Remark::first_here);
    }
  }

  void check_connections() {
    for (std::size_t i = 0; i < operation_.icons.size(); ++i) {
      const Icon& icon = operation_.icons[i];
      check_values(graph_, {index_, i}, icon, suggestions_, diagnostics_);
      const bool ends = icon.kind == IconKind::exit || icon.kind == IconKind::restart;
      if (icon.kind == IconKind::branch) {
        for (const Way& way : icon.ways)
          check_connection(icon, way.to, fmt::format("for code {}", fmt::join(way.codes, ", ")), true);
        check_connection(icon, icon.otherwise, "'default'", false);
      } else if (icon.kind == IconKind::question) {
        for (const Way& answer : icon.ways)
          check_connection(icon, answer.to, fmt::format("for the answer '{}'", answer.text), true);
        check_connection(icon, icon.error, "'error'", false);
      } else if (!ends) {
        check_connection(icon, icon.next, "'next'", true);
        check_connection(icon, icon.error, "'error'", false);
      }
    }
  }

  void check_start() {
    const auto first = graph_.start(index_);
    if (!first) {
      diagnostics_.report(Finding::no_start, operation_.where, operation_.name).fix = started(graph_, index_);
      return;
    }
    for (std::size_t i = *first + 1; i < operation_.icons.size(); ++i)
      if (operation_.icons[i].kind == IconKind::start)
        diagnostics_.report(Finding::second_start, operation_.icons[i].where, operation_.name);
  }

 private:
  /// Those to which a line can lead.
  const std::vector<std::string>& ids() {
    if (ids_.empty())
      for (const Icon& icon : operation_.icons)
        if (icon.kind != IconKind::start) ids_.push_back(icon.id);
    return ids_;
  }

  void check_connection(const Icon& icon, const Connection& connection, const std::string& output,
                        bool needed) {
    if (!connection.connected()) {
      if (!needed) return;
      Diagnostic& finding = diagnostics_.report(Finding::output_leads_nowhere, icon.where, output, icon.id);
      const auto at = graph_.find(index_, icon.id);
      if (at && &icon.next == &connection) finding.fix = led_to_exit(graph_, {index_, *at}, "next", true);
      return;
    }
    const auto to = graph_.target(index_, connection);
    if (!to) {
      const auto near = suggestions_.nearest_to(connection.icon, ids());
      diagnostics_.report(Finding::no_such_icon, connection.where, connection.icon, operation_.name)
          .suggest(near)
          .fix = renamed(connection.where, near);
    } else if (operation_.icons[*to].kind == IconKind::start) {
      diagnostics_.report(Finding::start_has_no_input, connection.where);
    }
  }

  const Graph& graph_;
  std::size_t index_;
  const Operation& operation_;
  Suggestions& suggestions_;
  Diagnostics& diagnostics_;
  std::vector<std::string> ids_;
};

/// Every icon that one comes to by these lines, from any of these icons.
std::vector<bool> reached(const std::vector<std::vector<std::size_t>>& leads_to,
                          std::vector<std::size_t> from) {
  std::vector<bool> seen(leads_to.size(), false);
  for (const std::size_t icon : from) seen[icon] = true;
  while (!from.empty()) {
    const std::size_t here = from.back();
    from.pop_back();
    for (const std::size_t to : leads_to[here])
      if (!seen[to]) {
        seen[to] = true;
        from.push_back(to);
      }
  }
  return seen;
}

bool takes_time(const Icon& icon) {
  return icon.kind == IconKind::skill || icon.kind == IconKind::sub_operation ||
         icon.kind == IconKind::wait || icon.kind == IconKind::test || icon.kind == IconKind::question ||
         icon.kind == IconKind::zero || icon.kind == IconKind::planned ||
         (icon.kind == IconKind::delay && icon.seconds->source.written() && icon.seconds->number > 0);
}

/// The checks of one operation that follow its lines.
class OperationLines {
 public:
  OperationLines(const Graph& graph, std::size_t index, Diagnostics& diagnostics)
      : operation_(graph.program().operations[index]),
        start_(graph.start(index)),
        diagnostics_(diagnostics),
        leads_to_(operation_.icons.size()) {
    for (std::size_t i = 0; i < leads_to_.size(); ++i) leads_to_[i] = graph.targets({index, i});
    if (start_) reached_ = reached(leads_to_, {*start_});
  }

  void check_reach() {
    if (!start_) return;
    for (std::size_t i = 0; i < operation_.icons.size(); ++i) {
      if (reached_[i] || operation_.icons[i].kind == IconKind::start) continue;
      diagnostics_.report(Finding::no_way_leads_to_icon, operation_.icons[i].where, operation_.icons[i].id);
    }
  }

  /// A RESTART leads to START.
  void check_idle_loops() {
    auto idle = leads_to_;
    for (std::size_t i = 0; i < idle.size(); ++i) {
      if (takes_time(operation_.icons[i])) idle[i].clear();
      if (operation_.icons[i].kind == IconKind::restart && start_) idle[i].push_back(*start_);
    }
    auto found = circles(idle);
    if (found.empty()) return;
    // One is enough: every icon of a circle would say the same.
    const std::size_t first = std::min_element(found.begin(), found.end())->front();
    diagnostics_.report(Finding::empty_loop, operation_.icons[first].where, operation_.icons[first].id);
  }

  /// The first icon from which no EXIT can be reached tells where the endless part begins.
  void check_endless() {
    if (!start_) return;
    std::vector<std::size_t> exits, restarts;
    std::vector<std::vector<std::size_t>> comes_from(leads_to_.size());
    for (std::size_t i = 0; i < leads_to_.size(); ++i) {
      for (const std::size_t to : leads_to_[i]) comes_from[to].push_back(i);
      if (reached_[i] && operation_.icons[i].kind == IconKind::exit) exits.push_back(i);
      if (reached_[i] && operation_.icons[i].kind == IconKind::restart) restarts.push_back(i);
    }
    if (!exits.empty()) exits.insert(exits.end(), restarts.begin(), restarts.end());
    const std::vector<bool> ends = reached(comes_from, exits);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (!reached_[i] || ends[i]) continue;
      diagnostics_.report(Finding::no_exit, operation_.icons[i].where, operation_.icons[i].id);
      return;
    }
  }

 private:
  const Operation& operation_;
  std::optional<std::size_t> start_;
  Diagnostics& diagnostics_;
  std::vector<std::vector<std::size_t>> leads_to_;
  std::vector<bool> reached_;  // from START
};

class Containment {
 public:
  Containment(const Graph& graph, Suggestions& suggestions, Diagnostics& diagnostics)
      : graph_(graph), suggestions_(suggestions), diagnostics_(diagnostics) {}

  void check() {
    done_.assign(graph_.program().operations.size(), 0);
    for (std::size_t i = 0; i < done_.size(); ++i) {
      const Operation& operation = graph_.program().operations[i];
      if (operation.on_stop.given() && !graph_.on_stop(i))
        report_missing(operation, operation.on_stop.operation, operation.on_stop.file,
                       operation.on_stop.where);
      if (done_[i] == 0) visit(i);
    }
  }

 private:
  /// The operation with all that is in it; without recursion, since they can be nested by the thousand.
  void visit(std::size_t root) {
    std::vector<Place> walk{{root, 0}};  // the next icon to look at
    done_[root] = 1;
    while (!walk.empty()) {
      const Place at = walk.back();
      const Operation& operation = graph_.program().operations[at.operation];
      if (at.icon == operation.icons.size()) {
        done_[at.operation] = 2;
        walk.pop_back();
        continue;
      }
      ++walk.back().icon;
      const Icon& icon = operation.icons[at.icon];
      if (icon.kind != IconKind::sub_operation) continue;
      const auto sub = graph_.sub_operation(at);
      if (!sub) {
        report_missing(operation, icon.operation, icon.file, icon.subject);
      } else if (done_[*sub] == 1) {
        diagnostics_.report(Finding::operation_contains_itself, icon.subject,
                            graph_.program().operations[*sub].name, icon.id);
      } else if (done_[*sub] == 0) {
        done_[*sub] = 1;
        walk.push_back({*sub, 0});
      }
    }
  }
  void report_missing(const Operation& operation, const std::string& name, const std::string& file,
                      SourceSpan where) {
    if (names_of_ != operation.from) {
      names_.clear();
      for (const Operation& each : graph_.program().operations)
        if (each.from == operation.from) names_.push_back(each.name);
      names_of_ = operation.from;
    }
    diagnostics_
        .report(either<Finding::no_operation_in_file, Finding::no_such_operation>(name.empty()), where,
                name.empty() ? file : name)
        .suggest(suggestions_.nearest_to(name, names_));
  }

  const Graph& graph_;
  Suggestions& suggestions_;
  Diagnostics& diagnostics_;
  std::vector<int> done_;  // 1: being visited, 2: visited
  std::string names_of_;   // the file of these names
  std::vector<std::string> names_;
};

}  // namespace

bool check_shape(const Program& program, Diagnostics& diagnostics, const Stop& stop) {
  const Graph graph(program);
  Suggestions suggestions;
  for (std::size_t o = 0; o < program.operations.size(); ++o) {
    if (stop && stop()) return false;
    OperationShape shape(graph, o, suggestions, diagnostics);
    shape.check_names();
    shape.check_connections();
    shape.check_start();
    OperationLines lines(graph, o, diagnostics);
    lines.check_reach();
    lines.check_idle_loops();
    lines.check_endless();
  }
  if (stop && stop()) return false;
  Containment(graph, suggestions, diagnostics).check();
  return true;
}

std::set<std::string> skills_of(const Program& program) {
  std::set<std::string> result;
  for (const Operation& operation : program.operations)
    for (const Icon& icon : operation.icons)
      if (icon.kind == IconKind::skill) result.insert(icon.skill);
  return result;
}

}  // namespace pal::operations
