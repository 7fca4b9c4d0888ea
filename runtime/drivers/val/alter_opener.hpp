// Opens and closes ALTER by lines on the VAL terminal.
#pragma once

#include "runtime/drivers/alter/opener.hpp"
#include "runtime/drivers/val/driver.hpp"

namespace pal::runtime::drivers::val {

class AlterOpener final : public alter::Opener {
 public:
  /// The driver outlives the opener.
  explicit AlterOpener(ValDriver& terminal) : terminal_(terminal) {}

  void open(const alter::Mode& mode, Done done) override;
  void close(Done done) override;

 private:
  void submit(Command command, Done done);

  ValDriver& terminal_;
};

}  // namespace pal::runtime::drivers::val
