#include "skills_pal/align/align.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "align_skill.hpp"
#include "skills_pal/modules/alter.hpp"
#include "skills_pal/modules/looking.hpp"
#include "skills_pal/modules/surface_line.hpp"

namespace pal::skills {

namespace {

using namespace align;

constexpr int looks = 3;      // that are averaged
constexpr double aside = 15;  // mm along the tool's x axis, both ways: one profile shows no lean about y
constexpr double speed = 1;   // mm in a cycle
constexpr double least_turn = 0.02;  // deg: what turning on would not make better
constexpr double farthest_off = 1;   // mm from the standoff
constexpr int most_rounds = 12;

class Method final : public SM1Activities {
 public:
  void start(const Parameters& parameters) override {
    parameters_ = parameters;
    looking_.start(speed, parameters.turn);
    place_ = Place::middle;
    height_ = lean_ = 0;
    count_ = rounds_ = 0;
    square_ = false;
  }

  Motion step(const Surface& surface) override {
    if (looking_.fresh_look(surface.taken)) look(surface);
    const Way way = looking_.step();
    Motion motion;
    motion.dx = way.dx;
    motion.dz = way.dz;
    motion.rx = way.rx;
    motion.ry = way.ry;
    return motion;
  }

  Motion stand_still() override { return {}; }
  bool decide_pc_seen(const Surface& surface) override { return surface.flat; }
  bool decide_pc_there() override { return square_; }

 private:
  // Where the tool looks: the lean about y is how the height differs between the two sides.
  enum class Place { middle, before, behind, back };

  void look(const Surface& surface) {
    height_ += surface.height / looks;
    lean_ += surface.lean / looks;
    if (++count_ < looks) return;
    Way way;
    switch (place_) {
      case Place::middle:  // the lean about x first: the profile shows it
        way.rx = lean_;
        way.dx = aside;
        way.dz = height_ - parameters_.standoff;
        place_ = Place::before;
        break;
      case Place::before:
        before_ = height_;
        way.dx = -2 * aside;
        place_ = Place::behind;
        break;
      case Place::behind:
        turn_y_ = -std::atan((before_ - height_) / (2 * aside)) * 180 / std::numbers::pi;
        middle_ = (before_ + height_) / 2;
        way.dx = aside;
        place_ = Place::back;
        break;
      case Place::back:
        judge(way);
        break;
    }
    height_ = lean_ = 0;
    count_ = 0;
    looking_.go(way);
  }

  // In the middle again: how far the tool leans about both axes, and what to do about it.
  void judge(Way& way) {
    const double off = middle_ - parameters_.standoff;
    const bool within = std::max(std::abs(lean_), std::abs(turn_y_)) <= parameters_.tolerance &&
                        std::abs(off) <= farthest_off;
    const bool best = std::max(std::abs(lean_), std::abs(turn_y_)) <= least_turn;
    if (within && (best || ++rounds_ > good_rounds)) {
      square_ = true;
      return;
    }
    if (++rounds_ > most_rounds)
      throw std::runtime_error("the tool does not come to stand square to the surface");
    way.rx = lean_;
    way.ry = turn_y_;
    way.dz = off;
    place_ = Place::middle;
  }

  static constexpr int good_rounds = 3;

  Parameters parameters_;
  Looking looking_;
  Place place_ = Place::middle;
  double height_ = 0, lean_ = 0;  // means of the looks so far: mm, deg
  double before_ = 0, middle_ = 0;
  double turn_y_ = 0;  // deg
  int count_ = 0;
  int rounds_ = 0;
  bool square_ = false;
};

}  // namespace

std::unique_ptr<runtime::Skill> align_skill() {
  return make_align(std::make_unique<Method>(), std::make_unique<SurfaceLineSensor<LS2Activities>>(),
                    std::make_unique<AlterController<MC1Activities>>(Late::hold));
}

}  // namespace pal::skills
