#include "sim/cell/fault_plan.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

namespace pal::sim {
namespace {

using Kind = PlannedFault::Kind;
using runtime::drivers::Carrier;

constexpr const char* form =
    "a fault is written as: at TIME ms|s DEVICE dropout|garble|late TIME|late-answer TIME|unplug, or "
    "at TIME ms|s MODULE:LINE takes TIME";

struct Wrong {
  std::string cause;
};

/// The words of one line.
class Words {
 public:
  explicit Words(std::string_view line) : in_(std::string(line.substr(0, line.find('#')))) {}

  std::string next() {
    std::string word;
    in_ >> word;
    return word;
  }
  void expect(std::string_view wanted) {
    if (next() != wanted) throw Wrong{form};
  }
  runtime::Time time() {
    const std::string figure = next();
    double value = 0;
    const auto [end, problem] = std::from_chars(figure.data(), figure.data() + figure.size(), value);
    if (problem != std::errc() || end != figure.data() + figure.size())
      throw Wrong{figure.empty() ? form : "'" + figure + "' is not a number"};
    const std::string unit = next();
    if (unit != "ms" && unit != "s")
      throw Wrong{"a time has the unit ms or s" + (unit.empty() ? "" : ", not '" + unit + "'")};
    const double seconds = value * (unit == "ms" ? 1e-3 : 1);
    if (!(seconds >= 0 && seconds <= 3600)) throw Wrong{"a time is from 0 to 3600 s"};
    return runtime::Time(std::llround(seconds * 1e9));
  }

 private:
  std::istringstream in_;
};

/// "SM1:55", which was read as a device.
void read_statement(PlannedFault& fault) {
  fault.kind = Kind::takes;
  const std::size_t colon = fault.device.find(':');
  const std::string line = colon == std::string::npos ? "" : fault.device.substr(colon + 1);
  const auto [end, problem] = std::from_chars(line.data(), line.data() + line.size(), fault.statement);
  if (problem != std::errc() || end != line.data() + line.size() || fault.statement < 1)
    throw Wrong{"a statement is named by its module and its line, SM1:55; '" + fault.device + "' is not"};
  fault.device.resize(colon);
}

void read_kind(Words& words, PlannedFault& fault) {
  const std::string kind = words.next();
  if (kind == "dropout") {
    fault.kind = Kind::dropout;
  } else if (kind == "garble") {
    fault.kind = Kind::garble;
  } else if (kind == "unplug") {
    fault.kind = Kind::unplug;
  } else if (kind == "takes") {
    read_statement(fault);
    fault.by = words.time();
  } else if (kind == "late") {
    fault.kind = Kind::late;
    fault.by = words.time();
  } else if (kind == "late-answer") {
    fault.kind = Kind::late_answer;
    fault.by = words.time();
  } else {
    throw Wrong{kind.empty() ? form
                             : "there is no fault '" + kind +
                                   "'; there are dropout, garble, late, late-answer, unplug, takes"};
  }
}

std::optional<PlannedFault> read_line(std::string_view line) {
  Words words(line);
  const std::string first = words.next();
  if (first.empty()) return std::nullopt;
  if (first != "at") throw Wrong{form};
  PlannedFault fault;
  fault.at = words.time();
  fault.device = words.next();
  read_kind(words, fault);
  if (const std::string more = words.next(); !more.empty())
    throw Wrong{"'" + more + "' is more than a fault has"};
  return fault;
}

void flip_a_bit(std::vector<std::uint8_t>& bytes) {
  if (!bytes.empty()) bytes[bytes.size() / 2] ^= 0x10U;
}

}  // namespace

std::variant<std::vector<PlannedFault>, FaultTextError> read_faults(std::string_view text) {
  std::vector<PlannedFault> faults;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    try {
      auto fault = read_line(line);
      if (!fault) continue;
      fault->line = number;
      faults.push_back(std::move(*fault));
    } catch (const Wrong& wrong) {
      return FaultTextError{number, wrong.cause};
    }
  }
  return faults;
}

void bring_about(const PlannedFault& fault, runtime::drivers::Wire& wire) {
  const auto from_device = Carrier::Direction::to_a;
  switch (fault.kind) {
    case Kind::dropout:
      return wire.tamper([](Carrier::Direction direction, std::vector<std::uint8_t>& bytes) {
        if (direction == from_device) bytes.clear();
      });
    case Kind::garble:
      return wire.tamper([](Carrier::Direction direction, std::vector<std::uint8_t>& bytes) {
        if (direction == from_device) flip_a_bit(bytes);
      });
    case Kind::late:
      return wire.delay(from_device, fault.by);
    case Kind::late_answer:
      return wire.delay(Carrier::Direction::to_b, fault.by);
    case Kind::unplug:
      return wire.cut("unplugged");
    case Kind::takes:
      break;
  }
}

}  // namespace pal::sim
