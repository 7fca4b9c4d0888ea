// The channels of a run: putting, taking, waiting, giving up (WITHIN), withdrawing
// (docs/reference/execution-model.md, Messages).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pal/runtime/executive.hpp"
#include "pal/runtime/thread.hpp"
#include "runtime/kernel/flow.hpp"
#include "runtime/kernel/journal.hpp"

namespace pal::runtime {

class Devices;
class Promises;

/// A request on its way to its answer.
struct Asked {
  const Thread* owner = nullptr;  // the thread to which it belongs; nullptr: a device
  std::int64_t serial = 0;
  bool withdrawn = false;  // its answer is discarded
  bool late = false;       // the device has not kept its time
  Time put{};              // when it was put
};

/// A slot and what is known about the messages that went through it.
struct Slot {
  const ChannelSpec* spec = nullptr;
  int device = -1;  // index of the device at its other end
  std::size_t port = 0;

  bool full = false;
  bool handed = false;  // to a device that has not taken it yet
  std::vector<double> fields;
  std::int64_t serial = 0;
  int sender_processor = -1;        // -1: a device
  Time available_within{};          // to threads of the sender's processor
  Time available_between{};         // to all others
  const Thread* claimed = nullptr;  // whose receive has begun
  std::array<Ticket, 2> arrivals;   // the events at which the message becomes available, or is handed over
  std::vector<Thread*> waiting;     // for a message of the slot, the longest first
  std::vector<Thread*> sending;     // for the slot to become free, the longest first

  // Of a request: those whose answer was not taken yet, in the order in which they were put.
  std::vector<Asked> asked;
  int gone = 0;  // how many, since the last answer, were left unanswered: it may come all the same
  // Of an answer.
  int request_of = -1;   // the slot of its request
  bool answers = false;  // the message in the slot answers the oldest request
};

class Mail {
 public:
  /// All outlive the mail. The devices may be made after it.
  Mail(Executive& executive, Journal& journal, Flow& flow, Devices& devices, Promises& promises,
       const Wiring& wiring);

  // Statements of threads.
  void reach(WaitOperation& wait);
  /// False: the thread is cancelled and its statement has no effect; the thread must be stopped.
  bool finish(WaitOperation& wait);
  bool send(SendOperation& send);

  // Events.
  void message_available(int channel);
  void request_arrives(int channel);
  void wait_expired(Thread& thread);

  /// A block is stopped: it waits for nothing, the message that it has begun to receive is free again, and
  /// its open requests are withdrawn.
  void abandon(Thread& thread);
  /// The open requests of a block that has ended belong to its parent.
  void hand_over(const Thread& block, const Thread& parent);

  // Devices.
  void connect(int channel, int device, std::size_t port);
  /// `request`: the number of the request that it answers; 0: the oldest. False: overrun.
  bool deliver(int channel, std::span<const double> fields, std::uint64_t request = 0);
  /// The oldest request that awaits its answer in the channel will have none.
  void left_unanswered(int channel);
  /// The time of the device's oldest request is over, and there is no answer.
  void late(int device);
  /// The device begins to serve the oldest request that waits for it.
  void device_takes_request(int device);

 private:
  Slot& at(int channel) { return slots_[static_cast<std::size_t>(channel)]; }
  int index(const Slot& slot) const { return static_cast<int>(&slot - slots_.data()); }
  bool available(const Slot& slot, const Thread& thread) const;
  void look(WaitOperation& wait);
  void claim(WaitOperation& wait, int target);
  void give_up(WaitOperation& wait);
  void set_out(Slot& slot, int channel, const Thread& sender);
  void stop_waiting(Thread& thread);
  void stop_sending(Slot& slot, Thread& thread);
  void release(Slot& slot, const Thread& thread);
  void put_done(SendOperation& send);
  void discard(SendOperation& send);
  void fill(Slot& slot, std::span<const double> fields);
  void empty(Slot& slot);
  void drop(Slot& slot);
  void taken_by_device(Slot& slot);
  void ask(Slot& request, const Thread* owner);
  bool in_slot(const Slot& request, std::size_t at) const;
  /// The request that the next message of the slot answers; null: none.
  Asked* answered_next(const Slot& answer) {
    return answer.request_of < 0 ? nullptr : next_of_its_requests(answer);
  }
  Asked* next_of_its_requests(const Slot& answer);
  bool discards(const Slot& answer) {
    const Asked* next = answered_next(answer);
    return next != nullptr && next->withdrawn;
  }
  void answered_in_vain(const Slot& answer);
  /// Makes the request that the device answers the next one. False: there is none.
  bool find_request(const Slot& answer, std::uint64_t serial);
  /// The device has no answer to the next request of the slot.
  void never_answered(const Slot& answer);
  bool may_fail(int device) const;
  Time least_answer(int device) const;
  void watch_device(const Slot& slot, int channel);
  void withdraw(Slot& request, const Thread* owner);

  /// What is known about a device.
  struct Party {
    bool sends_events = false;  // without a request: from when a thread first waits for it
    std::vector<int> inbox;     // the channels that lead to it
  };

  Executive& executive_;
  Journal& journal_;
  Flow& flow_;
  Devices& devices_;
  Promises& promises_;
  const Wiring& wiring_;
  bool at_once_ = false;  // no message is ever on its way
  std::vector<Slot> slots_;
  std::vector<int> requests_;  // the channels of requests that have answers
  std::vector<Party> parties_;
  std::int64_t serials_ = 0;
};

}  // namespace pal::runtime
