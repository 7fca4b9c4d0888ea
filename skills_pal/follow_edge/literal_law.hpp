// Follow Edge by the thesis's law: equations 5.1 to 5.7, section 5.4.3 and appendix F.2.
#pragma once

#include <array>
#include <cstddef>

namespace pal::skills {

/// What is to be corrected along and about the axes of a tool whose tip is at the edge: mm and deg.
struct EdgeCorrection {
  double y = 0, z = 0;
  double rx = 0, ry = 0, rz = 0;
};

/// Each profile gives one correction, made once. Along y and z and about x it is what the profile shows to be
/// missing (5.2 to 5.5). About y and z it is the direction in which the corrections of the last `history` mm
/// led (5.6, 5.7). Each is limited, and the limited ones are what the history keeps.
///
/// The law aligns before it tracks: y, z and the turn about x alone, without a history. Then every second
/// profile counts, as the one that is scanned while a correction is made shows half of it.
///
/// What appendix F.2 prints otherwise is left out: each correction sent twice, and an entry of the history
/// counted twice.
class LiteralLaw {
 public:
  struct Limits {
    double translation = 0;  // mm a correction
    double rotation = 0;     // deg a correction
  };
  /// `history` and `standoff` in mm.
  void start(const Limits& limits, double history, double standoff);

  /// A profile: the edge is at y and z (mm, in the range finder's frame). The surface beside it leans by
  /// `slope` (deg). `gone`: how far the tool has gone along the edge, mm.
  void see(double y, double z, double slope, double gone);
  /// What is to be made at this request: nothing between two profiles.
  EdgeCorrection take();
  /// The tool may track.
  bool aligned() const { return aligned_; }

 private:
  struct Made {
    double gone = 0;  // mm
    double y = 0, z = 0;
  };
  static constexpr std::size_t room = 256;
  double limited_length(double length) const;
  double limited_turn(double turn) const;
  void remember(double gone);
  EdgeCorrection sum(double gone) const;

  Limits limits_;
  double history_ = 10;
  double standoff_ = 200;
  EdgeCorrection due_;
  std::array<Made, room> made_;  // a ring
  std::size_t count_ = 0;
  bool aligned_ = false;
  bool skip_ = false;  // the profile that is scanned while a correction is made
};

}  // namespace pal::skills
