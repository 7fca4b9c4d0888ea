// What the modules of a skill can do, worked out from their graphs alone in the plainest way: every step of
// every thread a state. Shares nothing with pal/check/deadlock.
//
// Left out: devices that lose answers. A skill must not have two requests to a device open at once.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pal/pan/network.hpp"

namespace pal::test::talk {

struct Place {
  std::size_t module;
  std::size_t node;
  friend auto operator<=>(const Place&, const Place&) = default;
};
struct Thread {
  std::vector<Place> at;  // the last one is where it is; those before execute it
  int parent = -1;
  std::string
      name;  // with those of its parents; the same block of the same parent, begun again, has the same
  bool can_end = true;
  bool finishing = false;
  bool gone = false;
  std::map<std::size_t, bool> latched;
  friend auto operator<=>(const Thread&, const Thread&) = default;
};
/// A request that was sent, and whose answer was not taken yet.
struct Asked {
  std::string owner;  // name of the thread to which it belongs
  bool withdrawn = false;
  friend auto operator<=>(const Asked&, const Asked&) = default;
};
/// A request or answer channel.
struct Slot {
  bool full = false;
  std::vector<Asked> asked;  // of a request, the oldest first
  bool answers = false;      // of an answer: it is one to the oldest request
  friend auto operator<=>(const Slot&, const Slot&) = default;
};
struct State {
  std::vector<Thread> threads;
  std::vector<Slot> slots;
  std::vector<bool> values;
  bool ended = false;
  friend auto operator<=>(const State&, const State&) = default;
};
struct Step {
  State to;
  bool timely = false;
  bool talk = false;
  int thread = -1;
  bool completes = false;
  std::optional<std::size_t> put, take;
};

class Talk {
 public:
  explicit Talk(const pan::Network& network) : network_(network) {}

  const pan::Node& node(const Place& place) const {
    return network_.modules[place.module].body.nodes[place.node];
  }
  const pan::Node& node(const State& state, int thread) const {
    return node(state.threads[at(thread)].at.back());
  }
  static std::size_t at(int thread) { return static_cast<std::size_t>(thread); }
  bool is_device(const pan::Party& party) const;
  bool block_can_end(std::size_t module, std::size_t first) const;
  std::vector<int> blocks_of(const State& state, int parent) const;
  State first() const;
  std::vector<Step> steps(const State& state, int thread) const;
  /// Threads that are gone leave no trace, so that a loop over CONCURRENT comes back to where it was.
  static State packed(State state);

 private:
  static std::string name(std::size_t module, std::size_t node) {
    return std::to_string(module) + ":" + std::to_string(node);
  }
  std::optional<std::size_t> answer_to(std::size_t request) const;
  std::optional<std::size_t> request_for(std::size_t answer) const;
  void go_to(State state, int thread, std::size_t target, std::vector<State>& result) const;
  void settle(State state, int thread, std::vector<State>& result) const;
  void fork(State state, int parent, std::vector<State>& result) const;
  void block_gone(State state, int parent, std::vector<State>& result) const;
  void cancel(State state, int parent, std::vector<State>& result) const;
  bool may_be_working(const State& state, int thread) const;
  void stop(State state, int thread, std::vector<State>& result) const;
  bool available(const State& state, std::size_t channel) const;
  void withdraw(State& state, std::size_t request, const std::optional<std::string>& owner) const;
  std::optional<std::size_t> answered(const State& state, std::size_t answer) const;
  void take(State& state, std::size_t channel) const;
  void done(Step step, std::size_t next, std::vector<Step>& result) const;
  bool value(const State& state, int thread, std::size_t condition) const;
  bool holds(const State& state, int thread, const pan::Guard& guard) const;

  const pan::Network& network_;
};

}  // namespace pal::test::talk
