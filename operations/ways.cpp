#include "operations/ways.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "operations/codes.hpp"
#include "operations/graph.hpp"

namespace pal::operations {
namespace {

// A sub-operation whose way has more text than this is told by its own icon.
constexpr std::size_t most_text_inside = 1'000;
// Icons that are looked at, for each icon that there is, and for any program.
constexpr std::size_t looks_an_icon = 20, looks_at_least = 100'000;

/// The times of a way so far.
struct Times {
  Duration shortest{};
  std::optional<Duration> longest = Duration::zero();

  void add(Duration time) {
    shortest += time;
    add_longest(time);
  }
  void add_longest(std::optional<Duration> time) {
    longest = longest && time ? std::optional(*longest + *time) : std::nullopt;
  }
};

/// An operation is left, after a way; names are those inside it.
struct Left {
  enum class How { exit, restart, back };
  How how = How::exit;
  std::string at;  // the icon by which, or to which
  int code = 0;
  std::vector<std::string> icons;
  std::vector<std::string> unbounded;
  Times times;

  std::string end(const std::string& prefix) const {
    if (how == How::restart) return "restart by " + prefix + at;
    if (how == How::back) return "back to " + prefix + at;
    return fmt::format("exit {}{} with code {}", prefix, at, code);
  }
};

/// All ways through one operation. The way so far is kept once, and cut back for the next alternative.
class Walk {
 public:
  Walk(const Graph& graph, std::size_t operation, const Skills& skills, const SkillTimes& times,
       const std::vector<CodeSet>& exits, const std::vector<std::vector<Left>>& inside, std::size_t most)
      : graph_(graph),
        operation_(operation),
        skills_(skills),
        skill_times_(times),
        exits_(exits),
        inside_(inside),
        most_(most),
        is_visited_(graph.program().operations[operation].icons.size(), false) {}

  /// Looks at no more than `looks` icons, which it counts down.
  std::vector<Left> all(std::size_t& looks, const Stop& stop) {
    if (const auto start = graph_.start(operation_)) go(graph_.icon({operation_, *start}).next, 0, {});
    while (!next_.empty() && complete_) {
      if (looks == 0 || (stop && stop())) {
        complete_ = false;
        break;
      }
      --looks;
      const Alternative here = std::move(next_.back());
      next_.pop_back();
      take(here);
    }
    return std::move(result_);
  }
  bool complete() const { return complete_; }

 private:
  /// What is still to be looked at: an icon, after this much of the way and a little more.
  struct Alternative {
    std::size_t to = 0;
    int code = 0;
    Times times;
    std::size_t visited = 0, icons = 0, unbounded = 0;  // so much of the way was before
    std::vector<std::string> more_icons, more_unbounded;
    std::optional<Left> end;  // the way ends here: inside a sub-operation, for good
  };

  void go(const Connection& to, int code, Times times, std::vector<std::string> more_icons = {},
          std::vector<std::string> more_unbounded = {}) {
    if (const auto index = graph_.target(operation_, to))
      next_.push_back({*index, code, times, visited_.size(), icons_.size(), unbounded_.size(),
                       std::move(more_icons), std::move(more_unbounded), std::nullopt});
  }
  void finish(Left left) {
    if (result_.size() >= most_) {
      complete_ = false;
      return;
    }
    left.icons.insert(left.icons.begin(), icons_.begin(), icons_.end());
    left.unbounded.insert(left.unbounded.begin(), unbounded_.begin(), unbounded_.end());
    result_.push_back(std::move(left));
  }

  void take(const Alternative& here) {
    while (visited_.size() > here.visited) {
      is_visited_[visited_.back()] = false;
      visited_.pop_back();
    }
    icons_.resize(here.icons);
    unbounded_.resize(here.unbounded);
    icons_.insert(icons_.end(), here.more_icons.begin(), here.more_icons.end());
    for (const std::string& each : here.more_unbounded)
      if (std::find(unbounded_.begin(), unbounded_.end(), each) == unbounded_.end())
        unbounded_.push_back(each);
    if (here.end) return finish(*here.end);
    const Icon& icon = graph_.icon({operation_, here.to});
    if (is_visited_[here.to]) return finish({Left::How::back, icon.id, here.code, {}, {}, here.times});
    is_visited_[here.to] = true;
    visited_.push_back(here.to);
    const std::size_t before = next_.size();
    visit({operation_, here.to}, icon, here.code, here.times);
    // The first one pushed is looked at first.
    std::reverse(next_.begin() + static_cast<std::ptrdiff_t>(before), next_.end());
  }

  void visit(Place at, const Icon& icon, int code, Times times) {
    switch (icon.kind) {
      case IconKind::exit:
        return finish({Left::How::exit, icon.id, icon.code.value_or(code), {}, {}, times});
      case IconKind::restart:
        return finish({Left::How::restart, icon.id, code, {}, {}, times});
      case IconKind::branch:
        if (const auto way = way_of(icon, code)) go(*way, code, times);
        return;
      case IconKind::skill:
      case IconKind::wait:
      case IconKind::test:
        for (const Ending& ending : endings_of(graph_, at, skills_, exits_))
          if (const auto way = route(graph_, at, ending.code, ending.normal()))
            after(icon, *way, ending.code, times);
        return;
      case IconKind::sub_operation:
        return through(at, icon, times);
      case IconKind::delay:
        times.add(Duration(static_cast<std::int64_t>(icon.seconds * 1e9)));
        return go(icon.next, code, times, {icon.id});
      case IconKind::start:
      case IconKind::merge:
        return go(icon.next, code, times);
    }
  }

  /// Behind a skill, or behind a wait or a test: nothing is proved of how long a sensor takes.
  void after(const Icon& icon, const Connection& way, int code, Times times) {
    const auto time = icon.sensor.empty() ? skill_times_.find({icon.skill, code}) : skill_times_.end();
    std::vector<std::string> unbounded;
    if (time == skill_times_.end()) {
      times.longest.reset();
      unbounded.push_back(icon.sensor.empty() ? icon.skill : "the sensor " + icon.sensor);
    } else {
      times.add_longest(time->second);
    }
    go(way, code, times, {fmt::format("{} ({})", icon.id, code)}, std::move(unbounded));
  }

  void through(Place at, const Icon& icon, const Times& before) {
    const auto sub = graph_.sub_operation(at);
    if (!sub) return;
    for (const Left& part : inside_[*sub]) {
      Times times = before;
      times.shortest += part.times.shortest;
      times.add_longest(part.times.longest);
      std::vector<std::string> icons = told_inside(icon, part);
      if (part.how == Left::How::exit) {
        if (const auto way = route(graph_, at, part.code, part.code == 0))
          go(*way, part.code, times, std::move(icons), part.unbounded);
      } else {
        Left left{part.how, icon.id + "/" + part.at, part.code, {}, {}, times};
        if (left.at.size() > most_text_inside) left.at = icon.id + "/…";
        next_.push_back({at.icon, part.code, times, visited_.size(), icons_.size(), unbounded_.size(),
                         std::move(icons), part.unbounded, std::move(left)});
      }
    }
  }
  static std::vector<std::string> told_inside(const Icon& icon, const Left& part) {
    std::vector<std::string> icons;
    std::size_t length = 0;
    for (const std::string& each : part.icons) {
      icons.push_back(icon.id + "/" + each);
      length += icons.back().size();
      if (length > most_text_inside) return {fmt::format("{} ({})", icon.id, part.code)};
    }
    return icons;
  }

  const Graph& graph_;
  std::size_t operation_;
  const Skills& skills_;
  const SkillTimes& skill_times_;
  const std::vector<CodeSet>& exits_;
  const std::vector<std::vector<Left>>& inside_;
  std::size_t most_;
  std::vector<Left> result_;
  std::vector<Alternative> next_;  // the next one last
  // The way so far.
  std::vector<std::size_t> visited_;
  std::vector<bool> is_visited_;
  std::vector<std::string> icons_, unbounded_;
  bool complete_ = true;
};

/// Those that the first operation contains, each behind all that it contains; the first one last.
std::vector<std::size_t> inner_first(const Graph& graph) {
  std::vector<std::size_t> order;
  std::vector<bool> seen(graph.program().operations.size(), false);
  std::vector<Place> walk{{0, 0}};  // the next icon to look at
  seen[0] = true;
  while (!walk.empty()) {
    const Place at = walk.back();
    if (at.icon == graph.program().operations[at.operation].icons.size()) {
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
  return order;
}

/// Ways with the same lines are one.
std::vector<WayThrough> folded(std::vector<Left> all) {
  using Lines = std::tuple<std::vector<std::string>, std::string, Duration, std::optional<Duration>,
                           std::vector<std::string>>;
  std::vector<WayThrough> result;
  std::map<Lines, std::size_t> known;
  for (Left& left : all) {
    const std::string end = left.end("");
    const auto [at, fresh] = known.try_emplace(
        Lines{left.icons, end, left.times.shortest, left.times.longest, left.unbounded}, result.size());
    if (fresh) {
      result.push_back(
          {std::move(left.icons), end, left.times.shortest, left.times.longest, std::move(left.unbounded)});
    } else {
      ++result[at->second].alike;
    }
  }
  return result;
}

}  // namespace

Ways ways_through(const Program& program, const Skills& skills, const SkillTimes& times, std::size_t most,
                  const Stop& stop) {
  const Graph graph(program);
  const PossibleCodes codes = possible_codes(graph, skills, stop);
  Ways result;
  result.complete = codes.complete;
  std::size_t looks = looks_at_least;
  for (const Operation& operation : program.operations) looks += looks_an_icon * operation.icons.size();
  std::vector<std::vector<Left>> inside(program.operations.size());
  for (const std::size_t operation : inner_first(graph)) {
    Walk walk(graph, operation, skills, times, codes.exits, inside, most);
    inside[operation] = walk.all(looks, stop);
    result.complete = result.complete && walk.complete();
  }
  result.ways = folded(std::move(inside.front()));
  return result;
}

}  // namespace pal::operations
