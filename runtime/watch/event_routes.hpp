// Which meters an event concerns: a table, made once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pal/trace/trace.hpp"

namespace pal::runtime {

/// By the kind of an event, and by what it is about: its statement, its channel or condition, or its actor.
class EventRoutes {
 public:
  explicit EventRoutes(const trace::Trace& tables);

  /// Before close(). Events of the kind concern `meter`: all of them, or those about row `about`.
  void add(trace::Kind kind, std::size_t meter);
  void add(trace::Kind kind, std::int32_t about, std::size_t meter);
  void close();

  /// The meters that the event concerns.
  std::span<const std::uint32_t> of(trace::Kind kind, std::int32_t actor, std::int32_t statement,
                                    std::int32_t subject) const {
    const Group& group = groups_[static_cast<std::size_t>(kind)];
    const std::int32_t abouts[] = {actor, statement, subject};
    const std::int32_t about = abouts[static_cast<std::size_t>(group.by)];
    const Route route = routes_[group.first + static_cast<std::size_t>(about + 1)];
    return {meters_.data() + route.begin, route.count};
  }
  /// The bits of the kinds of which some event concerns a meter, or is wanted.
  std::uint32_t kinds() const { return kinds_; }
  static constexpr std::uint32_t bit(trace::Kind kind) {
    return std::uint32_t(1) << static_cast<unsigned>(kind);
  }
  static constexpr std::uint32_t all_kinds = ~std::uint32_t(0);

  /// Every event is wanted, whether it concerns a meter or not.
  void want_everything(bool wanted) {
    everything_ = wanted;
    kinds_ = wanted ? all_kinds : concerned_;
  }
  bool wants_everything() const { return everything_; }

  /// Of events that concern nothing.
  static const EventRoutes& none();

 private:
  enum class By : std::uint8_t { actor, statement, subject };
  struct Group {
    By by = By::actor;
    std::size_t first = 0;  // in routes_: of what is about no row; the rows follow
    std::size_t count = 0;
  };
  struct Route {
    std::uint32_t begin = 0, count = 0;  // in meters_
  };

  EventRoutes() = default;

  static constexpr std::size_t number_of_kinds = static_cast<std::size_t>(trace::Kind::broken) + 1;
  std::array<Group, number_of_kinds> groups_;
  std::vector<std::vector<std::uint32_t>> wanted_;  // by route, until close()
  std::vector<Route> routes_;
  std::vector<std::uint32_t> meters_;
  bool everything_ = false;
  std::uint32_t concerned_ = 0;  // the kinds of which some event concerns a meter
  std::uint32_t kinds_ = 0;
};

}  // namespace pal::runtime
