// Sends the bytes of a wire out of the process and back, in virtual time.
#pragma once

#include <memory>

#include "runtime/drivers/wire.hpp"

namespace pal::runtime::drivers {

/// Each parcel of a wire goes in at one side of a pseudo-terminal. It must come out at the other side before
/// the wire goes on. So there are real descriptors, and still the same run each time. Both functions throw
/// std::system_error if the system does not give what is needed. carry() throws std::runtime_error if bytes
/// do not come out within a second.
std::unique_ptr<Carrier> pseudo_terminal_carrier();
/// The same over a TCP connection on this machine.
std::unique_ptr<Carrier> tcp_carrier();

}  // namespace pal::runtime::drivers
