#include "operations/ways.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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
  bool declared = false;  // some of it, not proved

  void add(Duration time) {
    shortest += time;
    add_longest(time);
  }
  void add_longest(std::optional<Duration> time, bool is_declared = false) {
    declared = declared || is_declared;
    // Ages are not known either.
    if (longest && time && time->count() > std::numeric_limits<std::int64_t>::max() - longest->count())
      time.reset();
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
    return fmt::format("exit {}{} with code {}", prefix, at,
                       code == any_code ? "that is counted" : std::to_string(code));
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
        if (icon.code) code = icon.code->source.written() ? static_cast<int>(icon.code->number) : any_code;
        return finish({Left::How::exit, icon.id, code, {}, {}, times});
      case IconKind::restart:
        return finish({Left::How::restart, icon.id, code, {}, {}, times});
      case IconKind::branch:
        return choose(icon, code, times);
      case IconKind::skill:
      case IconKind::wait:
      case IconKind::test:
      case IconKind::question:
      case IconKind::zero:
      case IconKind::planned:
        for (const Ending& ending : endings_of(graph_, at, skills_, exits_))
          if (const auto way = route(graph_, at, ending.code, ending.normal()))
            after(at, icon, *way, ending, times);
        return;
      case IconKind::sub_operation:
        return through(at, icon, times);
      case IconKind::delay: {
        std::vector<std::string> unbounded;
        if (icon.seconds->source.written()) {
          times.add(Duration(static_cast<std::int64_t>(icon.seconds->number * 1e9)));
        } else {
          times.longest.reset();
          unbounded.push_back("the delay " + icon.id);
        }
        return go(icon.next, code, times, {icon.id}, std::move(unbounded));
      }
      case IconKind::start:
      case IconKind::merge:
        return go(icon.next, code, times);
    }
  }

  /// A code that is not known before it runs may be any that a way names, and any other.
  void choose(const Icon& icon, int code, const Times& times) {
    if (code != any_code) {
      if (const auto way = way_of(icon, code)) go(*way, code, times);
      return;
    }
    for (const Way& way : icon.ways)
      if (!way.codes.empty()) go(way.to, way.codes.front(), times);
    if (icon.otherwise.connected()) go(icon.otherwise, code, times);
  }

  /// All runs of the icon: rounds, and attempts before the last one.
  void after(Place at, const Icon& icon, const Connection& way, const Ending& ending, Times times) {
    std::vector<std::string> unbounded;
    const Operation& operation = graph_.program().operations[at.operation];
    const auto add = [&](const Longest& longest, double runs) {
      if (runs <= 0) return;
      times.add_longest(longest.time ? multiplied(*longest.time, runs) : std::nullopt, longest.declared);
      if (!longest.time && std::find(unbounded.begin(), unbounded.end(), longest.unknown) == unbounded.end())
        unbounded.push_back(longest.unknown);
    };
    add(longest_of(icon, operation, ending.code, skills_, skill_times_), 1);
    if (icon.repeat || icon.retries > 0) {
      const bool counted = icon.repeat && !icon.repeat->source.written();
      const double rounds = icon.repeat && !counted ? icon.repeat->number : 1;
      for (const Ending& before : endings_of(graph_, at, skills_, exits_)) {
        if (counted) add({std::nullopt, to_text(*icon.repeat)}, 1);
        // Each round but the last ends normally, and in each as many attempts fail as may.
        add(longest_of(icon, operation, before.code, skills_, skill_times_),
            before.normal() ? rounds - 1 : rounds * icon.retries);
      }
    }
    go(way, ending.code, times, {fmt::format("{} ({})", icon.id, code_text(ending.code))},
       std::move(unbounded));
  }

  void through(Place at, const Icon& icon, const Times& before) {
    const auto sub = graph_.sub_operation(at);
    if (!sub) return;
    const bool counted = icon.repeat && !icon.repeat->source.written();
    const double rounds = icon.repeat && !counted ? icon.repeat->number : 1;
    // The round that takes longest, of those that are followed by another one.
    std::optional<Duration> longest = Duration::zero();
    Duration shortest = Duration::max();
    bool declared = false;
    std::vector<std::string> unbounded;
    for (const Left& part : inside_[*sub]) {
      if (part.how != Left::How::exit || part.code != 0) continue;
      shortest = std::min(shortest, part.times.shortest);
      longest = longest && part.times.longest ? std::optional(std::max(*longest, *part.times.longest))
                                              : std::nullopt;
      declared = declared || part.times.declared;
      unbounded.insert(unbounded.end(), part.unbounded.begin(), part.unbounded.end());
    }
    if (shortest == Duration::max()) shortest = Duration::zero();
    if (counted) {
      const auto way = route(graph_, at, 0, true);
      Times none = before;
      if (way) go(*way, 0, none, {fmt::format("{} not at all", icon.id)});
    }
    for (const Left& part : inside_[*sub]) {
      Times times = before;
      times.shortest += part.times.shortest;
      times.add_longest(part.times.longest, part.times.declared);
      std::vector<std::string> icons = told_inside(icon, part), unknown = part.unbounded;
      if (counted) {
        times.longest.reset();
        unknown.push_back(to_text(*icon.repeat));
      } else if (rounds > 1) {
        // A round that ends otherwise than with 0 may be the first.
        if (part.code == 0) times.shortest += multiplied(shortest, rounds - 1).value_or(Duration::zero());
        times.add_longest(longest ? multiplied(*longest, rounds - 1) : std::nullopt, declared);
        unknown.insert(unknown.end(), unbounded.begin(), unbounded.end());
        icons.insert(icons.begin(),
                     fmt::format("{} {}{:g} times", icon.id, part.code == 0 ? "" : "up to ", rounds));
      }
      if (part.how == Left::How::exit) {
        if (const auto way = route(graph_, at, part.code, part.code == 0))
          go(*way, part.code, times, std::move(icons), std::move(unknown));
      } else {
        Left left{part.how, icon.id + "/" + part.at, part.code, {}, {}, times};
        if (left.at.size() > most_text_inside) left.at = icon.id + "/…";
        next_.push_back({at.icon, part.code, times, visited_.size(), icons_.size(), unbounded_.size(),
                         std::move(icons), std::move(unknown), std::move(left)});
      }
    }
    // A value that the sub-operation needs may be missing, before it begins.
    for (const Ending& ending : endings_of(graph_, at, skills_, exits_))
      if (ending.kind == pan::Completion::Kind::error)
        if (const auto way = route(graph_, at, ending.code, false))
          go(*way, ending.code, before, {fmt::format("{} ({})", icon.id, ending.code)});
  }
  static std::vector<std::string> told_inside(const Icon& icon, const Left& part) {
    std::vector<std::string> icons;
    std::size_t length = 0;
    for (const std::string& each : part.icons) {
      icons.push_back(icon.id + "/" + each);
      length += icons.back().size();
      if (length > most_text_inside) return {fmt::format("{} ({})", icon.id, code_text(part.code))};
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

/// Ways with the same lines are one.
std::vector<WayThrough> folded(std::vector<Left> all) {
  using Lines = std::tuple<std::vector<std::string>, std::string, Duration, std::optional<Duration>,
                           std::vector<std::string>, bool>;
  std::vector<WayThrough> result;
  std::map<Lines, std::size_t> known;
  for (Left& left : all) {
    const std::string end = left.end("");
    const auto [at, fresh] = known.try_emplace(
        Lines{left.icons, end, left.times.shortest, left.times.longest, left.unbounded, left.times.declared},
        result.size());
    if (fresh) {
      result.push_back({std::move(left.icons), end, left.times.shortest, left.times.longest,
                        std::move(left.unbounded), left.times.declared});
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
