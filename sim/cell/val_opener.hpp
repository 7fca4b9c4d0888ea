// Opens and closes ALTER by lines on the VAL terminal.
#pragma once

#include "runtime/drivers/alter/opener.hpp"
#include "runtime/drivers/val/driver.hpp"

namespace pal::sim {

class ValOpener final : public runtime::drivers::alter::Opener {
 public:
  /// The driver outlives the opener.
  explicit ValOpener(runtime::drivers::ValDriver& terminal) : terminal_(terminal) {}

  void open(const runtime::drivers::alter::Mode& mode, Done done) override;
  void close(Done done) override;

 private:
  void submit(runtime::drivers::val::Command command, Done done);

  runtime::drivers::ValDriver& terminal_;
};

}  // namespace pal::sim
