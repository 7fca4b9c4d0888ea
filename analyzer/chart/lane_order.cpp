#include "analyzer/chart/lane_order.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace pal::analyzer::chart {

namespace {

// Trying every order is quick up to here (8! = 40320); larger charts keep the order of the trace.
constexpr std::size_t most_permuted = 8;

using Order = std::vector<std::size_t>;

std::vector<Order> groups_of(const Timeline& timeline) {
  std::vector<Order> groups;
  for (std::size_t lane = 0; lane < timeline.lanes.size(); ++lane) {
    const Lane& it = timeline.lanes[lane];
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Order& group) {
      const Lane& first = timeline.lanes[group.front()];
      return !it.device && !first.device && first.processor == it.processor;
    });
    if (same == groups.end()) {
      groups.push_back({lane});
    } else {
      same->push_back(lane);
    }
  }
  return groups;
}

class Orderer {
 public:
  explicit Orderer(const Timeline& timeline) : groups_(groups_of(timeline)), place_(timeline.lanes.size()) {
    for (const Arrow& arrow : timeline.arrows) {
      add(static_cast<std::int64_t>(arrow.from_lane), arrow.to_lane);
    }
    add_conditions(timeline);
  }

  Order best() {
    Order sequence(groups_.size());
    std::iota(sequence.begin(), sequence.end(), std::size_t{0});
    if (groups_.size() <= most_permuted) improve(sequence, [&](const Order& it) { return length(it); });
    for (Order& group : groups_) {
      if (group.size() <= most_permuted) improve(group, [&](const Order&) { return length(sequence); });
    }
    return flat(sequence);
  }

 private:
  void add(std::int64_t a, std::int64_t b) {
    if (a < 0 || b < 0 || a == b) return;
    talk_.insert({static_cast<std::size_t>(std::min(a, b)), static_cast<std::size_t>(std::max(a, b))});
  }

  // Conditions are talk too: from the thread that sets one to the one that reads it.
  void add_conditions(const Timeline& timeline) {
    for (const Waveform& wave : timeline.waveforms) {
      std::set<std::int64_t> readers;
      for (const Sample& read : wave.reads) readers.insert(read.lane);
      std::set<std::int64_t> writers;
      for (const Sample& set : wave.sets) writers.insert(set.lane);
      for (const std::int64_t writer : writers) {
        for (const std::int64_t reader : readers) add(writer, reader);
      }
    }
  }

  // Leaves in `order` the first of its permutations for which `cost` is least. `order` begins ascending.
  template <class Cost>
  void improve(Order& order, Cost cost) {
    Order best = order;
    std::size_t least = cost(order);
    while (std::next_permutation(order.begin(), order.end())) {
      const std::size_t now = cost(order);
      if (now < least) {
        least = now;
        best = order;
      }
    }
    order = best;
  }

  Order flat(const Order& sequence) const {
    Order lanes;
    for (const std::size_t group : sequence)
      lanes.insert(lanes.end(), groups_[group].begin(), groups_[group].end());
    return lanes;
  }

  std::size_t length(const Order& sequence) {
    std::size_t place = 0;
    for (const std::size_t group : sequence) {
      for (const std::size_t lane : groups_[group]) place_[lane] = place++;
    }
    std::size_t sum = 0;
    for (const auto& [a, b] : talk_)
      sum += place_[a] < place_[b] ? place_[b] - place_[a] : place_[a] - place_[b];
    return sum;
  }

  std::vector<Order> groups_;
  std::vector<std::size_t> place_;
  std::set<std::pair<std::size_t, std::size_t>> talk_;
};

}  // namespace

std::vector<std::size_t> lane_order(const Timeline& timeline) {
  return Orderer(timeline).best();
}

}  // namespace pal::analyzer::chart
