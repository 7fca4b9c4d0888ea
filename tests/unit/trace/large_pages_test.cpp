// Memory in large pages: what is in it stays as it grows and shrinks, and it begins where such a page does.
#include "pal/trace/large_pages.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

using pal::trace::LargePages;

TEST_CASE("a list in large pages keeps what it has as it grows, is copied and moved") {
  constexpr std::uintptr_t large_page = std::uintptr_t(2) << 20U;
  std::vector<std::uint64_t, LargePages<std::uint64_t>> list;
  bool aligned = true;
  for (std::uint64_t i = 0; i < 2'000'000; ++i) {
    list.push_back(i * i);
    const bool large = list.capacity() * sizeof(std::uint64_t) > large_page;
    aligned = aligned && (!large || reinterpret_cast<std::uintptr_t>(list.data()) % large_page == 0);
  }
  CHECK(aligned);
  auto copy = list;
  auto moved = std::move(list);
  CHECK(copy == moved);
  moved.resize(3);
  moved.shrink_to_fit();
  CHECK(moved == decltype(moved){0, 1, 4});
  bool same = copy.size() == 2'000'000;
  for (std::uint64_t i = 0; i < copy.size(); ++i) same = same && copy[i] == i * i;
  CHECK(same);
}
