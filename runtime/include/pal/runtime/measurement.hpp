// Measures how long activities and devices take in runs, for `pal check --measured`.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "pal/runtime/observer.hpp"
#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

/// The least and the greatest of some times, and how many they are. Several threads may call add() at once.
class Extremes {
 public:
  void add(Time time);
  std::uint64_t count() const { return count_.load(std::memory_order_relaxed); }
  /// Of what was added; zero if nothing was.
  Time least() const { return count() == 0 ? Time::zero() : Time(least_.load(std::memory_order_relaxed)); }
  Time greatest() const { return Time(greatest_.load(std::memory_order_relaxed)); }

 private:
  std::atomic<Time::rep> least_{Time::max().count()};
  std::atomic<Time::rep> greatest_{0};
  std::atomic<std::uint64_t> count_{0};
};

/// Give it to runs of one skill, one after the other, as both of their observers.
///
/// Two things are measured, by two clocks. For hand-written code: how long it held a processor of this
/// computer, whatever time the skill runs in. That is its processor time; if it slept or waited, the time on
/// the wall. For devices: time of the run. A device's answer counts from when the device was
/// given the request, or from its last answer if that came later. Of answers at one instant the first counts.
/// A message without a request counts from the last such message.
class Measurement final : public MessageObserver, public WorkObserver {
 public:
  /// Of a skill with this wiring, which outlives the measurement.
  explicit Measurement(const Wiring& wiring);

  /// Another run begins: forgets what the last one left open.
  void begin_run();

  void passed(Time when, const Device& device, std::size_t port, std::span<const double> fields) override;
  void forgotten(const Device& device, std::size_t port) override;
  void worked(int statement, Time time) override;

  /// The measured times as an ENVIRONMENT of PAL; comments say how often, and what was not reached. It has no
  /// places, so it cannot be used for proofs by mistake.
  std::string environment() const;

 private:
  struct Port {
    enum class Kind { other, request, answer, event };
    Kind kind = Kind::other;
    std::string message;
    std::vector<Time> open;       // of an answer: when its requests were handed to the device
    std::size_t answered_by = 0;  // of a request: the port of its answer
    bool seen = false;            // of an event
    Time last{};                  // of an event
    Extremes apart{};             // of an event
  };
  struct KnownDevice {
    const Device* device = nullptr;
    std::string name;
    std::deque<Port> ports;
    Time last_answer{-1};
    Extremes answers{};
  };

  KnownDevice& known(const Device& device);
  std::string activities() const;
  std::string devices() const;

  const Wiring& wiring_;
  std::uint64_t runs_ = 0;
  std::deque<Extremes> statements_;
  std::deque<KnownDevice> devices_;
};

}  // namespace pal::runtime
