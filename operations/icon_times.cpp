#include "operations/icon_times.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "operations/check_values.hpp"
#include "operations/codes.hpp"
#include "operations/graph.hpp"

namespace pal::operations {

namespace {

Duration seconds_of(double seconds) {
  return Duration(static_cast<std::int64_t>(seconds * 1e9));
}

std::optional<ValueRange> range_of(const pan::Parameter& parameter) {
  if (parameter.type == pan::ScalarType::text) return std::nullopt;
  if (parameter.type == pan::ScalarType::boolean) return ValueRange{0, 1};
  return ValueRange{parameter.low, parameter.high};
}

/// What the parameter of an icon may be.
std::optional<ValueRange> values_of(const pan::Parameter& wanted, const std::vector<Parameter>& parameters,
                                    const Operation* operation) {
  const auto given = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& each) { return each.name == wanted.name; });
  if (given == parameters.end()) {
    if (wanted.type == pan::ScalarType::text) return std::nullopt;
    return ValueRange{wanted.default_value, wanted.default_value};
  }
  if (given->source.kind == Source::Kind::argument && operation != nullptr) {
    const pan::Parameter* argument = find_argument(*operation, given->source.name);
    return argument == nullptr ? std::nullopt : range_of(*argument);
  }
  if (!given->source.written()) return range_of(wanted);
  if (const auto* truth = std::get_if<bool>(&given->value))
    return ValueRange{*truth ? 1.0 : 0, *truth ? 1.0 : 0};
  if (const auto* number = std::get_if<double>(&given->value)) return ValueRange{*number, *number};
  return std::nullopt;
}

}  // namespace

std::optional<Duration> declared_longest(const pan::Template& skill, int code,
                                         const std::vector<Parameter>& parameters, const Operation* operation,
                                         const DeclaredTimes& times) {
  const auto found = times.find({skill.name, code});
  if (found == times.end()) return std::nullopt;
  const auto seconds = found->second.over([&](const std::string& name) -> std::optional<ValueRange> {
    for (const pan::Parameter& each : skill.parameters)
      if (each.name == name) return values_of(each, parameters, operation);
    return std::nullopt;
  });
  constexpr double most = 9e9;
  if (!seconds || seconds->high < 0 || seconds->high > most) return std::nullopt;
  return seconds_of(seconds->high);
}

Longest longest_of(const Icon& icon, const Operation& operation, int code, const Skills& skills,
                   const SkillTimes& times) {
  if (icon.kind == IconKind::question) return {std::nullopt, "the person who answers " + icon.id};
  if (icon.kind == IconKind::planned) return {std::nullopt, "the person who does " + icon.id};
  if (icon.kind != IconKind::skill) {
    const bool reads =
        !icon.sensor.empty() || std::any_of(icon.conditions.begin(), icon.conditions.end(),
                                            [](const Condition& each) { return !each.sensor.empty(); });
    if (!reads && icon.kind == IconKind::test) return {Duration::zero(), {}};
    return {std::nullopt, (reads ? "the sensor " : "") + subjects_text(icon)};
  }
  const auto time = times.proved.find({icon.skill, code});
  // What comes to rest after its time limit does so in a time that nobody has proved.
  if (code == time_over && time == times.proved.end()) return {std::nullopt, icon.skill + " after its limit"};
  std::optional<Duration> longest;
  bool declared = false;
  if (time != times.proved.end()) {
    longest = time->second;
  } else if (const auto skill = skills.find(icon.skill); skill != skills.end()) {
    longest = declared_longest(skill->second, code, icon.parameters, &operation, times.declared);
    declared = longest.has_value();
  }
  if (icon.time_limit && icon.time_limit->source.written()) {
    const Duration limit = seconds_of(icon.time_limit->number);
    if (!longest || limit < *longest) {
      longest = limit;
      declared = false;
    }
  }
  return {longest, longest ? "" : icon.skill, declared};
}

std::optional<Duration> multiplied(Duration time, double by) {
  const double product = static_cast<double>(time.count()) * by;
  if (product > 9e18) return std::nullopt;
  return Duration(static_cast<std::int64_t>(product));
}

namespace {

/// The longest of a whole operation is the longest path, if no token can go round.
class OperationTimes {
 public:
  OperationTimes(const Graph& graph, const Skills& skills, const SkillTimes& times, const Stop& stop)
      : graph_(graph), skills_(skills), times_(times), codes_(possible_codes(graph, skills, stop)) {
    whole_.resize(graph.program().operations.size());
    icons_.resize(whole_.size());
    for (const std::size_t operation : inner_first(graph)) measure(operation);
  }
  std::vector<IconTime> all() {
    std::vector<IconTime> result;
    for (auto& icons : icons_)
      for (IconTime& each : icons)
        if (has_completions(graph_.icon(each.at).kind) || graph_.icon(each.at).kind == IconKind::delay)
          result.push_back(std::move(each));
    return result;
  }

 private:
  struct Whole {
    Duration shortest{};
    std::optional<Duration> longest;
    std::string unknown;
    bool declared = false;
  };

  IconTime time_of(Place at) const {
    const Icon& icon = graph_.icon(at);
    IconTime result{at, {}, Duration::zero(), {}, {}, false};
    if (icon.kind == IconKind::delay) {
      if (!icon.seconds->source.written()) return {at, {}, std::nullopt, to_text(*icon.seconds), {}, false};
      result.shortest = seconds_of(icon.seconds->number);
      result.longest = result.shortest;
      return result;
    }
    if (!has_completions(icon.kind)) return result;
    const bool counted = icon.repeat && !icon.repeat->source.written();
    const double rounds = icon.repeat && !counted ? icon.repeat->number : 1;
    Duration once_shortest{};
    if (const auto sub = graph_.sub_operation(at)) {
      result.longest = whole_[*sub].longest;
      result.unknown = whole_[*sub].unknown;
      result.declared = whole_[*sub].declared;
      once_shortest = whole_[*sub].shortest;
    } else {
      for (const Ending& ending : endings_of(graph_, at, skills_, codes_.exits)) {
        // A value that is missing is noticed before anything moves.
        if (ending.code == no_value && icon.kind == IconKind::skill &&
            !times_.proved.contains({icon.skill, no_value}))
          continue;
        const Longest longest =
            longest_of(icon, graph_.program().operations[at.operation], ending.code, skills_, times_);
        result.declared = result.declared || longest.declared;
        result.codes.emplace_back(ending.code, longest.time);
        if (!longest.time && result.unknown.empty()) result.unknown = longest.unknown;
        result.longest = result.longest && longest.time
                             ? std::optional(std::max(*result.longest, *longest.time))
                             : std::nullopt;
      }
    }
    if (counted)
      return {at, {}, std::nullopt, to_text(*icon.repeat), std::move(result.codes), result.declared};
    // It may end in the first round, by a code that is not normal.
    result.shortest = once_shortest;
    if (result.longest)
      result.longest = multiplied(*result.longest, std::max(rounds, 1.0) * (1 + icon.retries));
    if (!result.longest && result.unknown.empty()) result.unknown = "it is too long";
    return result;
  }

  void measure(std::size_t operation) {
    const Operation& here = graph_.program().operations[operation];
    std::vector<std::vector<std::size_t>> leads_to;
    for (std::size_t i = 0; i < here.icons.size(); ++i) {
      icons_[operation].push_back(time_of({operation, i}));
      leads_to.push_back(graph_.targets({operation, i}));
    }
    Whole& whole = whole_[operation];
    const auto start = graph_.start(operation);
    if (!start) return;
    const bool restarts = std::any_of(here.icons.begin(), here.icons.end(),
                                      [](const Icon& each) { return each.kind == IconKind::restart; });
    const auto loops = circles(leads_to);
    longest_path(operation, *start, leads_to, loops, restarts, whole);
  }

  void longest_path(std::size_t operation, std::size_t start,
                    const std::vector<std::vector<std::size_t>>& leads_to,
                    const std::vector<std::vector<std::size_t>>& loops, bool restarts, Whole& whole) const {
    if (restarts || !loops.empty()) {
      whole.unknown = "a loop in " + graph_.program().operations[operation].name;
      return;
    }
    // Those that are reached, each behind all that lead to it.
    std::vector<std::size_t> order, next(leads_to.size(), 0);
    std::vector<bool> seen(leads_to.size(), false);
    std::vector<std::size_t> way{start};
    seen[start] = true;
    while (!way.empty()) {
      const std::size_t at = way.back();
      if (next[at] == leads_to[at].size()) {
        order.push_back(at);
        way.pop_back();
        continue;
      }
      const std::size_t to = leads_to[at][next[at]++];
      if (seen[to]) continue;
      seen[to] = true;
      way.push_back(to);
    }
    const auto& icons = icons_[operation];
    std::vector<Duration> shortest(leads_to.size(), Duration::zero()), longest = shortest;
    for (const std::size_t at : order) {
      whole.declared = whole.declared || icons[at].declared;
      Duration least = Duration::max(), most = Duration::zero();
      for (const std::size_t to : leads_to[at]) {
        least = std::min(least, shortest[to]);
        most = std::max(most, longest[to]);
      }
      shortest[at] = icons[at].shortest + (least == Duration::max() ? Duration::zero() : least);
      if (!icons[at].longest || most > Duration::max() - *icons[at].longest) {
        if (whole.unknown.empty()) whole.unknown = icons[at].longest ? "it is too long" : icons[at].unknown;
      } else {
        longest[at] = *icons[at].longest + most;
      }
    }
    whole.shortest = shortest[start];
    if (whole.unknown.empty()) whole.longest = longest[start];
  }

  const Graph& graph_;
  const Skills& skills_;
  const SkillTimes& times_;
  PossibleCodes codes_;
  std::vector<Whole> whole_;
  std::vector<std::vector<IconTime>> icons_;  // by operation and icon
};

}  // namespace

std::vector<IconTime> icon_times(const Program& program, const Skills& skills, const SkillTimes& times,
                                 const Stop& stop) {
  const Graph graph(program);
  return OperationTimes(graph, skills, times, stop).all();
}

}  // namespace pal::operations
