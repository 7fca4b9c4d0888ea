#include "operations/codes.hpp"

#include <algorithm>

namespace pal::operations {
namespace {

bool names_code(const Icon& branch, int code) {
  return std::any_of(branch.ways.begin(), branch.ways.end(), [&](const Way& way) {
    return std::find(way.codes.begin(), way.codes.end(), code) != way.codes.end();
  });
}

/// Hands the codes of one icon on along its outputs.
class Spread {
 public:
  Spread(const Program& program, const Skills& skills, PossibleCodes& codes)
      : program_(program), skills_(skills), codes_(codes) {}

  bool go_once() {
    changed_ = false;
    for (std::size_t o = 0; o < program_.operations.size(); ++o)
      for (std::size_t i = 0; i < program_.operations[o].icons.size(); ++i) spread(o, i);
    return changed_;
  }

 private:
  void spread(std::size_t o, std::size_t i) {
    const Operation& operation = program_.operations[o];
    const Icon& icon = operation.icons[i];
    const std::set<int> here = codes_.at[o][i];
    if (here.empty() && icon.kind != IconKind::start) return;
    switch (icon.kind) {
      case IconKind::start:
        send(o, icon.next, 0);
        break;
      case IconKind::merge:
      case IconKind::delay:
        for (const int code : here) send(o, icon.next, code);
        break;
      case IconKind::branch:
        for (const int code : here)
          if (const auto way = way_of(icon, code)) send(o, *way, code);
        break;
      case IconKind::exit:
        for (const int code : here) add(codes_.exits[o], icon.code.value_or(code));
        break;
      case IconKind::restart:
        break;
      case IconKind::skill:
      case IconKind::wait:
      case IconKind::test:
      case IconKind::sub_operation:
        for (const auto& [code, normal] : completions_of(program_, operation, icon, skills_, codes_.exits))
          if (const auto way = route(operation, icon, code, normal)) send(o, *way, code);
        break;
    }
  }
  void send(std::size_t o, const Connection& connection, int code) {
    if (const auto to = find_icon(program_.operations[o], connection.icon)) add(codes_.at[o][*to], code);
  }
  void add(std::set<int>& codes, int code) {
    if (codes.insert(code).second) changed_ = true;
  }

  const Program& program_;
  const Skills& skills_;
  PossibleCodes& codes_;
  bool changed_ = false;
};

}  // namespace

bool has_completions(IconKind kind) {
  return kind == IconKind::skill || kind == IconKind::sub_operation || kind == IconKind::wait ||
         kind == IconKind::test;
}

std::optional<Connection> way_of(const Icon& branch, int code) {
  for (const Way& way : branch.ways)
    if (std::find(way.codes.begin(), way.codes.end(), code) != way.codes.end()) return way.to;
  if (branch.otherwise.connected()) return branch.otherwise;
  return std::nullopt;
}

std::optional<std::size_t> case_behind(const Operation& operation, const Connection& connection) {
  auto at = find_icon(operation, connection.icon);
  for (std::size_t steps = 0; at && steps <= operation.icons.size(); ++steps) {
    const Icon& icon = operation.icons[*at];
    if (icon.kind == IconKind::branch) return at;
    if (icon.kind != IconKind::merge && icon.kind != IconKind::delay) return std::nullopt;
    at = find_icon(operation, icon.next.icon);
  }
  return std::nullopt;
}

std::optional<Connection> route(const Operation& operation, const Icon& icon, int code, bool normal) {
  const auto branch = case_behind(operation, icon.next);
  if (branch) {
    const Icon& found = operation.icons[*branch];
    if (names_code(found, code)) return icon.next;
    if (!normal && icon.error.connected()) return icon.error;
    if (found.otherwise.connected()) return icon.next;
    return icon.error.connected() ? icon.error : icon.next;  // the CASE says what it lacks
  }
  if (normal && icon.next.connected()) return icon.next;
  if (icon.error.connected()) return icon.error;
  return std::nullopt;
}

std::vector<std::pair<int, bool>> completions_of(const Program& program, const Operation& operation,
                                                 const Icon& icon, const Skills& skills,
                                                 const std::vector<std::set<int>>& exits) {
  std::vector<std::pair<int, bool>> result;
  if (icon.kind == IconKind::sub_operation) {
    if (const auto sub = find_sub_operation(program, operation, icon))
      for (const int code : exits[*sub]) result.emplace_back(code, code == 0);
    return result;
  }
  if (icon.kind == IconKind::test) {
    for (int code = 0; code <= static_cast<int>(icon.limits.size()); ++code) result.emplace_back(code, true);
    result.emplace_back(sensor_failed, false);
    return result;
  }
  if (icon.kind == IconKind::wait) {
    result.emplace_back(0, true);
    if (icon.timeout) result.emplace_back(waited_in_vain, false);
    result.emplace_back(sensor_failed, false);
    return result;
  }
  const auto skill = skills.find(icon.skill);
  if (skill == skills.end()) return {{0, true}};
  for (const pan::Completion& completion : skill->second.completions)
    result.emplace_back(completion.code, completion.kind == pan::Completion::Kind::normal);
  return result;
}

PossibleCodes possible_codes(const Program& program, const Skills& skills) {
  PossibleCodes codes;
  for (const Operation& operation : program.operations) codes.at.emplace_back(operation.icons.size());
  codes.exits.resize(program.operations.size());
  Spread spread(program, skills, codes);
  // Sets only grow, so this ends.
  while (spread.go_once()) {
  }
  return codes;
}

}  // namespace pal::operations
