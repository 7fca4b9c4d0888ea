// The touch skill in both orders, written by hand statement by statement from skills_pal/touch/*.pal and
// skills_pal/workcell.pal. The generated skill is compared with it.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "pal/runtime/skill.hpp"
#include "pal/runtime/thread.hpp"

namespace pal::test {

/// A message of N numbers.
template <std::size_t N>
struct Numbers {
  static constexpr std::size_t field_count = N;
  std::array<double, N> values{};

  std::array<double, N> fields() const { return values; }
  static Numbers from_fields(std::span<const double> fields) {
    Numbers message;
    for (std::size_t i = 0; i < N; ++i) message.values[i] = fields[i];
    return message;
  }
};

class WrittenTouch : public runtime::Skill {
 public:
  /// `read_first`: the order of touch_read_first.pal, else that of touch.pal.
  explicit WrittenTouch(bool read_first);

  double speed = 20;     // mm/s
  double reach = 60;     // mm
  double threshold = 5;  // N

  const runtime::SkillDescription& description() const override { return description_; }
  const runtime::Wiring& wiring() const override { return wiring_; }
  void reset_parameters() override {}
  void set_parameter(std::string_view name, double value) override;
  void start() override;
  runtime::Task body(std::size_t index, runtime::Thread& thread) override;
  void reserve_executed(runtime::Thread&) override {}

 private:
  runtime::Task sm1(runtime::Thread& thread);
  runtime::Task sm1_sense(runtime::Thread& thread);
  runtime::Task sm1_move(runtime::Thread& thread);
  runtime::Task sm1_move_read_first(runtime::Thread& thread);
  runtime::Task ls1(runtime::Thread& thread);
  runtime::Task mc1(runtime::Thread& thread);
  runtime::Task sd1(runtime::Thread& thread);
  runtime::Task cm1(runtime::Thread& thread);
  int statement(std::string_view module, std::string_view text, int line, runtime::Time best,
                runtime::Time worst);

  bool read_first_;
  std::vector<runtime::StatementSpec> statements_;
  std::vector<runtime::ChannelSpec> channels_;
  runtime::Wiring wiring_;
  runtime::SkillDescription description_;

  Numbers<6> motion_, obeyed_, correction_, wrench_, seen_;
  Numbers<2> force_, known_;
  double moved_ = 0;
  int stood_ = 0;  // motions of 0 at the reach
};

}  // namespace pal::test
