// The last events, for clients that connect late.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pal::server {

/// Events as the JSON protocol tells them, in memory that is taken at the beginning and never grows. The
/// oldest go first. One thread only.
class History {
 public:
  /// Keeps so many events, and no more than fit into so many bytes of text.
  explicit History(std::size_t most = 10'000, std::size_t bytes = std::size_t{2} << 20)
      : most_(most), room_(bytes) {}

  /// `told`: by event_text(). Numbers have no gaps. A text that is longer than all the room is not
  /// kept, nor is what came before it.
  void add(std::uint64_t number, std::string_view told);
  /// The first event from which on all are known; 0: none has come.
  std::uint64_t first() const { return next_ - count_; }
  std::size_t count() const { return count_; }
  /// Calls `use` for each event with a number above `number`.
  void since(std::uint64_t number,
             const std::function<void(std::uint64_t number, const std::string& told)>& use) const;

 private:
  /// Bytes that a text takes beside its own: its length stands before it.
  static constexpr std::size_t head = sizeof(std::uint32_t);

  std::size_t after(std::size_t place, std::size_t bytes) const { return (place + bytes) % room_.size(); }
  void put(std::size_t place, const char* bytes, std::size_t count);
  void take(std::size_t place, char* bytes, std::size_t count) const;
  std::uint32_t length_at(std::size_t place) const;
  void forget_oldest();

  std::size_t most_;
  std::vector<char> room_;  // a ring: each text behind its length
  std::size_t oldest_ = 0;  // the place of the oldest
  std::size_t used_ = 0;    // bytes
  std::size_t count_ = 0;   // of events
  std::uint64_t next_ = 0;  // the number that comes next; 0: none has come
};

}  // namespace pal::server
