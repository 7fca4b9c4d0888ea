#include "runtime/drivers/streams/carrier.hpp"

#include <poll.h>
#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "runtime/drivers/streams/pseudo_terminal.hpp"

namespace pal::runtime::drivers {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr std::size_t most_at_once = 1024;  // fits into every kernel's buffer
constexpr int patience_ms = 1000;

// Puts all bytes in at `in` and takes as many out at `out`.
std::vector<std::uint8_t> pass(int in, int out, Bytes bytes) {
  std::vector<std::uint8_t> result;
  while (result.size() < bytes.size()) {
    const Bytes part =
        bytes.subspan(result.size()).first(std::min(most_at_once, bytes.size() - result.size()));
    if (::write(in, part.data(), part.size()) != static_cast<ssize_t>(part.size()))
      throw std::system_error(errno, std::generic_category(), "writing to a link");
    const std::size_t wanted = result.size() + part.size();
    while (result.size() < wanted) {
      pollfd ready{out, POLLIN, 0};
      if (::poll(&ready, 1, patience_ms) <= 0) throw std::runtime_error("a link does not pass bytes on");
      std::array<std::uint8_t, most_at_once> read{};
      const ssize_t count = ::read(out, read.data(), wanted - result.size());
      if (count <= 0) throw std::runtime_error("a link broke");
      result.insert(result.end(), read.begin(), read.begin() + count);
    }
  }
  return result;
}

class TerminalCarrier final : public Carrier {
 public:
  TerminalCarrier() : terminal_(open_pseudo_terminal()) {}
  TerminalCarrier(const TerminalCarrier&) = delete;
  TerminalCarrier& operator=(const TerminalCarrier&) = delete;
  ~TerminalCarrier() override {
    ::close(terminal_.near_side);
    ::close(terminal_.far_side);
  }
  std::vector<std::uint8_t> carry(Direction direction, Bytes bytes) override {
    return direction == Direction::to_b ? pass(terminal_.near_side, terminal_.far_side, bytes)
                                        : pass(terminal_.far_side, terminal_.near_side, bytes);
  }

 private:
  PseudoTerminal terminal_;
};

class TcpCarrier final : public Carrier {
 public:
  TcpCarrier() : a_(context_), b_(context_) {
    tcp::acceptor acceptor(context_, {asio::ip::address_v4::loopback(), 0});
    a_.connect(acceptor.local_endpoint());
    acceptor.accept(b_);
    a_.set_option(tcp::no_delay(true));
    b_.set_option(tcp::no_delay(true));
  }
  std::vector<std::uint8_t> carry(Direction direction, Bytes bytes) override {
    return direction == Direction::to_b ? pass(a_.native_handle(), b_.native_handle(), bytes)
                                        : pass(b_.native_handle(), a_.native_handle(), bytes);
  }

 private:
  asio::io_context context_;
  tcp::socket a_;
  tcp::socket b_;
};

}  // namespace

std::unique_ptr<Carrier> pseudo_terminal_carrier() {
  return std::make_unique<TerminalCarrier>();
}

std::unique_ptr<Carrier> tcp_carrier() {
  return std::make_unique<TcpCarrier>();
}

}  // namespace pal::runtime::drivers
