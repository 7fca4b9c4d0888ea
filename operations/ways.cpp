#include "operations/ways.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "operations/codes.hpp"

namespace pal::operations {
namespace {

/// An operation is left with a code, after a way.
struct Left {
  int code = 0;
  bool ended = false;  // for good: it went back to where it had been
  WayThrough way;
};

class Walk {
 public:
  Walk(const Program& program, const Skills& skills, const SkillTimes& times, std::size_t most)
      : program_(program),
        skills_(skills),
        times_(times),
        most_(most),
        exits_(possible_codes(program, skills).exits) {}

  std::vector<Left> through(std::size_t operation, const std::string& prefix) {
    std::vector<Left> result;
    const auto& icons = program_.operations[operation].icons;
    for (std::size_t i = 0; i < icons.size(); ++i) {
      if (icons[i].kind != IconKind::start) continue;
      Place place{operation, prefix, {}, result};
      Left empty;
      empty.way.longest = Duration::zero();
      go(place, icons[i].next, empty);
      break;
    }
    return result;
  }
  bool complete() const { return complete_; }

 private:
  struct Place {
    std::size_t operation;
    std::string prefix;
    std::vector<std::string> visited;
    std::vector<Left>& result;
  };

  void finish(Place& place, Left left, std::string end, bool ended) {
    if (place.result.size() >= most_) {
      complete_ = false;
      return;
    }
    left.way.end = std::move(end);
    left.ended = ended;
    place.result.push_back(std::move(left));
  }

  void go(Place& place, const Connection& to, Left left) {
    const Operation& operation = program_.operations[place.operation];
    const auto index = find_icon(operation, to.icon);
    if (!index || !complete_) return;
    const Icon& icon = operation.icons[*index];
    if (std::find(place.visited.begin(), place.visited.end(), icon.id) != place.visited.end())
      return finish(place, std::move(left), fmt::format("back to {}{}", place.prefix, icon.id), true);
    place.visited.push_back(icon.id);
    visit(place, operation, icon, std::move(left));
    place.visited.pop_back();
  }

  void visit(Place& place, const Operation& operation, const Icon& icon, Left left) {
    switch (icon.kind) {
      case IconKind::exit:
        left.code = icon.code.value_or(left.code);
        finish(place, left, fmt::format("exit {}{} with code {}", place.prefix, icon.id, left.code), false);
        break;
      case IconKind::restart:
        finish(place, std::move(left), fmt::format("restart by {}{}", place.prefix, icon.id), true);
        break;
      case IconKind::branch:
        if (const auto way = way_of(icon, left.code)) go(place, *way, std::move(left));
        break;
      case IconKind::skill:
      case IconKind::wait:
      case IconKind::test:
        for (const auto& [code, normal] : completions_of(program_, operation, icon, skills_, exits_))
          if (const auto way = route(operation, icon, code, normal))
            go(place, *way, after_skill(place, icon, left, code));
        break;
      case IconKind::sub_operation:
        inside(place, operation, icon, left);
        break;
      case IconKind::delay: {
        const Duration time(static_cast<std::int64_t>(icon.seconds * 1e9));
        left.way.shortest += time;
        if (left.way.longest) *left.way.longest += time;
        left.way.icons.push_back(place.prefix + icon.id);
        [[fallthrough]];
      }
      default:
        go(place, icon.next, std::move(left));
    }
  }

  /// Or behind a wait or a test: nothing is proved of how long a sensor takes.
  Left after_skill(const Place& place, const Icon& icon, Left left, int code) {
    left.code = code;
    left.way.icons.push_back(fmt::format("{}{} ({})", place.prefix, icon.id, code));
    const auto time = icon.sensor.empty() ? times_.find({icon.skill, code}) : times_.end();
    if (time == times_.end()) {
      left.way.longest.reset();
      const std::string what = icon.sensor.empty() ? icon.skill : "the sensor " + icon.sensor;
      auto& unbounded = left.way.unbounded;
      if (std::find(unbounded.begin(), unbounded.end(), what) == unbounded.end()) unbounded.push_back(what);
    } else if (left.way.longest) {
      *left.way.longest += time->second;
    }
    return left;
  }

  void inside(Place& place, const Operation& operation, const Icon& icon, const Left& before) {
    const auto sub = find_sub_operation(program_, operation, icon);
    if (!sub) return;
    for (const Left& part : through(*sub, place.prefix + icon.id + "/")) {
      Left left = before;
      left.code = part.code;
      left.way.shortest += part.way.shortest;
      left.way.icons.insert(left.way.icons.end(), part.way.icons.begin(), part.way.icons.end());
      if (left.way.longest && part.way.longest) {
        *left.way.longest += *part.way.longest;
      } else {
        left.way.longest.reset();
      }
      for (const std::string& skill : part.way.unbounded)
        if (std::find(left.way.unbounded.begin(), left.way.unbounded.end(), skill) ==
            left.way.unbounded.end())
          left.way.unbounded.push_back(skill);
      if (part.ended) {
        finish(place, left, part.way.end, true);
      } else if (const auto way = route(operation, icon, part.code, part.code == 0)) {
        go(place, *way, left);
      }
    }
  }

  const Program& program_;
  const Skills& skills_;
  const SkillTimes& times_;
  std::size_t most_;
  std::vector<std::set<int>> exits_;
  bool complete_ = true;
};

}  // namespace

Ways ways_through(const Program& program, const Skills& skills, const SkillTimes& times, std::size_t most) {
  Walk walk(program, skills, times, most);
  Ways result;
  for (Left& left : walk.through(0, "")) result.ways.push_back(std::move(left.way));
  result.complete = walk.complete();
  return result;
}

}  // namespace pal::operations
