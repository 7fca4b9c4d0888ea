#include "analyzer/move.hpp"

#include <algorithm>

namespace pal::analyzer {
namespace {

void follow_timers(const Machine& machine, const Place& from, Move& move) {
  int processor = -1;
  if (move.timer >= 0) {
    const auto at = std::find(from.timers.begin(), from.timers.end(), move.timer);
    move.variable = static_cast<std::size_t>(at - from.timers.begin()) + 1;
    processor = machine.processor_of(from.state, move.timer);
  }
  if (processor >= 0) move.cost = machine.cost(from.state, move.timer);
  for (std::size_t k = 0; k < from.timers.size(); ++k) {
    if (from.timers[k] == move.timer) continue;
    Move::Kept kept;
    kept.timer = from.timers[k];
    kept.before = static_cast<int>(k);
    kept.frozen = kept.stays_frozen = from.frozen[k];
    // An action that ends has kept its processor from those that were preempted there.
    kept.pays = kept.frozen && processor >= 0 &&
                machine.problem().threads[static_cast<std::size_t>(kept.timer)].processor == processor;
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
        found->resumed = found->stays_frozen;
        found->frozen = found->stays_frozen = false;
        break;
    }
  }
  std::sort(move.timers.begin(), move.timers.end(),
            [](const Move::Kept& a, const Move::Kept& b) { return a.timer < b.timer; });
  for (const Move::Kept& kept : move.timers) {
    move.numbers.push_back(kept.timer);
    move.frozen.push_back(kept.frozen);
  }
}

}  // namespace

std::vector<Move> first_moves(const Machine& machine) {
  std::vector<Move> moves;
  AllChoices choices;
  do {
    Move made;
    made.outcome = machine.initial(choices, false);
    made.choices = choices.taken();
    follow_timers(machine, {}, made);
    moves.push_back(std::move(made));
  } while (choices.next());
  return moves;
}

std::vector<Move> moves_from(const Machine& machine, const Place& place) {
  std::vector<Move> moves;
  for (std::size_t k = 0; k < place.timers.size(); ++k) {
    if (place.frozen[k]) continue;
    AllChoices choices;
    do {
      Move made;
      if (!machine.fire(place.state, place.timers[k], choices, false, made.outcome)) break;
      made.timer = place.timers[k];
      made.choices = choices.taken();
      follow_timers(machine, place, made);
      moves.push_back(std::move(made));
    } while (choices.next());
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
  made.relaxed = from.relaxed;
  made.owed.clear();
  for (std::size_t k = 0; k < move.timers.size(); ++k) {
    const Move::Kept& kept = move.timers[k];
    if (kept.before < 0) {
      sources.push_back({move.variable, kept.range.best, kept.range.worst});
      continue;
    }
    const auto before = static_cast<std::size_t>(kept.before);
    sources.push_back({before + 1, 0, 0});
    if (!kept.resumed && !kept.frozen) continue;
    Range owed = from.owed.empty() ? Range{} : from.owed[before];
    if (kept.pays) {
      owed.best += move.cost.best;
      owed.worst += move.cost.worst;
    }
    if (kept.resumed) {
      made.relaxed = made.relaxed || owed.best != owed.worst;
      sources.back().low = owed.best;
      sources.back().high = owed.worst;
    }
    if (!kept.frozen) continue;
    made.owed.resize(move.timers.size());
    if (kept.stays_frozen) made.owed[k] = owed;
  }
  for (int origin : move.outcome.origin) {
    sources.push_back(
        {origin < 0 ? move.variable : 1 + timers_before + static_cast<std::size_t>(origin), 0, 0});
  }
  derive(fired, sources, made.zone);
  if (!made.relaxed) return true;
  for (std::size_t k = 0; k < move.timers.size(); ++k) {
    // What is left of an action is never negative, whatever the relaxation says.
    if (move.timers[k].resumed && !made.zone.constrain(0, k + 1, 0)) return false;
  }
  return true;
}

}  // namespace pal::analyzer
