#include "operations/codes.hpp"

#include <algorithm>
#include <deque>

namespace pal::operations {
namespace {

using EndingKind = pan::Completion::Kind;

constexpr std::size_t bits_of_word = 64;

/// Every code that an icon may end with, in ascending order.
std::shared_ptr<const std::vector<int>> all_codes(const Program& program, const Skills& skills) {
  std::vector<int> codes{0, 1, no_value, time_over, any_code};
  for (const auto& [name, skill] : skills)
    for (const pan::Completion& completion : skill.completions) codes.push_back(completion.code);
  for (const Operation& operation : program.operations) {
    for (const Icon& icon : operation.icons) {
      if (icon.code && icon.code->source.written()) codes.push_back(static_cast<int>(icon.code->number));
      if (icon.kind == IconKind::planned)
        for (const Way& each : icon.ways) codes.push_back(each.codes.front());
      const std::size_t most = std::max(icon.limits.size(), icon.ways.size());
      for (std::size_t i = 2; i <= most; ++i) codes.push_back(static_cast<int>(i));
    }
  }
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return std::make_shared<const std::vector<int>>(std::move(codes));
}

/// Hands the codes of one icon after the other on along its outputs, until none gets more.
class Spread {
 public:
  Spread(const Graph& graph, const Skills& skills) : graph_(graph), skills_(skills) {
    const Program& program = graph.program();
    const CodeSet none(all_codes(program, skills));
    for (const Operation& operation : program.operations) {
      codes_.at.emplace_back(operation.icons.size(), none);
      waiting_.emplace_back(operation.icons.size(), false);
    }
    codes_.exits.resize(program.operations.size(), none);
    for (std::size_t o = 0; o < program.operations.size(); ++o)
      for (std::size_t i = 0; i < program.operations[o].icons.size(); ++i)
        if (program.operations[o].icons[i].kind == IconKind::start) wait({o, i});
  }

  PossibleCodes all(const Stop& stop) {
    while (!next_.empty()) {
      if (stop && stop()) {
        codes_.complete = false;
        break;
      }
      const Place at = next_.front();
      next_.pop_front();
      waiting_[at.operation][at.icon] = false;
      spread(at);
    }
    return std::move(codes_);
  }

 private:
  void wait(Place at) {
    if (waiting_[at.operation][at.icon]) return;
    waiting_[at.operation][at.icon] = true;
    next_.push_back(at);
  }
  void spread(Place at) {
    const Icon& icon = graph_.icon(at);
    const CodeSet& here = codes_.at[at.operation][at.icon];
    switch (icon.kind) {
      case IconKind::start:
        send(at, icon.next, 0);
        break;
      case IconKind::merge:
      case IconKind::delay:
        if (const auto to = graph_.target(at.operation, icon.next);
            to && codes_.at[at.operation][*to].insert(here))
          wait({at.operation, *to});
        break;
      case IconKind::branch:
        for (const int code : here.list())
          if (const auto way = way_of(icon, code)) send(at, *way, code);
        break;
      case IconKind::exit:
        if (icon.code ? codes_.exits[at.operation].insert(
                            icon.code->source.written() ? static_cast<int>(icon.code->number) : any_code)
                      : codes_.exits[at.operation].insert(here))
          for (const Place& user : graph_.users(at.operation))
            if (!codes_.at[user.operation][user.icon].empty()) wait(user);
        break;
      case IconKind::restart:
        break;
      case IconKind::skill:
      case IconKind::wait:
      case IconKind::test:
      case IconKind::question:
      case IconKind::zero:
      case IconKind::planned:
      case IconKind::sub_operation:
        for (const Ending& ending : endings_of(graph_, at, skills_, codes_.exits))
          if (const auto way = route(graph_, at, ending.code, ending.normal())) send(at, *way, ending.code);
        break;
    }
  }
  void send(Place from, const Connection& connection, int code) {
    const auto to = graph_.target(from.operation, connection);
    if (!to) return;
    CodeSet& there = codes_.at[from.operation][*to];
    const bool first = there.empty();
    // What an icon ends with does not depend on the code with which the token came.
    if (there.insert(code) && (first || !has_completions(graph_.icon({from.operation, *to}).kind)))
      wait({from.operation, *to});
  }

  const Graph& graph_;
  const Skills& skills_;
  PossibleCodes codes_;
  std::vector<std::vector<bool>> waiting_;
  std::deque<Place> next_;
};

bool may_be_missing(const std::optional<Amount>& amount) {
  return amount && amount->source.kind == Source::Kind::output;
}

/// A count can be none, and no time limit.
bool may_be_out_of_range(const std::optional<Amount>& amount) {
  return amount &&
         (amount->source.kind == Source::Kind::output || amount->source.kind == Source::Kind::count);
}

/// Whether a sensor, a person, a figure of a skill, or a number within its range can be missing.
bool can_lack_a_value(const Icon& icon) {
  if (icon.kind == IconKind::question || icon.kind == IconKind::zero || icon.kind == IconKind::planned)
    return true;
  const auto reads = [](const Condition& each) {
    return !each.sensor.empty() || each.value.source.kind == Source::Kind::output ||
           may_be_missing(each.at_least) || may_be_missing(each.at_most);
  };
  if (std::any_of(icon.conditions.begin(), icon.conditions.end(), reads)) return true;
  for (const Amount& limit : icon.limits)
    if (limit.source.kind == Source::Kind::output) return true;
  if (may_be_missing(icon.repeat) || may_be_out_of_range(icon.time_limit) ||
      may_be_out_of_range(icon.timeout))
    return true;
  // How far a count goes is known when it runs; a skill refuses by itself what is beyond its range.
  return std::any_of(icon.parameters.begin(), icon.parameters.end(), [&](const Parameter& each) {
    return each.source.kind == Source::Kind::output ||
           (each.source.kind == Source::Kind::count && icon.kind == IconKind::sub_operation);
  });
}

}  // namespace

bool has_completions(IconKind kind) {
  return kind == IconKind::skill || kind == IconKind::sub_operation || kind == IconKind::wait ||
         kind == IconKind::test || kind == IconKind::question || kind == IconKind::zero ||
         kind == IconKind::planned;
}

bool has_next(IconKind kind) {
  return kind != IconKind::branch && kind != IconKind::question && kind != IconKind::exit &&
         kind != IconKind::restart;
}

bool names_code(const Icon& branch, int code) {
  return std::any_of(branch.ways.begin(), branch.ways.end(), [&](const Way& way) {
    return std::find(way.codes.begin(), way.codes.end(), code) != way.codes.end();
  });
}

std::optional<Connection> way_of(const Icon& branch, int code) {
  for (const Way& way : branch.ways)
    if (std::find(way.codes.begin(), way.codes.end(), code) != way.codes.end()) return way.to;
  if (branch.otherwise.connected()) return branch.otherwise;
  return std::nullopt;
}

std::optional<Connection> route(const Graph& graph, Place at, int code, bool normal) {
  const Icon& icon = graph.icon(at);
  if (icon.kind == IconKind::question) {
    if (normal && static_cast<std::size_t>(code) < icon.ways.size())
      return icon.ways[static_cast<std::size_t>(code)].to;
    return icon.error.connected() ? std::optional(icon.error) : std::nullopt;
  }
  if (const auto branch = graph.case_behind(at)) {
    const Icon& found = graph.icon({at.operation, *branch});
    if (names_code(found, code)) return icon.next;
    if (!normal && icon.error.connected()) return icon.error;
    if (found.otherwise.connected()) return icon.next;
    return icon.error.connected() ? icon.error : icon.next;  // the CASE says what it lacks
  }
  if (normal && icon.next.connected()) return icon.next;
  if (icon.error.connected()) return icon.error;
  return std::nullopt;
}

CodeSet::CodeSet(std::shared_ptr<const std::vector<int>> all)
    : all_(std::move(all)), bits_((all_->size() + bits_of_word - 1) / bits_of_word, 0) {}

bool CodeSet::contains(int code) const {
  const auto found = std::lower_bound(all_->begin(), all_->end(), code);
  if (found == all_->end() || *found != code) return false;
  const auto index = static_cast<std::size_t>(found - all_->begin());
  return (bits_[index / bits_of_word] >> (index % bits_of_word) & 1) != 0;
}

bool CodeSet::empty() const {
  return std::all_of(bits_.begin(), bits_.end(), [](std::uint64_t word) { return word == 0; });
}

std::vector<int> CodeSet::list() const {
  std::vector<int> result;
  for (std::size_t i = 0; i < all_->size(); ++i)
    if ((bits_[i / bits_of_word] >> (i % bits_of_word) & 1) != 0) result.push_back((*all_)[i]);
  return result;
}

bool CodeSet::insert(int code) {
  const auto index =
      static_cast<std::size_t>(std::lower_bound(all_->begin(), all_->end(), code) - all_->begin());
  std::uint64_t& word = bits_[index / bits_of_word];
  const std::uint64_t before = word;
  word |= std::uint64_t{1} << (index % bits_of_word);
  return word != before;
}

bool CodeSet::insert(const CodeSet& codes) {
  bool grown = false;
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    grown = grown || (codes.bits_[i] & ~bits_[i]) != 0;
    bits_[i] |= codes.bits_[i];
  }
  return grown;
}

std::vector<Ending> endings_of(const Graph& graph, Place at, const Skills& skills,
                               const std::vector<CodeSet>& exits) {
  const Icon& icon = graph.icon(at);
  std::vector<Ending> result;
  switch (icon.kind) {
    case IconKind::sub_operation:
      if (const auto sub = graph.sub_operation(at))
        for (const int code : exits[*sub].list())
          result.push_back({code, code == 0 ? EndingKind::normal : EndingKind::contingency});
      break;
    case IconKind::test: {
      const std::size_t most = icon.limits.empty() ? 1 : icon.limits.size();
      for (int code = 0; code <= static_cast<int>(most); ++code) result.push_back({code, EndingKind::normal});
      break;
    }
    case IconKind::question:
      for (int code = 0; code < static_cast<int>(icon.ways.size()); ++code)
        result.push_back({code, EndingKind::normal});
      if (icon.timeout) result.push_back({time_over, EndingKind::contingency});
      break;
    case IconKind::planned:
      for (const Way& each : icon.ways)
        result.push_back(
            {each.codes.front(), each.codes.front() == 0 ? EndingKind::normal : EndingKind::contingency});
      break;
    case IconKind::wait:
      result.push_back({0, EndingKind::normal});
      if (icon.timeout) result.push_back({waited_in_vain, EndingKind::contingency});
      break;
    case IconKind::skill: {
      const auto skill = skills.find(icon.skill);
      if (skill == skills.end()) {
        result.push_back({0, EndingKind::normal});
      } else {
        for (const pan::Completion& completion : skill->second.completions)
          result.push_back({completion.code, completion.kind});
      }
      if (icon.time_limit) result.push_back({time_over, EndingKind::contingency});
      break;
    }
    default:
      result.push_back({0, EndingKind::normal});
  }
  const auto has = [&](int code) {
    return std::any_of(result.begin(), result.end(), [&](const Ending& each) { return each.code == code; });
  };
  // Repeated no time at all.
  if (icon.repeat && !icon.repeat->source.written() && !has(0)) result.push_back({0, EndingKind::normal});
  if (can_lack_a_value(icon) && !has(no_value)) result.push_back({no_value, EndingKind::error});
  return result;
}

PossibleCodes possible_codes(const Graph& graph, const Skills& skills, const Stop& stop) {
  return Spread(graph, skills).all(stop);
}

}  // namespace pal::operations
