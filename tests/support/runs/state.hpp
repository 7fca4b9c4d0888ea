// All that there is of a run at one instant. Times are in units, and those since something happened are
// capped.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pal::test::runs {

template <class T>
std::size_t ix(T i) {
  return static_cast<std::size_t>(i);
}

/// More than is followed.
struct TooMuch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Status : std::uint8_t { off, ready, running, waiting, sending, joining };

struct Thread {
  Status status = Status::off;
  std::vector<std::pair<int, int>> at;  // module and node; below: the Executes that led here
  bool begun = false;
  int left = 0;    // of the action that has begun
  int limit = -1;  // of the wait
  int claim = -1;  // which of the wait's channels
  bool withdrawn = false;
  bool gives_up = false;
  bool cancelled = false;
  std::uint32_t latched = 0;
  std::uint32_t latched_true = 0;
  int carries = -1;  // index into State::births
  int parent = -1;
  std::vector<int> blocks;
  bool can_end = true;
  int processor = 0;
  int priority = 0;
  int module = 0;
  int turn = 0;  // within one instant: which message has brought it to its queue
};

/// A request that was put, and whose answer was not taken yet.
struct Asked {
  int owner = -1;  // thread; -1: a device
  bool withdrawn = false;
};

struct Slot {
  bool full = false;
  int claimed = -1;
  int from = -1;  // processor
  int near = -1;  // still to fly; -1: no more
  int far = -1;
  int carries = -1;
  int later = -1;            // loss: how many of its device's occurrences came after it; -1: it is none
  bool answers = false;      // of an answer: it is one to the oldest request
  std::vector<Asked> asked;  // of a request, in the order of the puts
  int serving_carries = -1;  // of a request: what the answer will carry
  int due_carries = -1;      // of a request that has been served: what the answer carries, at this instant
};

struct Device {
  bool open = false;
  int next = -1;
  int late = -1;
  int service = -1;
  std::uint32_t serving = 0;
};

struct State {
  std::vector<Thread> threads;
  std::vector<int> running;
  std::vector<std::vector<int>> queues;
  std::vector<Slot> slots;
  std::vector<Device> devices;
  std::uint32_t conditions = 0;
  std::vector<int> known;                   // by condition: what a read gives; index into births
  std::map<std::pair<int, int>, int> kept;  // by module and message: index into births; -1: none
  std::vector<int> births;  // of what is measured: how long ago, the earliest first; -1: it does not count
  int reference = -1;       // of reactions and intervals: from which birth the next value counts
  std::vector<int> busy;  // by processor: for how long it has been; -1: it is idle; below: since this instant
  std::vector<bool> lost;  // loss: the last occurrences, the latest last
  bool counting = false;   // loss: there was an occurrence; reaction to samples: a sample
  bool in_phase = false;
  bool ended = false;
  bool failed = false;
};

/// States with the same key go on in the same ways.
std::string key(const State& state);

}  // namespace pal::test::runs
