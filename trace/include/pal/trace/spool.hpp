// Records of a long run, on the disk as they come, or in memory where the writer must not wait for a disk.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <iosfwd>
#include <memory>
#include <type_traits>
#include <vector>

#include "pal/trace/trace.hpp"

namespace pal::trace {

/// Where a spool keeps its bytes. What is appended in memory waits for no disk.
enum class SpoolPlace { disk, memory };

/// Bytes in a file that has no name, in the system's temporary folder or in memory: it is gone with the
/// process.
class SpoolFile {
 public:
  /// Throws std::runtime_error if there can be no such file.
  explicit SpoolFile(SpoolPlace place = SpoolPlace::disk);
  /// False from the first failure on: the disk is full, or the memory. Allocates nothing.
  bool append(const void* bytes, std::size_t count) noexcept;
  bool failed() const noexcept { return failed_; }
  /// How many bytes of those from `offset` on were read into `room`.
  std::size_t read(std::size_t offset, void* room, std::size_t count) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::vector<char> room_;  // of the file, which it outlives
  std::unique_ptr<std::FILE, Close> file_;
  bool failed_ = false;
};

/// A list that grows on the disk and is read from its beginning.
template <class Record>
class Spool {
  static_assert(std::is_trivially_copyable_v<Record>);

 public:
  explicit Spool(SpoolPlace place = SpoolPlace::disk) : file_(place) {}
  void append(const Record* records, std::size_t count) noexcept {
    if (file_.append(records, count * sizeof(Record))) size_ += count;
  }
  void append(const Record& record) noexcept { append(&record, 1); }
  /// Those that were kept.
  std::size_t size() const noexcept { return size_; }
  /// Some were lost, because the disk was full.
  bool failed() const noexcept { return file_.failed(); }
  /// Calls `see` with each record from number `from` on, in order.
  template <class See>
  void for_each(See see, std::size_t from = 0) const {
    constexpr std::size_t at_a_time = 2048;
    std::vector<Record> room(std::min(at_a_time, size_ - std::min(from, size_)));
    while (from < size_) {
      const std::size_t wanted = std::min(room.size(), size_ - from);
      const std::size_t got =
          file_.read(from * sizeof(Record), room.data(), wanted * sizeof(Record)) / sizeof(Record);
      if (got == 0) return;
      for (std::size_t i = 0; i < got; ++i) see(room[i]);
      from += got;
    }
  }

 private:
  SpoolFile file_;
  std::size_t size_ = 0;
};

using EventSpool = Spool<Event>;

/// Gives all events of a run to a function, in order; as often as it is called.
using EventSource = std::function<void(const std::function<void(const Event&)>&)>;

/// The events of the trace itself. It outlives the source.
EventSource events_of(const Trace& trace);
/// Those of a spool, which outlives the source.
EventSource events_of(const EventSpool& spool);

/// As write_json() of a trace, of a run whose events come from `events`; of `tables` only the tables count.
void write_json(const Trace& tables, const EventSource& events, std::ostream& out);

}  // namespace pal::trace
