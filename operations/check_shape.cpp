// The drawing of an operation: icons without a way in or out, loops, ends that are not reached.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "operations/check.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/nearest.hpp"

namespace pal::operations {
namespace {

std::vector<std::string> ids(const Operation& operation) {
  std::vector<std::string> result;
  for (const Icon& icon : operation.icons) result.push_back(icon.id);
  return result;
}

void check_names(const Operation& operation, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < operation.icons.size(); ++i) {
    const Icon& icon = operation.icons[i];
    const auto first = find_icon(operation, icon.id);
    if (*first == i) continue;
    diagnostics
        .report(Code::PAL1003, icon.where, fmt::format("a second icon is called '{}'", icon.id),
                "give it another id")
        .notes.push_back({operation.icons[*first].where, "the first is here"});
  }
}

void check_connection(const Operation& operation, const Icon& icon, const Connection& connection,
                      const std::string& output, bool needed, Diagnostics& diagnostics) {
  if (!connection.connected()) {
    if (needed)
      diagnostics.report(Code::PAL1004, icon.where,
                         fmt::format("the output {} of '{}' leads nowhere", output, icon.id),
                         "connect it; where the operation is to end, to an EXIT");
    return;
  }
  const auto to = find_icon(operation, connection.icon);
  if (!to) {
    const auto near = nearest(connection.icon, ids(operation));
    diagnostics.report(
        Code::PAL1004, connection.where,
        fmt::format("there is no icon '{}' in operation '{}'", connection.icon, operation.name),
        near ? fmt::format("did you mean '{}'?", *near) : "name an icon of this operation");
  } else if (operation.icons[*to].kind == IconKind::start) {
    diagnostics.report(Code::PAL1004, connection.where, "START has no input",
                       "lead to a RESTART instead, or to the icon behind START");
  }
}

/// What is counted can end normally.
void check_counts(const Operation& operation, const Icon& icon, Diagnostics& diagnostics) {
  for (const Parameter& parameter : icon.parameters) {
    if (parameter.count_of.empty()) continue;
    const auto counted = find_icon(operation, parameter.count_of);
    const IconKind kind = counted ? operation.icons[*counted].kind : IconKind::merge;
    if (kind == IconKind::skill || kind == IconKind::sub_operation) continue;
    const auto near = nearest(parameter.count_of, ids(operation));
    diagnostics.report(Code::PAL1004, parameter.where,
                       fmt::format("operation '{}' has no skill or sub-operation '{}' to count",
                                   operation.name, parameter.count_of),
                       near && *near != parameter.count_of
                           ? fmt::format("did you mean '{}'?", *near)
                           : "name an icon of this operation that runs a skill or a sub-operation");
  }
}

void check_connections(const Operation& operation, Diagnostics& diagnostics) {
  for (const Icon& icon : operation.icons) {
    check_counts(operation, icon, diagnostics);
    const bool ends = icon.kind == IconKind::exit || icon.kind == IconKind::restart;
    if (icon.kind == IconKind::branch) {
      for (const Way& way : icon.ways)
        check_connection(operation, icon, way.to, fmt::format("for code {}", fmt::join(way.codes, ", ")),
                         true, diagnostics);
      check_connection(operation, icon, icon.otherwise, "'default'", false, diagnostics);
    } else if (!ends) {
      check_connection(operation, icon, icon.next, "'next'", true, diagnostics);
      check_connection(operation, icon, icon.error, "'error'", false, diagnostics);
    }
  }
}

std::set<std::size_t> reachable(const Operation& operation, std::size_t from) {
  std::set<std::size_t> seen{from};
  std::vector<std::size_t> waiting{from};
  while (!waiting.empty()) {
    const std::size_t here = waiting.back();
    waiting.pop_back();
    for (const Connection& output : outputs(operation.icons[here]))
      if (const auto to = find_icon(operation, output.icon); to && seen.insert(*to).second)
        waiting.push_back(*to);
  }
  return seen;
}

void check_start_and_reach(const Operation& operation, Diagnostics& diagnostics) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < operation.icons.size(); ++i)
    if (operation.icons[i].kind == IconKind::start) starts.push_back(i);
  if (starts.empty()) {
    diagnostics.report(Code::PAL1015, operation.where,
                       fmt::format("operation '{}' has no START", operation.name),
                       R"(add {"id": "start", "kind": "start", "next": …})");
    return;
  }
  for (std::size_t i = 1; i < starts.size(); ++i)
    diagnostics.report(Code::PAL1015, operation.icons[starts[i]].where,
                       fmt::format("operation '{}' has a second START", operation.name),
                       "keep one; an operation has one token");
  const auto seen = reachable(operation, starts.front());
  for (std::size_t i = 0; i < operation.icons.size(); ++i) {
    if (seen.contains(i) || operation.icons[i].kind == IconKind::start) continue;
    diagnostics.report(Code::PAL1005, operation.icons[i].where,
                       fmt::format("no way leads to '{}'", operation.icons[i].id),
                       "connect an output to it, or remove it");
  }
}

bool takes_time(const Icon& icon) {
  return icon.kind == IconKind::skill || icon.kind == IconKind::sub_operation ||
         icon.kind == IconKind::wait || icon.kind == IconKind::test ||
         (icon.kind == IconKind::delay && icon.seconds > 0);
}

/// Where the token goes from `icon` without anything happening. A RESTART leads to START.
std::vector<std::size_t> idle_steps(const Operation& operation, std::size_t at) {
  std::vector<std::size_t> result;
  const Icon& icon = operation.icons[at];
  if (takes_time(icon)) return result;
  if (icon.kind == IconKind::restart) {
    for (std::size_t i = 0; i < operation.icons.size(); ++i)
      if (operation.icons[i].kind == IconKind::start) result.push_back(i);
  }
  for (const Connection& output : outputs(icon))
    if (const auto to = find_icon(operation, output.icon)) result.push_back(*to);
  return result;
}

void check_idle_loops(const Operation& operation, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < operation.icons.size(); ++i) {
    std::set<std::size_t> seen;
    std::vector<std::size_t> waiting = idle_steps(operation, i);
    bool back = false;
    while (!waiting.empty() && !back) {
      const std::size_t here = waiting.back();
      waiting.pop_back();
      back = here == i;
      if (seen.insert(here).second)
        for (const std::size_t next : idle_steps(operation, here)) waiting.push_back(next);
    }
    if (!back) continue;
    diagnostics.report(Code::PAL1013, operation.icons[i].where,
                       fmt::format("the token can go round from '{}' to itself while nothing happens",
                                   operation.icons[i].id),
                       "put a skill or a delay into the loop");
    return;  // every icon of the circle would say the same
  }
}

void check_endless(const Operation& operation, Diagnostics& diagnostics) {
  const auto start = std::find_if(operation.icons.begin(), operation.icons.end(),
                                  [](const Icon& icon) { return icon.kind == IconKind::start; });
  if (start == operation.icons.end()) return;
  const auto seen = reachable(operation, static_cast<std::size_t>(start - operation.icons.begin()));
  const auto any = [&](const std::set<std::size_t>& icons, IconKind kind) {
    return std::any_of(icons.begin(), icons.end(),
                       [&](std::size_t i) { return operation.icons[i].kind == kind; });
  };
  const bool from_start = any(seen, IconKind::exit);
  // The first icon from which no EXIT can be reached tells where the endless part begins.
  for (const std::size_t here : seen) {
    const auto further = reachable(operation, here);
    const bool ends = any(further, IconKind::exit) || (from_start && any(further, IconKind::restart));
    if (ends) continue;
    diagnostics.report(Code::PAL1011, operation.icons[here].where,
                       fmt::format("from '{}' on there is no EXIT", operation.icons[here].id),
                       "this is allowed: a stop must end the operation, or a code that no icon handles");
    return;
  }
}

class Containment {
 public:
  Containment(const Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics), done_(program.operations.size(), 0) {}

  void visit(std::size_t index) {
    if (done_[index] == 2) return;
    done_[index] = 1;
    const Operation& operation = program_.operations[index];
    for (const Icon& icon : operation.icons) {
      if (icon.kind != IconKind::sub_operation) continue;
      const auto sub = find_sub_operation(program_, operation, icon);
      if (!sub) {
        report_missing(operation, icon);
      } else if (done_[*sub] == 1) {
        diagnostics_.report(Code::PAL1012, icon.subject,
                            fmt::format("operation '{}' contains itself, by way of '{}'",
                                        program_.operations[*sub].name, icon.id),
                            "make a loop of it: by a connection back, or by RESTART");
      } else {
        visit(*sub);
      }
    }
    done_[index] = 2;
  }

 private:
  void report_missing(const Operation& operation, const Icon& icon) {
    std::vector<std::string> names;
    for (const Operation& each : program_.operations)
      if (each.from == operation.from) names.push_back(each.name);
    const auto near = nearest(icon.operation, names);
    diagnostics_.report(Code::PAL1014, icon.subject,
                        icon.operation.empty()
                            ? fmt::format("'{}' holds no operation", icon.file)
                            : fmt::format("there is no operation '{}' in this file", icon.operation),
                        near ? fmt::format("did you mean '{}'?", *near)
                             : "add it under \"operations\", or name the file that has it with \"file\"");
  }

  const Program& program_;
  Diagnostics& diagnostics_;
  std::vector<int> done_;  // 1: being visited, 2: visited
};

}  // namespace

void check_shape(const Program& program, Diagnostics& diagnostics) {
  for (const Operation& operation : program.operations) {
    check_names(operation, diagnostics);
    check_connections(operation, diagnostics);
    check_start_and_reach(operation, diagnostics);
    check_idle_loops(operation, diagnostics);
    check_endless(operation, diagnostics);
  }
  Containment containment(program, diagnostics);
  for (std::size_t i = 0; i < program.operations.size(); ++i) containment.visit(i);
}

std::set<std::string> skills_of(const Program& program) {
  std::set<std::string> result;
  for (const Operation& operation : program.operations)
    for (const Icon& icon : operation.icons)
      if (icon.kind == IconKind::skill) result.insert(icon.skill);
  return result;
}

}  // namespace pal::operations
