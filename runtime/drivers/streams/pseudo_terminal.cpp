#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "runtime/drivers/streams/pseudo_terminal.hpp"

namespace pal::runtime::drivers {

PseudoTerminal open_pseudo_terminal() {
  PseudoTerminal result;
  const auto fail = [&result](const char* what) {
    const std::error_code why(errno, std::generic_category());
    if (result.near_side >= 0) ::close(result.near_side);
    if (result.far_side >= 0) ::close(result.far_side);
    throw std::system_error(why, what);
  };
  result.near_side = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (result.near_side < 0 || ::grantpt(result.near_side) != 0 || ::unlockpt(result.near_side) != 0)
    fail("opening a pseudo-terminal");
  std::array<char, 128> path{};
  if (::ptsname_r(result.near_side, path.data(), path.size()) != 0) fail("naming a pseudo-terminal");
  result.path = path.data();
  result.far_side = ::open(path.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios settings{};
  if (result.far_side < 0 || ::tcgetattr(result.far_side, &settings) != 0)
    fail("opening a pseudo-terminal's far side");
  ::cfmakeraw(&settings);
  if (::tcsetattr(result.far_side, TCSANOW, &settings) != 0) fail("setting up a pseudo-terminal");
  return result;
}

}  // namespace pal::runtime::drivers
