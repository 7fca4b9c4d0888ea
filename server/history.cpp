#include "server/history.hpp"

#include <algorithm>
#include <cstring>

namespace pal::server {

void History::add(std::uint64_t number, std::string_view told) {
  const std::size_t needed = head + told.size();
  next_ = number + 1;
  while (count_ > 0 && (count_ >= most_ || needed > room_.size() - used_)) forget_oldest();
  if (most_ == 0 || needed > room_.size()) return;
  const auto length = static_cast<std::uint32_t>(told.size());
  const std::size_t place = after(oldest_, used_);
  put(place, reinterpret_cast<const char*>(&length), head);
  put(after(place, head), told.data(), told.size());
  used_ += needed;
  ++count_;
}

void History::since(std::uint64_t number,
                    const std::function<void(std::uint64_t number, const std::string& told)>& use) const {
  std::size_t place = oldest_;
  std::string told;
  for (std::uint64_t each = first(); each < next_; ++each) {
    const std::uint32_t length = length_at(place);
    if (each > number) {
      told.resize(length);
      take(after(place, head), told.data(), length);
      use(each, told);
    }
    place = after(place, head + length);
  }
}

void History::put(std::size_t place, const char* bytes, std::size_t count) {
  const std::size_t before_end = std::min(count, room_.size() - place);
  std::memcpy(room_.data() + place, bytes, before_end);
  std::memcpy(room_.data(), bytes + before_end, count - before_end);
}

void History::take(std::size_t place, char* bytes, std::size_t count) const {
  const std::size_t before_end = std::min(count, room_.size() - place);
  std::memcpy(bytes, room_.data() + place, before_end);
  std::memcpy(bytes + before_end, room_.data(), count - before_end);
}

std::uint32_t History::length_at(std::size_t place) const {
  std::uint32_t length = 0;
  take(place, reinterpret_cast<char*>(&length), head);
  return length;
}

void History::forget_oldest() {
  const std::size_t bytes = head + length_at(oldest_);
  oldest_ = after(oldest_, bytes);
  used_ -= bytes;
  --count_;
}

}  // namespace pal::server
