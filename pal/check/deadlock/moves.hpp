// What can happen next in a skill, without times (docs/reference/execution-model.md). Every wait that can
// give up may do so at any moment. A device sends its events whenever a thread waits for them, and answers
// every request at some time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pal/check/deadlock/automata.hpp"
#include "pal/check/deadlock/relevance.hpp"

namespace pal::check::deadlock {

/// A state of all threads, slots and conditions, as words; Moves knows which word is which. What no later
/// step reads is forgotten: conditions and latches that only earlier steps read are FALSE.
using State = std::u16string;

/// What one move does.
struct Action {
  enum class Kind {
    takes,
    sends,
    discards,
    gives_up,
    loses,
    sets,
    latches,
    finds,
    faults,
    completes,
    stops,
    works,
    spins
  };
  Kind kind = Kind::spins;
  std::size_t thread = 0;
  std::size_t step = 0;
  pan::ChannelId channel{};
  bool value = false;       // sets, latches
  std::size_t branch = 0;   // finds
  std::size_t outcome = 0;  // of several that are else alike: blocks that are cancelled stop or finish

  friend bool operator==(const Action&, const Action&) = default;
};

/// A message is put or taken, or a wait gives up.
bool is_talk(const Action& action);

struct Move {
  Action action;
  State state;
  bool ended = false;   // the skill has completed
  bool timely = false;  // only the right times bring this about: giving up, an answer that is lost
  /// One of several moves of a thread. Only one of them is real. The state before does not say which: its
  /// count is blurred, or a condition is unknown.
  bool guessed = false;
  bool cancels = false;   // blocks are stopped, or are to finish what they have begun
  std::size_t forks = 0;  // gone through at this instant
};

class Moves {
 public:
  static constexpr char16_t nowhere = 0xffff;  // of a thread that is not there

  /// Withdrawn requests that are yet to be answered are counted up to this number. Any greater number is one
  /// state, which is blurred.
  static constexpr int most_withdrawn = 6;

  /// `withdrawn`: the number up to which they are counted, from 0 to most_withdrawn.
  explicit Moves(const Automata& automata, int withdrawn = most_withdrawn);

  State first() const;
  /// The moves of one thread; none: it is blocked, or not there.
  void of(const State& state, std::size_t thread, std::vector<Move>& result) const;

  bool active(const State& state, std::size_t thread) const { return state[thread] != nowhere; }
  /// The step that an active thread is at.
  const Step& at(const State& state, std::size_t thread) const;
  /// A block that was cancelled finishes the statement it has begun.
  bool finishing(const State& state, std::size_t thread) const;
  bool full(const State& state, pan::ChannelId channel) const;
  int open(const State& state, pan::ChannelId request) const;
  /// The state stands for states with more withdrawn requests than are counted. Moves from it exist in all of
  /// them; of two guessed moves one is real, and the state may be one that no run reaches.
  bool blurred(const State& state) const;
  /// The same, for the requests that this channel answers.
  bool blurred(const State& state, pan::ChannelId answer) const;
  /// Requests of the channel that are open, all or those that belong to the thread.
  int open(const State& state, pan::ChannelId request, std::size_t thread) const;
  /// What is in the slot answers a request that belongs to the thread.
  bool answers(const State& state, pan::ChannelId answer, std::size_t thread) const;
  /// The threads to which open requests belong.
  Threads owners(const State& state, pan::ChannelId request) const;
  /// The state after all open requests of the channel were withdrawn.
  State without_request(const State& state, pan::ChannelId request) const;
  std::size_t words() const { return words_; }
  /// A count was too large for a state, so results may be incomplete.
  bool overflowed() const { return overflowed_; }

 private:
  static constexpr char16_t finishing_flag = 0x8000;
  /// Threads, steps and owners must fit into their words.
  static char16_t word(std::size_t value) { return static_cast<char16_t>(value); }

  static constexpr int most_asked = 12;
  static constexpr int no_thread = 0;

  struct Slot {
    bool full = false;
    bool answers = false;  // of an answer: what is in the slot answers the oldest request
    int asked = 0;         // of a request: how many have no answer yet that was taken
    /// The thread, from 1, to which each of them belongs, the oldest first; `no_thread`: the request is
    /// withdrawn.
    std::array<int, most_asked> by{};

    void push(std::size_t thread);
    void erase(int at);
    int withdrawn() const;
  };

  void lay_out();
  void find_requests();
  Slot slot(const State& state, pan::ChannelId channel) const;
  /// How many requests have no answer yet that was taken.
  int asked(const State& state, pan::ChannelId request) const {
    return static_cast<int>(state[slots_[request.index()]] >> 2);
  }
  void put_slot(State& state, pan::ChannelId channel, const Slot& slot) const;
  void ask(Slot& slot, std::size_t thread) const;
  void blur(Slot& slot) const;
  bool bit(const State& state, std::size_t base, std::size_t index) const;
  void set_bit(State& state, std::size_t base, std::size_t index, bool value) const;
  std::size_t latched(std::size_t thread) const;

  void forget(State& state) const;
  void steps_of(const State& state, std::size_t thread, std::vector<Move>& result) const;
  bool may_have_begun(const State& state, std::size_t thread) const;
  void take(State& state, pan::ChannelId channel) const;
  void withdraw(State& state, pan::ChannelId request, std::optional<std::size_t> thread) const;
  int answered_next(const State& state, pan::ChannelId answer) const;
  void hand_over(State& state, std::size_t block, std::size_t parent) const;
  void abandon(State& state, std::size_t thread) const;
  void arrive(Move move, std::size_t thread, std::size_t step, std::vector<Move>& result) const;
  void after_blocks(Move move, std::size_t parent, std::vector<Move>& result) const;
  void cancel(Move move, std::size_t parent, std::vector<Move>& result) const;
  void stop(Move move, std::size_t thread, std::vector<Move>& result) const;
  void go(Move move, std::size_t next, std::vector<Move>& result) const;
  bool can_take(const State& state, pan::ChannelId channel) const;
  bool reads(const State& state, std::size_t thread, pan::ConditionId condition) const;
  std::vector<std::size_t> branches(const State& state, std::size_t thread, std::size_t index) const;

  void wait(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const;
  void send(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const;
  void set(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const;
  void test(const State& state, std::size_t thread, const Step& step, std::vector<Move>& result) const;

  const Automata& automata_;
  int withdrawn_;
  StepSets to_be_read_;
  StepSets latches_to_be_read_;
  std::vector<std::size_t> slots_;                      // where each slot begins
  std::vector<std::vector<pan::ChannelId>> requests_;   // that may belong to each thread
  std::vector<std::vector<pan::ConditionId>> unknown_;  // that each step tests
  std::size_t forks_ = 0;                               // in all programs
  std::size_t values_ = 0;                              // … the conditions' values
  std::size_t latches_ = 0;  // … what each thread has latched: masks, then values
  std::size_t bit_words_ = 0;
  std::size_t words_ = 0;
  mutable bool overflowed_ = false;
};

/// The moves of every thread in one state, found when they are asked for.
class Enabled {
 public:
  Enabled(const Moves& moves, const State& state, std::size_t threads)
      : moves_(moves), state_(state), found_(threads), is_found_(threads, false) {}

  std::size_t size() const { return found_.size(); }
  const std::vector<Move>& operator[](std::size_t thread) const {
    if (!is_found_[thread]) {
      is_found_[thread] = true;
      moves_.of(state_, thread, found_[thread]);
    }
    return found_[thread];
  }
  Threads can_move() const {
    Threads result;
    for (std::size_t t = 0; t < size(); ++t) {
      if (!(*this)[t].empty()) result.set(t);
    }
    return result;
  }

 private:
  const Moves& moves_;
  const State& state_;
  mutable std::vector<std::vector<Move>> found_;
  mutable std::vector<bool> is_found_;
};

}  // namespace pal::check::deadlock
