// Opens the ALTER port through VAL, as on the machine.
#pragma once

#include "runtime/drivers/alter/opener.hpp"
#include "runtime/drivers/val/val_driver.hpp"

namespace pal::runtime {

class ValAlterOpener final : public alter::Opener {
 public:
  /// The driver outlives the opener.
  explicit ValAlterOpener(ValDriver& val) : val_(val) {}

  void open(const alter::Mode& mode, Done done) override {
    const double sum = (mode.cumulative ? 1 : 0) + (mode.world ? 2 : 0);
    submit({val::Verb::open_alter, {}, {}, {sum}}, std::move(done));
  }
  void close(Done done) override { submit({val::Verb::close_alter, {}, {}, {}}, std::move(done)); }

 private:
  void submit(val::Command command, Done done) {
    val_.submit(std::move(command),
                [done = std::move(done)](const val::Answer& answer) { done(answer.text); });
  }

  ValDriver& val_;
};

}  // namespace pal::runtime
