#include "runtime/watch/event_routes.hpp"

#include <algorithm>

#include "pal/trace/kind.hpp"

namespace pal::runtime {

EventRoutes::EventRoutes(const trace::Trace& tables) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < number_of_kinds; ++k) {
    const auto kind = static_cast<trace::Kind>(k);
    Group& group = groups_[k];
    group.first = next;
    std::size_t rows = tables.actors.size();
    const trace::SubjectTable table = trace::subject_table(kind);
    if (kind == trace::Kind::done) {
      group.by = By::statement;
      rows = tables.statements.size();
    } else if (kind != trace::Kind::block && table != trace::SubjectTable::none) {
      group.by = By::subject;
      rows = table == trace::SubjectTable::channels ? tables.channels.size() : tables.conditions.size();
    }
    group.count = rows + 1;
    next += group.count;
  }
  wanted_.resize(next);
  routes_.resize(next);
}

void EventRoutes::add(trace::Kind kind, std::size_t meter) {
  const Group& group = groups_[static_cast<std::size_t>(kind)];
  for (std::size_t row = 0; row < group.count; ++row) add(kind, static_cast<std::int32_t>(row) - 1, meter);
}

void EventRoutes::add(trace::Kind kind, std::int32_t about, std::size_t meter) {
  const Group& group = groups_[static_cast<std::size_t>(kind)];
  std::vector<std::uint32_t>& list = wanted_[group.first + static_cast<std::size_t>(about + 1)];
  const auto number = static_cast<std::uint32_t>(meter);
  if (std::find(list.begin(), list.end(), number) == list.end()) list.push_back(number);
  concerned_ |= bit(kind);
}

void EventRoutes::close() {
  for (std::size_t r = 0; r < wanted_.size(); ++r) {
    std::sort(wanted_[r].begin(), wanted_[r].end());
    routes_[r] = {static_cast<std::uint32_t>(meters_.size()), static_cast<std::uint32_t>(wanted_[r].size())};
    meters_.insert(meters_.end(), wanted_[r].begin(), wanted_[r].end());
  }
  wanted_.clear();
  wanted_.shrink_to_fit();
  want_everything(everything_);
}

const EventRoutes& EventRoutes::none() {
  static const EventRoutes routes;
  return routes;
}

}  // namespace pal::runtime
