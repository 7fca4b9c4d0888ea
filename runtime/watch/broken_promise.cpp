#include "pal/runtime/broken_promise.hpp"

namespace pal::runtime {

std::string in_words(Time time) {
  struct Unit {
    Time::rep length;
    int digits;
    const char* name;
  };
  static constexpr Unit units[] = {{1'000'000'000, 9, " s"}, {1'000'000, 6, " ms"}, {1'000, 3, " us"}};
  const Time::rep count = time.count() < 0 ? -time.count() : time.count();
  for (const Unit& unit : units) {
    if (count < unit.length) continue;
    std::string text = std::to_string(count / unit.length);
    std::string rest = std::to_string(count % unit.length);
    rest.insert(0, static_cast<std::size_t>(unit.digits) - rest.size(), '0');
    rest.erase(rest.find_last_not_of('0') + 1);
    if (!rest.empty()) text += '.' + rest;
    return (time.count() < 0 ? "-" : "") + text + unit.name;
  }
  return std::to_string(time.count()) + " ns";
}

std::string in_words(Time measured, BrokenPromise::Unit unit) {
  if (unit == BrokenPromise::Unit::time) return in_words(measured);
  if (unit == BrokenPromise::Unit::messages) return std::to_string(measured.count());
  const auto tenths = (measured.count() + 500'000) / 1'000'000;  // of a per cent
  return std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10)) + " %";
}

std::string in_words(const BrokenPromise& broken) {
  const bool answered = broken.measured != Time::max();
  std::string text = broken.promise;
  if (!answered) text += ": not answered";
  if (answered && broken.measured != Time::zero())
    text += ": measured " + in_words(broken.measured, broken.unit);
  if (broken.times > 1) text += ", " + std::to_string(broken.times) + " times";
  std::string_view separator = "; endangers ";
  for (const std::string& requirement : broken.endangers) {
    text += std::string(separator) + requirement;
    separator = ", ";
  }
  return text;
}

}  // namespace pal::runtime
