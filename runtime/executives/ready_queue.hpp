// The threads that wait for one processor, in the order in which they get it.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "pal/runtime/thread.hpp"

namespace pal::runtime {

/// A binary heap: the more urgent thread is first, and among equals the one with the least
/// ThreadControl::queue_key. Each thread knows its place, so any of them can be taken out.
class ReadyQueue {
 public:
  /// Makes room for `threads`.
  explicit ReadyQueue(std::size_t threads) { heap_.reserve(threads); }

  bool empty() const { return heap_.empty(); }
  /// Contract: not empty.
  Thread& first() const { return *heap_.front(); }

  /// Contract: it is not there.
  void add(Thread& thread) {
    heap_.push_back(&thread);
    rise(heap_.size() - 1, thread);
  }
  /// Contract: not empty.
  Thread& take_first() {
    Thread& thread = first();
    remove_at(0);
    return thread;
  }
  /// If it is there.
  void remove(Thread& thread) {
    const std::size_t place = thread.control.ready_place;
    if (place < heap_.size() && heap_[place] == &thread) remove_at(place);
  }

 private:
  static bool before(const Thread& a, const Thread& b) {
    const ThreadControl &x = a.control, &y = b.control;
    return x.spec->priority != y.spec->priority ? x.spec->priority > y.spec->priority
                                                : x.queue_key < y.queue_key;
  }
  void put(std::size_t place, Thread& thread) {
    heap_[place] = &thread;
    thread.control.ready_place = place;
  }
  void rise(std::size_t place, Thread& thread) {
    while (place > 0 && before(thread, *heap_[(place - 1) / 2])) {
      put(place, *heap_[(place - 1) / 2]);
      place = (place - 1) / 2;
    }
    put(place, thread);
  }
  void sink(std::size_t place, Thread& thread) {
    for (std::size_t child = 2 * place + 1; child < heap_.size(); child = 2 * place + 1) {
      if (child + 1 < heap_.size() && before(*heap_[child + 1], *heap_[child])) ++child;
      if (!before(*heap_[child], thread)) break;
      put(std::exchange(place, child), *heap_[child]);
    }
    put(place, thread);
  }
  void remove_at(std::size_t place) {
    Thread& last = *heap_.back();
    heap_.pop_back();
    if (place == heap_.size()) return;
    if (place > 0 && before(last, *heap_[(place - 1) / 2])) {
      rise(place, last);
    } else {
      sink(place, last);
    }
  }

  std::vector<Thread*> heap_;
};

}  // namespace pal::runtime
