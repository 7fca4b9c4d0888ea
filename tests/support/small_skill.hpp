// Skills of two or three parties that do a few things in every order.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// A controller and the method, one of which asks the other in every round. Around that, the rounds of each
/// do up to three things of a short list. The seed counts through all orders of them. It also draws the rest
/// of the skill, and all times. Small enough for the exact analysis, with bounds of the compositional one.
/// The same seed gives the same text.
class SmallSkill {
 public:
  explicit SmallSkill(std::uint64_t seed);

  /// So many seeds in a row have all orders, once each.
  static std::uint64_t orders();

  std::string text();

 private:
  /// Which modules ask which, and what there is besides.
  enum class Shape {
    controller_asks,  // of events of its device
    method_asks,      // by itself
    two_ask,          // the method answers two controllers, by WTM FIRST
    blocks,           // of the method, one for each of two controllers
  };
  using Order = std::vector<int>;

  static std::vector<Order> orders_of(int things, int most);
  static const std::vector<Order>& of_method();
  static const std::vector<Order>& of_controller();

  std::string ask(const std::string& message, const std::string& server, bool may_give_up);
  std::string last();
  std::string thing_of_method(int which);
  std::string sample();
  std::string thing_of_controller(int which);
  std::string method_round();
  std::string controller_round();
  std::string before_rounds();
  std::string method();
  std::string method_of_blocks(const std::string& round);
  std::string controllers();
  std::string sensor();
  std::string declarations() const;
  std::string requirements() const;
  std::string environment();

  bool asked_by_controller() const { return shape_ != Shape::method_asks; }
  bool two_controllers() const { return shape_ == Shape::two_ask || shape_ == Shape::blocks; }

  Chance chance_;
  Shape shape_;
  Order method_;
  Order controller_;
  bool reader_;          // a controller reads both conditions
  bool second_event_;    // begins rounds of the controller
  bool frames_;          // what the controller asks its device for
  bool sensor_ = false;  // the method asks it
  bool device_ = false;  // the controller asks it
};

}  // namespace pal::test
