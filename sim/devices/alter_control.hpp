// How the robot's own controller opens and closes its ALTER port.
#pragma once

#include <functional>
#include <string>

#include "runtime/drivers/alter/opener.hpp"

namespace pal::sim {

using AlterMode = runtime::drivers::alter::Mode;

/// What VAL's DO ALTER and DO NOALTER reach.
class AlterControl {
 public:
  virtual ~AlterControl() = default;
  /// From now on the port asks for a correction every 28 ms. Empty: it does; otherwise why not.
  virtual std::string open(const AlterMode& mode) = 0;
  /// Takes no more corrections; those that were accepted are still moved. Empty: all went well; otherwise
  /// what had ended it before.
  virtual std::string close() = 0;
  virtual bool is_open() const = 0;
  /// Calls `tell` with the reason when ALTER ends by itself. Empty: nobody is told.
  virtual void on_end(std::function<void(const std::string& why)> tell) = 0;
};

}  // namespace pal::sim
