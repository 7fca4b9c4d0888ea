// The state of a running skill, without times.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "analyzer/machine/loss_rows.hpp"
#include "analyzer/problem/ids.hpp"
#include "pal/support/table.hpp"

namespace pal::analyzer {

/// What a thread, message or condition carries of the thing that is being measured. It is the number of an
/// observer or of an event (response), or one of these.
namespace tag {
constexpr std::uint8_t none = 255;
constexpr std::uint8_t over = 253;  // older than the cap
/// Older than the cap and later than the reference, which is `over`: a statement that reflects it ends a
/// reaction. Everything else that is `over` was so before the reference, or is the reference.
constexpr std::uint8_t over_later = 254;
constexpr std::uint8_t most = 200;  // instants that a state may carry

/// Of instants whose observers are numbered in the order of their birth: whether `a` is later than `b`.
constexpr bool newer(std::uint8_t a, std::uint8_t b) {
  const auto rank = [](std::uint8_t carries) {
    if (carries == none) return -3;
    if (carries == over) return -2;
    return carries == over_later ? -1 : static_cast<int>(carries);
  };
  return rank(a) > rank(b);
}
}  // namespace tag

/// How a state keeps a thread; a negative number says why there is none.
using ThreadNumber = std::int16_t;
constexpr ThreadNumber number_of(ThreadId thread) {
  return static_cast<ThreadNumber>(thread.value);
}

enum class Status : std::uint8_t { off, ready, running, waiting, sending, joining };

struct ThreadState {
  std::int16_t step = -1;
  Status status = Status::off;
  std::int8_t choice = no_choice;  // a wait that is over: which of its channels; or one of these
  bool begun = false;              // the statement has had the processor
  bool cancelled = false;
  std::uint8_t carries = tag::none;
  std::uint64_t latched = 0;         // conditions that an RPC latched, by bit
  std::uint64_t latched_values = 0;  // TRUE ones of them

  StepId at() const { return StepId::of(step); }
  void go_to(StepId next) { step = static_cast<std::int16_t>(next.value); }

  static constexpr std::int8_t no_choice = -1;
  static constexpr std::int8_t gives_up = -2;
  static constexpr std::int8_t withdrawn = -3;  // what it was receiving is gone
  static constexpr std::int8_t for_ever = -4;   // only in slices: nothing ends its wait or send

  friend bool operator==(const ThreadState&, const ThreadState&) = default;
};

/// The requests of a channel whose answers have not been taken yet, in the order in which they were put.
/// Those before the last one are out of their slot; only the first can be answered already.
struct Asked {
  static constexpr std::uint8_t most = 15;
  static constexpr ThreadNumber device = -1;     // of a device
  static constexpr ThreadNumber withdrawn = -2;  // open no more: its answer is discarded

  std::uint8_t count = 0;
  std::array<ThreadNumber, most> by{};  // the thread to which it belongs, or one of these; the rest is 0

  void push(ThreadNumber owner) { by[count++] = owner; }
  void erase(int at) {
    for (int i = at; i + 1 < count; ++i)
      by[static_cast<std::size_t>(i)] = by[static_cast<std::size_t>(i + 1)];
    by[--count] = 0;
  }

  friend bool operator==(const Asked&, const Asked&) = default;
};

struct SlotState {
  enum class Fill : std::uint8_t { empty, full, claimed };
  enum class Way : std::uint8_t { none, flying, there };
  Fill fill = Fill::empty;
  Way near = Way::none;  // to threads on the sender's processor
  Way far = Way::none;   // to those on others
  ProcessorId from{};    // the sender's processor; none: a device, or no sender
  std::uint8_t carries = tag::none;
  Asked asked;                               // requests
  bool answers = false;                      // answers: what is in the slot answers a request
  std::uint8_t serving_carries = tag::none;  // requests to a device: of the one that it is serving

  friend bool operator==(const SlotState&, const SlotState&) = default;
};

struct DeviceState {
  static constexpr std::size_t most_requests =
      128;  // more than fits_exploration() has channels; fits_simulation() asks
  using Served = std::bitset<most_requests>;  // by index into Device::requests

  bool open = false;
  bool late = false;  // event: due, but not there yet
  Served serving;

  friend bool operator==(const DeviceState&, const DeviceState&) = default;
};

/// An event without a response, in the order of birth. An event that is lost is carried by nothing any more.
/// One outside of the phase that is measured is only carried: it has no observer.
enum class Pending : std::uint8_t { observed, lost, over, outside };

/// Twice the longest row that is followed: a message may be withdrawn after others have come.
using Losses = std::bitset<2 * longest_followed_row>;

struct State {
  Table<ThreadId, ThreadState> threads;
  Table<ProcessorId, ThreadNumber> running;  // -1: idle
  std::vector<ThreadNumber> queue;           // ready threads, by processor, priority, place in the queue
  Table<ChannelId, SlotState> slots;
  Table<DeviceId, DeviceState> devices;
  std::uint64_t conditions = 0;
  std::uint64_t held = 0;  // free conditions that were read, and cannot change yet
  std::uint8_t condition_carries = tag::none;
  Table<ConditionId, std::uint8_t> known;  // samples
  Table<KeptId, std::uint8_t> kept;        // samples: by what modules keep of messages
  std::uint8_t reference = tag::none;      // the instant from which the next value is measured
  Losses lost;                             // losses: the last occurrences by bit, the latest first; 1: lost
  bool counting = false;  // losses: the device has served something; samples in a phase: also
  bool in_phase = false;  // what happens now is measured, if only a phase is
  std::uint8_t observers = 0;
  std::vector<Pending> pending;
  bool ended = false;
  bool failed = false;  // an event of the requirement can have no response any more

  friend bool operator==(const State&, const State&) = default;
};

struct StateHash {
  std::size_t operator()(const State& state) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15U;
    const auto mix = [&hash](std::uint64_t value) {
      hash ^= value + 0x9e3779b97f4a7c15U + (hash << 6U) + (hash >> 2U);
      hash *= 0xff51afd7ed558ccdU;
    };
    for (const ThreadState& t : state.threads) {
      mix(static_cast<std::uint64_t>(t.step + 1) << 32U | static_cast<std::uint64_t>(t.status) << 24U |
          static_cast<std::uint64_t>(t.choice + 8) << 16U | static_cast<std::uint64_t>(t.carries) << 8U |
          static_cast<std::uint64_t>(t.begun ? 2 : 0) | static_cast<std::uint64_t>(t.cancelled ? 1 : 0));
      mix(t.latched * 3 + t.latched_values);
    }
    for (const ThreadNumber r : state.running) mix(static_cast<std::uint64_t>(r + 1));
    for (const ThreadNumber q : state.queue) mix(static_cast<std::uint64_t>(q + 1000));
    for (const SlotState& s : state.slots) {
      mix(static_cast<std::uint64_t>(s.fill) << 56U | static_cast<std::uint64_t>(s.near) << 54U |
          static_cast<std::uint64_t>(s.far) << 52U | static_cast<std::uint64_t>(s.from.value + 1) << 40U |
          static_cast<std::uint64_t>(s.carries) << 32U | static_cast<std::uint64_t>(s.asked.count) << 16U |
          static_cast<std::uint64_t>(s.answers ? 1 : 0) << 8U | s.serving_carries);
      for (std::size_t i = 0; i < s.asked.count; ++i) mix(static_cast<std::uint64_t>(s.asked.by[i] + 2));
    }
    for (const DeviceState& d : state.devices) {
      mix(std::hash<DeviceState::Served>()(d.serving));
      mix(static_cast<std::uint64_t>(d.open ? 2 : 0) | static_cast<std::uint64_t>(d.late ? 1 : 0));
    }
    mix(state.conditions);
    mix(state.held + 900);
    mix(static_cast<std::uint64_t>(state.condition_carries) << 16U |
        static_cast<std::uint64_t>(state.observers) << 8U | static_cast<std::uint64_t>(state.ended ? 2 : 0) |
        static_cast<std::uint64_t>(state.failed ? 1 : 0));
    for (std::uint8_t k : state.known) mix(static_cast<std::uint64_t>(k) + 300);
    for (std::uint8_t k : state.kept) mix(static_cast<std::uint64_t>(k) + 600);
    mix(std::hash<Losses>()(state.lost));
    mix(static_cast<std::uint64_t>(state.reference) << 1U |
        static_cast<std::uint64_t>(state.counting ? 1 : 0));
    mix(state.in_phase ? 1 : 0);
    for (Pending p : state.pending) mix(static_cast<std::uint64_t>(p) + 77);
    return static_cast<std::size_t>(hash);
  }
};

}  // namespace pal::analyzer
