#include "runtime/drivers/val/codec.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <sstream>
#include <vector>

namespace pal::runtime::drivers::val {
namespace {

// Thrown within this file.
struct Unsayable {
  std::string why;
};

std::string number(double value) {
  constexpr double greatest = 1e6;
  if (!std::isfinite(value) || std::abs(value) > greatest) throw Unsayable{"a number is beyond 1000000"};
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", std::round(value * 1e3) / 1e3 + 0.0);
  std::string shown = text.data();
  while (shown.back() == '0') shown.pop_back();
  if (shown.back() == '.') shown.pop_back();
  return shown;
}

std::string whole(double value, const char* what) {
  if (value != std::floor(value)) throw Unsayable{std::string(what) + " is no whole number"};
  return number(value);
}

// A name, or several with colons between them.
std::string name(const std::string& text) {
  const auto fits = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == ':';
  };
  if (text.empty()) throw Unsayable{"the name of a location is missing"};
  if (!std::all_of(text.begin(), text.end(), fits)) throw Unsayable{"'" + text + "' is no location's name"};
  return text;
}

std::string list(std::span<const double> values, const char* separator) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : separator) + number(value);
  return text;
}

std::string write(const Command& c) {
  const std::array<double, 6>& f = c.figures;
  switch (c.verb) {
    case Verb::delay:
      return "DO DELAY " + number(f[0]);
    case Verb::open_hand:
      return "DO OPENI";
    case Verb::close_hand:
      return "DO CLOSEI";
    case Verb::speed:
      return "SPEED " + number(f[0]);
    case Verb::set:
      return "DO SET " + name(c.location) + " = " + name(c.second);
    case Verb::set_figures:
      return "DO SET " + name(c.location) + "=TRANS(" + list(f, ",") + ")";
    case Verb::shift:
      return "DO SET " + name(c.location) + "=SHIFT(" + c.location + " BY " +
             list(std::span(f).first(3), ", ") + ")";
    case Verb::drive:
      return "DO DRI " + whole(f[0], "the joint") + ", " + number(f[1]) + ", " + number(f[2]);
    case Verb::depart:
      return "DO DEPART " + number(f[0]);
    case Verb::depart_straight:
      return "DO DEPARTS " + number(f[0]);
    case Verb::approach:
      return "DO APPRO " + name(c.location) + " " + number(f[0]);
    case Verb::approach_straight:
      return "DO APPROS " + name(c.location) + " " + number(f[0]);
    case Verb::where:
      return "WHERE";
    case Verb::move:
      return "DO MOVE " + name(c.location);
    case Verb::move_relative:
      return "DO MOVE HERE:" + name(c.location);
    case Verb::move_straight:
      return "DO MOVES " + name(c.location);
    case Verb::straight_to:
      return "DO MOVES TRANS(" + list(f, ",") + ")";
    case Verb::straight_relative:
      return "DO MOVES HERE:" + name(c.location);
    case Verb::straight_speed:
      return "DO SPEED " + number(f[0]) + " MMPS ALWAYS";
    case Verb::joint_speed:
      return "DO SPEED " + number(f[0]) + " ALWAYS";
    case Verb::execute:
      return "EXECUTE PROG" + whole(f[0], "the program's number") + "," + whole(f[1], "the count");
    case Verb::base:
      return "BASE " + list(std::span(f).first(4), ", ");
    case Verb::tool:
      return "TOOL " + name(c.location);
    case Verb::here:
      return "DO HERE " + name(c.location);
    case Verb::mode:
      return "DO MODE" + whole(f[0], "the mode's number") + " = " + whole(f[1], "the mode");
    case Verb::abort:
      return "ABORT";
    case Verb::abort_process:
      return "PCABORT";
    case Verb::point:
      return "POINT " + name(c.location);
    case Verb::open_alter:
      return "DO ALTER(" + whole(f[0], "the mode") + ")";
    case Verb::close_alter:
      return "DO NOALTER";
    case Verb::calibrate:
      return "CALIBRATE";
    case Verb::configure:
      return "DO " + name(c.location);
    case Verb::ready:
      return "DO READY";
    case Verb::clear:
      return "";
  }
  throw Unsayable{"there is no verb " + std::to_string(static_cast<std::int64_t>(c.verb))};
}

bool moves(Verb verb) {
  switch (verb) {
    case Verb::open_hand:
    case Verb::close_hand:
    case Verb::drive:
    case Verb::depart:
    case Verb::depart_straight:
    case Verb::approach:
    case Verb::approach_straight:
    case Verb::move:
    case Verb::move_relative:
    case Verb::move_straight:
    case Verb::straight_to:
    case Verb::straight_relative:
    case Verb::ready:
      return true;
    default:
      return false;
  }
}

Error kind_of(std::string_view what) {
  struct Row {
    std::string_view text;
    Error error;
  };
  static constexpr std::array<Row, 13> rows{{{"Location too far", Error::unreachable},
                                             {"Location too close", Error::unreachable},
                                             {"Joint out of range", Error::unreachable},
                                             {"Joint too fast", Error::unreachable},
                                             {"Tool too fast", Error::unreachable},
                                             {"Undefined value", Error::undefined},
                                             {"Undefined program", Error::undefined},
                                             {"Arm fault", Error::arm_fault},
                                             {"Aborted", Error::aborted},
                                             {"Arm is busy", Error::busy},
                                             {"Arm is a program's", Error::busy},
                                             {"ALTER is open", Error::busy},
                                             {"Program is running", Error::busy}}};
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.text == what; });
  return row == rows.end() ? Error::refused : row->error;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

// Six figures from line `line` on into `values`.
bool read_figures(const std::vector<std::string>& lines, std::size_t line, std::span<double, 6> values) {
  if (line >= lines.size()) return false;
  std::istringstream in(lines[line]);
  for (double& value : values)
    if (!(in >> value)) return false;
  std::string more;
  return !(in >> more);
}

}  // namespace

LineOf line_of(const Command& command) {
  try {
    return {write(command), {}};
  } catch (const Unsayable& unsayable) {
    return {{}, unsayable.why};
  }
}

Time answer_time(const Command& command, Time plain, Time motion) {
  if (moves(command.verb)) return motion;
  if (command.verb != Verb::delay) return plain;
  using Seconds = std::chrono::duration<double>;
  const double most = Seconds(motion - plain).count();
  return plain + std::chrono::duration_cast<Time>(Seconds(std::clamp(command.figures[0], 0.0, most)));
}

Answer read_answer(const Command& command, std::string_view shown) {
  const std::size_t star = shown.find('*');
  if (star != std::string_view::npos) {
    const std::string_view error = shown.substr(star + 1, shown.find_first_of("\r\n", star) - star - 1);
    const std::size_t end = error.find('*');
    std::string text(error.substr(0, end));
    const Error kind = kind_of(text);
    if (end != std::string_view::npos) text += error.substr(end + 1);
    return Answer::failed(kind, text);
  }
  Answer answer;
  const std::vector<std::string> lines = lines_of(shown);
  const std::span values(answer.values);
  const bool where = command.verb == Verb::where;
  if (!where && command.verb != Verb::point) return answer;
  if (read_figures(lines, 1, values.first<6>()) && (!where || read_figures(lines, 3, values.last<6>())))
    return answer;
  return Answer::failed(Error::no_answer, "VAL's figures are garbled");
}

}  // namespace pal::runtime::drivers::val
