#include "runtime/drivers/force_torque/codec.hpp"

#include <cstdlib>
#include <utility>

#include "runtime/drivers/linked_driver.hpp"

namespace pal::runtime::drivers::force_torque {
namespace {

constexpr std::array<std::uint8_t, 1> boot_bytes{warm_boot};
constexpr std::array<std::uint8_t, 1> record_bytes{one_record};
constexpr std::array<const char*, axes> names{"fx", "fy", "fz", "tx", "ty", "tz"};
constexpr std::size_t longest_answer = 200;

}  // namespace

std::array<double, axes> Record::values() const {
  std::array<double, axes> values{};
  for (std::size_t i = 0; i < axes; ++i) {
    values[i] = counts[i] / (i < 3 ? counts_per_newton : counts_per_newton_metre);
  }
  return values;
}

Bytes Codec::boot() {
  question_ = Question::boot;
  received_ = 0;
  return boot_bytes;
}

Bytes Codec::command(std::string_view text) {
  question_ = Question::echo;
  sent_ = text;
  sent_ += static_cast<char>(carriage_return);
  answer_.clear();
  received_ = 0;
  return as_bytes(sent_);
}

Bytes Codec::request_record() {
  question_ = Question::record;
  received_ = 0;
  echoed_ = false;
  return record_bytes;
}

Codec::Progress Codec::feed(std::uint8_t byte) {
  switch (question_) {
    case Question::none:
      return garble("sends " + shown({&byte, 1}) + " without being asked");
    case Question::boot:
      ++received_;
      if (byte != '>') return Progress::more;
      question_ = Question::none;
      return Progress::done;
    case Question::echo:
      return feed_echo(byte);
    case Question::prompt:
      return feed_prompt(byte);
    case Question::record:
      return feed_record(byte);
  }
  return Progress::more;
}

Codec::Progress Codec::feed_echo(std::uint8_t byte) {
  const auto expected = static_cast<std::uint8_t>(sent_[received_]);
  if (byte != expected) {
    return garble("echoes " + shown({&byte, 1}) + " where " + shown({&expected, 1}) + " was sent");
  }
  if (++received_ == sent_.size()) question_ = Question::prompt;
  return Progress::more;
}

Codec::Progress Codec::feed_prompt(std::uint8_t byte) {
  if (byte != '>') {
    if (byte >= 0x20) answer_ += static_cast<char>(byte);
    if (answer_.size() > longest_answer) return garble("answers without end");
    return Progress::more;
  }
  question_ = Question::none;
  if (answer_.find('?') == std::string::npos) return Progress::done;
  return garble("refuses \"" + sent_.substr(0, sent_.size() - 1) + "\": it says \"" + answer_ + '"');
}

Codec::Progress Codec::feed_record(std::uint8_t byte) {
  if (received_ == 0) {
    if (byte == one_record && !std::exchange(echoed_, true)) return Progress::more;
    if (byte > 1)
      return garble("a record begins with the byte " + in_hexadecimal({&byte, 1}) +
                    ", which is no overload byte");
  }
  bytes_[received_++] = byte;
  if (received_ < record_size) return Progress::more;
  question_ = Question::none;
  record_.overload = bytes_[0] != 0;
  for (std::size_t i = 0; i < axes; ++i) {
    const auto word = static_cast<std::uint16_t>((bytes_[1 + 2 * i] << 8) | bytes_[2 + 2 * i]);
    record_.counts[i] = static_cast<std::int16_t>(word);
    if (std::abs(record_.counts[i]) > (i < 3 ? greatest_force : greatest_torque)) {
      return garble("a record says " + std::to_string(record_.counts[i]) + " counts along " + names[i] +
                    ", more than the sensor has");
    }
  }
  return Progress::done;
}

Codec::Progress Codec::garble(std::string problem) {
  question_ = Question::none;
  problem_ = std::move(problem);
  return Progress::garbled;
}

std::string Codec::missing() const {
  switch (question_) {
    case Question::none:
      return "nothing was asked";
    case Question::boot:
      return "no prompt came after control W";
    case Question::echo:
      return "only " + std::to_string(received_) + " of the " + std::to_string(sent_.size()) +
             " characters of \"" + sent_.substr(0, sent_.size() - 1) + "\" came back";
    case Question::prompt:
      return "no prompt came after \"" + sent_.substr(0, sent_.size() - 1) + '"';
    case Question::record:
      if (received_ == 0) return "no record came";
      return "only " + std::to_string(received_) + " of the " + std::to_string(record_size) +
             " bytes of a record came";
  }
  return {};
}

}  // namespace pal::runtime::drivers::force_torque
