// Keeps a force on a surface by relative motions that take effect late.
#pragma once

namespace pal::skills {

/// Decides once an ALTER cycle how far to go towards the surface.
///
/// A motion that is decided at one request is made from the next to the one after it. So the force that is
/// known at a request shows none of the last motion. The regulator therefore keeps a model. It says how deep
/// the tool is in the surface. For a tool that slides it also says by how much the surface rises each cycle.
/// Both are corrected by each force. The regulator goes half of the way that is still missing after the last
/// motion. In addition it goes as much as the surface rises meanwhile.
///
/// The surface's stiffness is learned while the tool lands. Then the surface cannot rise, so only the motion
/// changes the force. What is learned stays within three times and a third of what was given. A sponge is
/// stiffer for fast motions than for slow ones. Going half of the way keeps the loop stable as long as the
/// surface is less than three times as stiff as assumed.
///
/// While the tool stands, the joints rest at whole counts of their encoders only. Near the target the
/// regulator tries one place after the other, and leans the tool by hundredths of a degree to find places in
/// between. The error that counts as good enough grows with the places that were tried without success.
class ForceRegulator {
 public:
  /// `target` in N; `stiffness` in N/mm as far as it is known; no motion is greater than `most`, mm. A force
  /// that has stood at the target for 3 s is left alone until it has drifted by `drift`, N.
  void start(double target, double stiffness, double most, double drift = 0);

  /// The next motion, mm towards the surface. `force`: the newest, N. `sliding`: the surface may rise.
  double next(double force, bool sliding);
  /// The turn about the tool's Y axis that goes with that motion, deg. 0 while the tool slides.
  double turn() const { return turn_; }
  /// A motion that something else decided on at this request, mm, with the force that was known, N.
  void follow(double force, double motion);

  double stiffness() const { return stiffness_; }  // N/mm, as learned
  double rise() const { return rise_; }            // mm a cycle
  double gone() const { return gone_; }            // mm, the sum of all motions
  /// The tool stands, and the force is so near the target that it is left alone.
  bool holds() const { return holds_; }

 private:
  void learn(double force);
  double standing(double force, double missing);
  double attempt(double error);
  void look_again();
  void observe(double force, bool sliding);
  void remember(double force, double motion);

  double target_ = 0;
  double stiffness_ = 0;
  double given_stiffness_ = 0;
  double most_ = 0;
  double drift_ = 0;
  double depth_ = 0;   // mm, at the last request
  double rise_ = 0;    // mm a cycle
  double given_ = 0;   // mm: the motion given at the last request, not yet begun at it
  double before_ = 0;  // mm: the one before, which was made between the last request and this one
  double force_ = 0;   // N, at the last request
  double gone_ = 0;
  bool holds_ = false;
  int held_ = 0;     // cycles since the force stands
  int looked_ = 0;   // cycles since the last motion near the target
  double seen_ = 0;  // N, the mean error that was seen since
  int tries_ = 0;
  int leaps_ = 0;       // tries that led over the target
  double reach_ = 1;    // how much longer a try is than the learned stiffness says
  double tried_ = 0;    // N, the error at the last try; 0: there was none
  double leaning_ = 0;  // deg, the sum of all turns
  double turn_ = 0;     // deg
};

}  // namespace pal::skills
