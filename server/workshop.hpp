// Work for clients that needs neither the cell nor the desk: checks, drawings, the disk. It is done beside
// them, so that no text that a client sends keeps a stop waiting.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "server/command.hpp"

namespace pal::server {

class Workshop {
 public:
  /// Asked again and again; true: the work is not wanted any more.
  using Stop = std::function<bool()>;
  using Job = std::function<void(const Stop& stop)>;
  /// Set it, and the job is not wanted any more.
  using Ticket = std::shared_ptr<std::atomic<bool>>;
  /// What may wait for one client.
  static constexpr std::size_t most_waiting = 16;

  /// Does each job in a thread of its own, or, without one, at once in the calling thread.
  explicit Workshop(bool thread);
  /// Nothing that waits is wanted any more; all is done that way before it returns.
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// Every job that is accepted is called once, in the order in which they came, also when it is not wanted
  /// any more. Null: too many wait for this client.
  Ticket submit(ClientId client, Job job);

 private:
  struct Work {
    ClientId client = 0;
    Job job;
    Ticket unwanted;
  };
  void work();
  void end();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Work> waiting_;
  std::map<ClientId, std::size_t> count_;  // waiting or being done
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace pal::server
