// Of the classes that a batch led to, those that are new: each is compared with the known ones of its place.
#include <algorithm>
#include <utility>

#include "analyzer/zones/cost.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {
namespace {

/// So many classes of a place are kept apart before new ones are widened.
constexpr std::size_t most_apart = 6;

/// Bounds that differ by more count as if they differed by this: some are unbounded.
constexpr std::int64_t longest_apart = std::int64_t{1} << 40U;

/// Arrivals have numbers below those of classes, and below -1, which is none.
int number_of_arrival(std::size_t index) {
  return -2 - static_cast<int>(index);
}
std::size_t arrival_of(int number) {
  return static_cast<std::size_t>(-2 - number);
}

bool around(const ZoneClass& outer, const ZoneClass& inner, ZoneGraph::Merging merging) {
  const bool equal = merging != ZoneGraph::Merging::equal || inner.zone.includes(outer.zone);
  const bool sure = !outer.relaxed || inner.relaxed || merging == ZoneGraph::Merging::hull;
  return sure && equal && outer.zone.includes(inner.zone);
}

/// Whether a value that still grows is known to be beyond the cap.
bool grows_beyond(const State& state, const Watch& watch) {
  if (!watch.grows()) return false;
  if (watch.kind != Watch::Kind::response) return state.reference == tag::over;
  return std::find(state.pending.begin(), state.pending.end(), Pending::over) != state.pending.end();
}

}  // namespace

void ZoneGraph::merge(std::size_t expanded, const Limits& limits) {
  arrivals_.clear();
  landings_.clear();
  for (std::size_t e = 0; e < expanded; ++e) {
    Expansion& expansion = expansions_[e];
    findings_.add(expansion.findings, machine_.watch().least);
    for (std::size_t a = 0; a < expansion.used; ++a) {
      Arrival& arrival = expansion.arrivals[a];
      const std::size_t index = arrivals_.size();
      arrivals_.push_back(&arrival);
      arrival.made.state = place_of(arrival);
      int& landing = landing_of_[static_cast<std::size_t>(arrival.made.state)];
      if (landing < 0) {
        landing = static_cast<int>(landings_.size());
        landings_.push_back({arrival.made.state, index, index, 1});
        continue;
      }
      Landing& chain = landings_[static_cast<std::size_t>(landing)];
      arrivals_[chain.last]->next = index;
      chain.last = index;
      ++chain.count;
    }
  }
  // The most work first, so that no worker waits for one that began it last.
  const auto work = [this](const Landing& landing) {
    return landing.count * (1 + known_[static_cast<std::size_t>(landing.place)].ids().size());
  };
  std::sort(landings_.begin(), landings_.end(),
            [&](const Landing& a, const Landing& b) { return work(a) > work(b); });
  in_parts(limits, landings_.size(), 1, [this](std::size_t i) { compare(landings_[i]); });
  enter();
  for (const Landing& landing : landings_) {
    const auto place = static_cast<std::size_t>(landing.place);
    landing_of_[place] = -1;
    std::vector<int>& ids = known_[place].ids();
    // New ones stand at the end.
    for (std::size_t k = ids.size(); k-- > 0 && ids[k] < -1;) ids[k] = arrivals_[arrival_of(ids[k])]->number;
  }
}

const ZoneClass& ZoneGraph::zone_class(int id) const {
  return id < -1 ? arrivals_[arrival_of(id)]->made : classes_[static_cast<std::size_t>(id)];
}

/// Makes the class as large as is needed to hold one of those known as well: that to which it is nearest. Of
/// two closed zones the greater bounds are closed.
void ZoneGraph::widen(ZoneClass& made, const KnownZones& known) const {
  const Dbm* nearest = nullptr;
  std::int64_t least = INT64_MAX;
  const std::size_t size = made.zone.size();
  for (const int id : known.ids()) {
    const Dbm& other = zone_class(id).zone;
    std::int64_t added = 0;
    for (std::size_t i = 0; i < size && added < least; ++i) {
      for (std::size_t j = 0; j < size; ++j)
        added += std::min(std::abs(other.at(i, j) - made.zone.at(i, j)), longest_apart);
    }
    if (added >= least) continue;
    least = added;
    nearest = &other;
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j)
      made.zone.at(i, j) = std::max(made.zone.at(i, j), nearest->at(i, j));
  }
  made.relaxed = true;
}

void ZoneGraph::compare(const Landing& landing) {
  KnownZones& known = known_[static_cast<std::size_t>(landing.place)];
  Outline outline;
  std::size_t index = landing.first;
  for (std::size_t k = 0; k < landing.count; ++k, index = arrivals_[index]->next) {
    Arrival& arrival = *arrivals_[index];
    outline.of(arrival.made.zone);
    arrival.held_by =
        known.first_around(outline, [&](int id) { return around(zone_class(id), arrival.made, merging_); });
    if (arrival.held_by != -1) continue;
    if (merging_ == Merging::hull && known.ids().size() >= most_apart) {
      widen(arrival.made, known);
      outline.of(arrival.made.zone);
    }
    known.erase_within(outline, [&](int id) {
      if (!around(arrival.made, zone_class(id), merging_)) return false;
      arrival.replaces.push_back(id);
      return true;
    });
    known.add(number_of_arrival(index), outline);
  }
}

void ZoneGraph::enter() {
  const auto number_of = [&](int id) { return id < -1 ? arrivals_[arrival_of(id)]->number : id; };
  std::vector<Arrival*> entering;
  for (Arrival* arrival : arrivals_) {
    const bool enters = arrival->held_by == -1;
    arrival->number =
        enters ? static_cast<int>(classes_.size() + entering.size()) : number_of(arrival->held_by);
    if (enters) entering.push_back(arrival);
    if (arrival->made.parent < 0) continue;
    const int parent = arrival->made.parent;
    const int place = classes_[static_cast<std::size_t>(parent)].state;
    const auto beyond = [this](int at) {
      return grows_beyond(places_[static_cast<std::size_t>(at)].state, machine_.watch());
    };
    if (beyond(place) && beyond(arrival->made.state)) {
      growing_.emplace_back(parent, arrival->number);
      if (!arrival->move->outcome.over_gone) growing_on_.push_back(growing_.back());
    }
    if (!keep_edges_) continue;
    edges_.push_back({parent, arrival->number, arrival->move->timer, arrival->made.move});
  }
  for (Arrival* arrival : entering) {
    memory_ += memory_of(arrival->made.zone);
    classes_.push_back(std::move(arrival->made));
    open_.push_back(arrival->number);
    for (int id : arrival->replaces) {
      ZoneClass& replaced = classes_[static_cast<std::size_t>(number_of(id))];
      replaced.replaced_by = arrival->number;
      // Only its ancestry is asked for again, so the next arrival may have its memory.
      arrival->made.zone = std::exchange(replaced.zone, Dbm(0));
    }
  }
}

}  // namespace pal::analyzer
