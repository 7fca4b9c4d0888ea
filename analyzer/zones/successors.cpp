#include "analyzer/zones/successors.hpp"

#include <algorithm>

namespace pal::analyzer {
namespace {

/// So many orders of what happens at one instant are tried: n things that may come in any order have n!.
constexpr std::size_t most_beginnings = 50'000;
constexpr std::size_t most_outcomes = 10'000;  // of one timer

/// Orders that are tried between one question whether to stop and the next.
constexpr std::size_t moves_at_a_time = 256;

bool time_to_stop(std::size_t moves, StopToken& stop) {
  return moves % moves_at_a_time == 0 && stop.stop_requested();
}

/// What those can have left that got back a time that is not fixed.
void find_left(const Machine& machine, const State& state, Move& move) {
  const auto priority = [&](int timer) {
    return machine.problem().threads[machine.thread_of(timer)].priority;
  };
  for (std::size_t k = 0; k < move.timers.size(); ++k) {
    if (!move.timers[k].repaid) continue;
    // Those that interrupted it, and were interrupted themselves, have not given back theirs yet.
    Range left{0, machine.cost(state, move.timers[k].timer).worst};
    for (const Move::Kept& other : move.timers) {
      if (other.repaid && priority(other.timer) > priority(move.timers[k].timer))
        left.best -= machine.cost(state, other.timer).worst;
    }
    move.left.push_back({k + 1, left});
  }
}

void follow_timers(const Machine& machine, const Place& from, Move& move) {
  ProcessorId processor;
  if (move.timer >= 0) {
    const auto at = std::find(from.timers.begin(), from.timers.end(), move.timer);
    move.variable = static_cast<std::size_t>(at - from.timers.begin()) + 1;
    processor = machine.processor_of(from.state, move.timer);
  }
  if (processor.valid()) move.cost = machine.cost(from.state, move.timer);
  for (std::size_t k = 0; k < from.timers.size(); ++k) {
    if (from.timers[k] == move.timer) continue;
    Move::Kept kept;
    kept.timer = from.timers[k];
    kept.before = static_cast<int>(k);
    kept.frozen = from.frozen[k];
    // An action that ends gives back its time to those that were preempted on its processor: they have as
    // much left as before.
    kept.repaid = kept.frozen && processor.valid() &&
                  machine.problem().threads[machine.thread_of(kept.timer)].processor == processor;
    move.timers.push_back(kept);
  }
  for (const TimerChange& change : move.outcome.changes) {
    const auto found = std::find_if(move.timers.begin(), move.timers.end(),
                                    [&](const Move::Kept& kept) { return kept.timer == change.timer; });
    switch (change.kind) {
      case TimerChange::Kind::start: {
        Move::Kept kept;
        kept.timer = change.timer;
        kept.range = change.range;
        move.timers.push_back(kept);
        break;
      }
      case TimerChange::Kind::stop:
        move.timers.erase(found);
        break;
      case TimerChange::Kind::freeze:
        found->frozen = true;
        break;
      case TimerChange::Kind::resume:
        found->frozen = false;
        break;
    }
  }
  std::sort(move.timers.begin(), move.timers.end(),
            [](const Move::Kept& a, const Move::Kept& b) { return a.timer < b.timer; });
  if (move.cost.best != move.cost.worst) find_left(machine, from.state, move);
  for (const Move::Kept& kept : move.timers) {
    move.numbers.push_back(kept.timer);
    move.frozen.push_back(kept.frozen);
  }
}

}  // namespace

Move first_move(const Machine& machine, Choices& choices) {
  Move made;
  made.outcome = machine.initial(choices, false);
  follow_timers(machine, {}, made);
  return made;
}

std::optional<Move> move_from(const Machine& machine, const Place& place, std::size_t k, Choices& choices) {
  Move made;
  if (!machine.fire(place.state, place.timers[k], choices, false, made.outcome)) return std::nullopt;
  made.timer = place.timers[k];
  follow_timers(machine, place, made);
  return made;
}

std::vector<Move> first_moves(const Machine& machine, StopToken& stop) {
  std::vector<Move> moves;
  AllChoices choices;
  do {
    moves.push_back(first_move(machine, choices));
    moves.back().choices = choices.taken();
    if (moves.size() == most_beginnings) moves.back().outcome.too_many = true;
    if (time_to_stop(moves.size(), stop)) return moves;
  } while (moves.size() < most_beginnings && choices.next());
  return moves;
}

std::vector<Move> moves_from(const Machine& machine, const Place& place, StopToken& stop) {
  std::vector<Move> moves;
  for (std::size_t k = 0; k < place.timers.size(); ++k) {
    if (place.frozen[k]) continue;
    AllChoices choices;
    const std::size_t most = moves.size() + most_outcomes;
    do {
      auto made = move_from(machine, place, k, choices);
      if (!made) break;
      moves.push_back(std::move(*made));
      moves.back().choices = choices.taken();
      if (moves.size() == most) moves.back().outcome.too_many = true;
      if (time_to_stop(moves.size(), stop)) return moves;
    } while (moves.size() < most && choices.next());
  }
  return moves;
}

bool fire_first(Dbm& zone, std::size_t variable, const std::vector<bool>& frozen) {
  for (std::size_t k = 0; k < frozen.size(); ++k) {
    if (frozen[k] || k + 1 == variable) continue;
    if (!zone.constrain(variable, k + 1, 0)) return false;
  }
  return true;
}

void derive(const Dbm& from, const std::vector<Source>& sources, Dbm& made) {
  made.reset(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (std::size_t j = 0; j < sources.size(); ++j) {
      if (i == j) continue;
      const Nanoseconds between = from.at(sources[i].variable, sources[j].variable);
      made.at(i, j) = sources[i].high >= Range::unbounded
                          ? Dbm::unbounded
                          : Dbm::sum(between, sources[i].high - sources[j].low);
    }
  }
}

bool follow(const ZoneClass& from, const Dbm& fired, const Move& move, std::size_t timers_before,
            std::vector<Source>& sources, ZoneClass& made) {
  sources.clear();
  sources.push_back({move.variable, 0, 0});
  made.relaxed = from.relaxed || !move.left.empty();
  for (const Move::Kept& kept : move.timers) {
    if (kept.before < 0) {
      sources.push_back({move.variable, kept.range.best, kept.range.worst});
    } else {
      sources.push_back({static_cast<std::size_t>(kept.before) + 1, kept.repaid ? move.cost.best : 0,
                         kept.repaid ? move.cost.worst : 0});
    }
  }
  for (int origin : move.outcome.origin) {
    sources.push_back(
        {origin < 0 ? move.variable : 1 + timers_before + static_cast<std::size_t>(origin), 0, 0});
  }
  derive(fired, sources, made.zone);
  for (const Move::Left& left : move.left) {
    if (!made.zone.constrain(0, left.variable, -left.range.best) ||
        !made.zone.constrain(left.variable, 0, left.range.worst))
      return false;
  }
  return true;
}

}  // namespace pal::analyzer
