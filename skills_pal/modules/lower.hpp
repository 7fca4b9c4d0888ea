// SM1 and CM4 of a skill that lowers a part onto a place, with the conditions of lower.pal.
#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "skills_pal/modules/gripper.hpp"
#include "skills_pal/modules/listing.hpp"
#include "skills_pal/modules/z_force.hpp"

namespace pal::skills {

/// The location at which the fingers open, by a skill's parameters.
template <class Interface>
using PlaceOf = runtime::Text (*)(const ArgumentOf<&Interface::start>& parameters);

/// SM1, but for the way above the place: list-step, list-release and the conditions. Parameter `feel`: a step
/// at a time; otherwise down in one go.
///
/// The fingers reach 10 mm below the tip, and what stands at the place is met by the part's underside. With a
/// part that is held at its middle and is 50 mm high, that leaves 15 mm until the fingers, too, would grip
/// what stands there.
template <class Interface, class Command, PlaceOf<Interface> place>
class Lowering : public Listing<Interface, Command> {
  using Base = Listing<Interface, Command>;
  using Grip = ArgumentOf<&Interface::decide_pc_holding>;
  using Zforce = ArgumentOf<&Interface::decide_pc_blocked>;

 public:
  using Base::Base;

  void start(const ArgumentOf<&Interface::start>& parameters) override {
    Base::start(parameters);
    hanging_ = 0;
    held_ = false;
  }

  // Apart from the way there: what the tool meets here stands at the place.
  void list_step() override {
    height_ = this->parameters().feel ? std::max(0.0, height_ - step) : 0;
    this->list().begin();
    if (height_ > 0) {
      this->list().add(Verb::approach_straight, place(this->parameters()), height_);
    } else {
      this->list().add(Verb::move_straight, place(this->parameters()));
    }
  }
  void list_release() override {
    this->list().begin();
    this->list()
        .add(Verb::open_hand)
        .add(Verb::delay, this->parameters().grip_delay)
        .add(Verb::depart_straight, this->parameters().approach);
  }

  // What hangs in the fingers pulls. What presses already is no weight: the first step will show it.
  void weigh(const Zforce& force) override { hanging_ = std::min(force.value, 0.0); }
  // The skill has asked whether the fingers hold something, and they do not.
  void complain() override {
    throw std::runtime_error(held_ ? "the part slipped out of the fingers on the way"
                                   : "the fingers hold nothing to put down");
  }

  bool decide_pc_holding(const Grip& grip) override {
    held_ = held_ || grip.holding;
    return grip.holding;
  }
  bool decide_pc_down() override { return height_ <= 0; }
  // At the place the part may press: that is what it is put down on.
  bool decide_pc_blocked(const Zforce& force) override {
    return height_ > 0 && force.value - hanging_ >= contact;
  }

 protected:
  /// The way there ends above the place, by the parameter `approach`: the first step goes down from that.
  void begin_above() { height_ = this->parameters().approach; }

 private:
  static constexpr double step = 14;    // mm
  static constexpr double contact = 5;  // N: more than the tool's weight shifts by when it comes to rest
  double height_ = 0;                   // mm above the place, as it was commanded
  double hanging_ = 0;                  // N, not positive: what the part in the fingers pulls with
  bool held_ = false;                   // the fingers held the part when the skill began
};

/// CM4.
template <class Interface, class Command, PlaceOf<Interface> place>
class LiftAgain final : public Listing<Interface, Command> {
 public:
  using Listing<Interface, Command>::Listing;

  void list_return() override {
    this->list().begin();
    this->list()
        .add(Verb::calibrate)
        .add(Verb::approach_straight, place(this->parameters()), this->parameters().approach);
  }
};

}  // namespace pal::skills
