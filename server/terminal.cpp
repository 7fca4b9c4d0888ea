#include "server/terminal.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace pal::server {
namespace {

[[noreturn]] void close_and_fail(int descriptor, const std::string& what) {
  const std::error_code why(errno, std::generic_category());
  if (descriptor >= 0) ::close(descriptor);
  throw std::system_error(why, what);
}

speed_t speed_of(unsigned baud) {
  switch (baud) {
    case 1200:
      return B1200;
    case 2400:
      return B2400;
    case 4800:
      return B4800;
    case 9600:
      return B9600;
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    case 57600:
      return B57600;
    case 115200:
      return B115200;
    default:
      return B0;
  }
}

}  // namespace

OpenTerminal open_pseudo_terminal() {
  OpenTerminal result;
  result.descriptor = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  if (result.descriptor < 0 || ::grantpt(result.descriptor) != 0 || ::unlockpt(result.descriptor) != 0)
    close_and_fail(result.descriptor, "opening a pseudo-terminal");
  std::array<char, 128> path{};
  if (::ptsname_r(result.descriptor, path.data(), path.size()) != 0)
    close_and_fail(result.descriptor, "naming a pseudo-terminal");
  result.path = path.data();
  // By the near side: the far side is closed, so that a client's coming and going is seen.
  termios settings{};
  if (::tcgetattr(result.descriptor, &settings) != 0) close_and_fail(result.descriptor, result.path);
  ::cfmakeraw(&settings);
  if (::tcsetattr(result.descriptor, TCSANOW, &settings) != 0) close_and_fail(result.descriptor, result.path);
  return result;
}

OpenTerminal open_serial(const std::string& path, unsigned baud) {
  const speed_t speed = speed_of(baud);
  if (speed == B0) {
    errno = EINVAL;
    close_and_fail(-1, std::to_string(baud) + " baud");
  }
  OpenTerminal result{::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK), path};
  termios settings{};
  if (result.descriptor < 0 || ::tcgetattr(result.descriptor, &settings) != 0)
    close_and_fail(result.descriptor, path);
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  ::cfsetispeed(&settings, speed);
  ::cfsetospeed(&settings, speed);
  if (::tcsetattr(result.descriptor, TCSANOW, &settings) != 0) close_and_fail(result.descriptor, path);
  return result;
}

}  // namespace pal::server
