// Moves, stands, looks: how a skill corrects itself by a sensor that is slow.
#pragma once

#include <array>

namespace pal::skills {

/// What is still to be gone, along and about the axes of the tool: mm and deg.
struct Way {
  double dx = 0, dy = 0, dz = 0;
  double rx = 0, ry = 0;
};

/// Cuts a way into steps of one ALTER cycle. Then it waits until the tool has stood long enough that a new
/// profile was scanned at rest. Each such profile is a fresh look; the skill averages several.
class Looking {
 public:
  /// mm and deg in a cycle.
  void start(double most_length, double most_turn);

  /// Ways are gone one after the other; the tool must be standing.
  void go(const Way& way);
  /// The next step of the way; none while the tool stands.
  Way step();
  /// True once for each profile that was taken while the tool stood. `taken`: when its scan began, ms.
  bool fresh_look(double taken);

 private:
  // After this many cycles a profile was scanned at rest: see the requirement fresh-look of the skills.
  static constexpr int cycles_at_rest = 12;

  double most_length_ = 1;
  double most_turn_ = 1;
  Way left_;
  int stood_ = 0;  // cycles without a motion
  double last_taken_ = -1;
};

}  // namespace pal::skills
