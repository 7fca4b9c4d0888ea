// Commands to a VAL II controller and its answers, as values.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "pal/runtime/device.hpp"

namespace pal::runtime::drivers::val {

/// A command. Numbers 4 to 28 are those of the thesis (appendix E.1); the rest are ours. A PAL activity puts
/// one into the field `verb` of the message `command`. In brackets: the fields that count; the others are
/// ignored.
enum class Verb : std::int64_t {
  delay = 4,               // [a: s]
  open_hand = 5,           // OPENI
  close_hand = 6,          // CLOSEI
  speed = 7,               // [a: per cent] of all motions
  set = 8,                 // [location, second] location becomes second
  drive = 9,               // [a: joint, b: deg, c: per cent] turns one joint
  depart = 10,             // [a: mm] back along the tool
  depart_straight = 11,    // [a: mm]
  approach = 12,           // [location, a: mm] so far before it
  approach_straight = 13,  // [location, a: mm]
  shift = 14,              // [location, a, b, c: mm] shifts the location's value
  where = 15,              // answers X Y Z O A T and six joint angles
  move = 16,               // [location] joint-interpolated
  move_relative = 17,      // [location] from where the tool is, joint-interpolated
  move_straight = 18,      // [location]
  execute = 19,  // [a: n, b: count] program PROGn; does not wait for its answer, which `clear` gives
  base = 20,     // [a, b, c: mm, d: deg]
  tool = 21,     // [location] of the tip from the flange
  here = 22,     // [location] teaches where the tip is
  mode = 23,     // [a: m, b: n] the number MODEm becomes n
  abort = 24,
  abort_process = 25,      // PCABORT
  clear = 26,              // the answer that `execute` did not wait for
  set_figures = 27,        // [location, a … f: x y z mm, o a t deg]
  point = 28,              // [location] answers its X Y Z O A T
  straight_to = 40,        // [a … f: x y z mm, o a t deg] in a straight line
  straight_relative = 41,  // [location] from where the tool is, in a straight line
  straight_speed = 42,     // [a: mm/s] of the tip in straight motions, at a monitor speed of 100 per cent
  open_alter = 43,         // [a: mode, the sum of 1 cumulative, 2 world and 4 joints]
  close_alter = 44,
  calibrate = 45,    // clears a fault of the arm
  configure = 46,    // [location: RIGHTY, LEFTY, ABOVE, BELOW, FLIP or NOFLIP] of the next `move`
  ready = 47,        // to the upright pose
  joint_speed = 48,  // [a: per cent] what straight_speed had taken the place of
};

/// The kind of an error, for programs: a skill chooses its completion by it.
enum class Error : std::int64_t {
  none = 0,
  unreachable = 1,  // out of reach, of a joint's range or of what a joint or the tool can do in speed
  undefined = 2,    // no such location, number or program
  refused = 3,      // anything else that VAL refuses, and what the driver does not send
  arm_fault = 4,    // the arm stopped by itself, until `calibrate`
  aborted = 5,
  busy = 6,       // the arm is a program's, is moving, or ALTER is open
  no_answer = 7,  // the line is broken, or what came is no answer
};

struct Command {
  Verb verb = Verb::clear;
  std::string location;
  std::string second;
  std::array<double, 6> figures{};  // a to f
};

struct Answer {
  bool ok = true;
  Error error = Error::none;
  std::string text;  // of an error, whole
  std::array<double, 12> values{};

  static Answer failed(Error error, std::string text) { return {false, error, std::move(text), {}}; }
};

}  // namespace pal::runtime::drivers::val
