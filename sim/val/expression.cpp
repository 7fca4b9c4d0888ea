#include "sim/val/expression.hpp"

#include <cctype>
#include <charconv>
#include <cmath>

#include "sim/val/error.hpp"

namespace pal::sim::val {
namespace {

bool is_letter(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool reserved(const std::string& word) {
  for (const char* taken : {"HERE", "NULL", "TRANS", "SHIFT", "INVERSE", "BY"})
    if (word == taken) return true;
  return false;
}

// Up to `count` numbers between commas; what is left out is 0.
template <std::size_t count>
std::array<double, count> numbers(Line& line, const Values& values) {
  std::array<double, count> read{};
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && !line.take(',')) break;
    read[i] = number(line, values);
  }
  return read;
}

Pose primary(Line& line, const Values& values) {
  const std::optional<std::string> word = line.word();
  if (!word) throw Error("Missing location");
  if (*word == "HERE") return values.here;
  if (*word == "NULL") return Pose::Identity();
  if (*word == "TRANS") {
    line.expect('(');
    const Pose pose = pose_of(numbers<6>(line, values));
    line.expect(')');
    return pose;
  }
  if (*word == "SHIFT") {
    line.expect('(');
    Pose pose = location(line, values);
    if (line.word() != "BY") throw Error("Syntax error", "BY is missing");
    const std::array<double, 3> by = numbers<3>(line, values);
    pose.translation() += 1e-3 * Eigen::Vector3d(by[0], by[1], by[2]);
    line.expect(')');
    return pose;
  }
  if (*word == "INVERSE") {
    line.expect('(');
    const Pose pose = location(line, values);
    line.expect(')');
    return pose.inverse();
  }
  const auto found = values.store.locations.find(*word);
  if (found == values.store.locations.end()) throw Error("Undefined value", *word);
  return found->second;
}

}  // namespace

Line::Line(std::string_view text) : text_(text) {
  for (char& c : text_) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

void Line::skip() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
}

bool Line::done() {
  skip();
  return at_ == text_.size();
}

std::optional<std::string> Line::word() {
  skip();
  std::size_t end = at_;
  if (end == text_.size() || !is_letter(text_[end])) return std::nullopt;
  while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]) || text_[end] == '_')) ++end;
  const std::string found = text_.substr(at_, end - at_);
  at_ = end;
  return found;
}

std::optional<std::string> Line::look() {
  const std::size_t before = at_;
  const std::optional<std::string> found = word();
  at_ = before;
  return found;
}

bool Line::take(char symbol) {
  skip();
  if (at_ == text_.size() || text_[at_] != symbol) return false;
  ++at_;
  return true;
}

void Line::expect(char symbol) {
  if (!take(symbol)) throw Error("Syntax error", std::string("'") + symbol + "' is missing");
}

std::string Line::name() {
  const std::optional<std::string> found = word();
  if (!found) throw Error("Missing name");
  if (found->size() > longest_name) throw Error("Name too long", *found);
  if (reserved(*found)) throw Error("Illegal name", *found);
  return *found;
}

std::optional<double> Line::literal() {
  skip();
  std::size_t begin = at_;
  if (begin < text_.size() && text_[begin] == '+') ++begin;
  double value = 0;
  const char* const first = text_.data() + begin;
  const auto [end, problem] =
      std::from_chars(first, text_.data() + text_.size(), value, std::chars_format::fixed);
  if (end == first || problem != std::errc() || !std::isfinite(value)) return std::nullopt;
  at_ = static_cast<std::size_t>(end - text_.data());
  return value;
}

void Line::end() {
  if (!done()) throw Error("Syntax error", "not understood from '" + text_.substr(at_, 12) + "' on");
}

double number(Line& line, const Values& values) {
  if (const std::optional<std::string> named = line.look()) {
    const auto found = values.store.reals.find(*named);
    if (found == values.store.reals.end()) throw Error("Undefined value", *named);
    line.word();
    return found->second;
  }
  const std::optional<double> value = line.literal();
  if (!value) throw Error("Missing number");
  constexpr double greatest = 1e6;
  if (std::abs(*value) > greatest) throw Error("Illegal value", "beyond 1000000");
  return *value;
}

long whole_number(Line& line, const Values& values, long least, long most) {
  const double value = number(line, values);
  if (value != std::floor(value)) throw Error("Illegal value", "a whole number is wanted");
  if (value < static_cast<double>(least) || value > static_cast<double>(most))
    throw Error("Illegal value", std::to_string(least) + " to " + std::to_string(most) + " is wanted");
  return static_cast<long>(value);
}

Pose location(Line& line, const Values& values) {
  Pose pose = primary(line, values);
  while (line.take(':')) pose = pose * primary(line, values);
  return pose;
}

}  // namespace pal::sim::val
