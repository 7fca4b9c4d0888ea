// Opens and closes ALTER by lines on the VAL terminal.
#pragma once

#include "runtime/drivers/alter/opener.hpp"
#include "runtime/drivers/val/driver.hpp"

namespace pal::sim {

class ValOpener final : public runtime::alter::Opener {
 public:
  /// The driver outlives the opener.
  explicit ValOpener(runtime::ValDriver& terminal) : terminal_(terminal) {}

  void open(const runtime::alter::Mode& mode, Done done) override;
  void close(Done done) override;

 private:
  void submit(runtime::val::Command command, Done done);

  runtime::ValDriver& terminal_;
};

}  // namespace pal::sim
