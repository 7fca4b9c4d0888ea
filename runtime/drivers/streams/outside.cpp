#include "runtime/drivers/streams/outside.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/serial_port.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

#include "runtime/drivers/streams/pseudo_terminal.hpp"

namespace pal::runtime::drivers {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr auto longest_wait = std::chrono::milliseconds(50);

[[noreturn]] void refuse(const std::string& what, const error_code& why) {
  throw std::runtime_error(what + ": " + why.message());
}

}  // namespace

struct Outside::Parts {
  explicit Parts(double speed) : factor(speed) {}

  /// Station time by the wall clock, never past the instant that is waited for.
  Time station_now() const {
    const auto passed = std::chrono::duration<double, std::nano>(Clock::now() - wall_origin) * factor;
    return std::min(station_origin + std::chrono::duration_cast<Time>(passed), waited_for);
  }

  asio::io_context context;
  double factor;
  std::optional<Clock::time_point> begun;
  Clock::time_point wall_origin{};
  Time station_origin{};
  Time waited_for{};
  std::optional<Time> arrived;
};

namespace {

/// Reads from an Asio stream for as long as it lives.
template <class Stream>
class StreamLink : public OutsideLink {
 public:
  StreamLink(Outside::Parts& outside, Timeline& timeline, Stream stream, std::string address)
      : outside_(outside), timeline_(timeline), stream_(std::move(stream)), address_(std::move(address)) {}
  StreamLink(const StreamLink&) = delete;
  StreamLink& operator=(const StreamLink&) = delete;
  ~StreamLink() override {
    timeline_.cancel(delivery_);
    *alive_ = false;
  }

  const std::string& address() const override { return address_; }
  void connect(LinkUser* user) override { user_ = user; }
  void write(Bytes bytes) override {
    error_code problem;
    while (!bytes.empty()) {
      const std::size_t sent = stream_.write_some(asio::buffer(bytes.data(), bytes.size()), problem);
      if (problem) return;  // full: lost. Broken: the read says so.
      bytes = bytes.subspan(sent);
    }
  }

  void begin() {
    stream_.non_blocking(true);
    read();
  }

 protected:
  Stream& stream() { return stream_; }
  void read() {
    stream_.async_read_some(asio::buffer(buffer_),
                            [this, alive = alive_](error_code problem, std::size_t count) {
                              if (!*alive || problem == asio::error::operation_aborted) return;
                              if (problem) {
                                ended(problem.message());
                                return;
                              }
                              came_in({buffer_.data(), count});
                              read();
                            });
  }
  void came_in(Bytes bytes) {
    inbox_.insert(inbox_.end(), bytes.begin(), bytes.end());
    schedule();
  }
  virtual void ended(const std::string& why) {
    broken_ = why;
    schedule();
  }

 private:
  // In the timeline, so that the user meets the station's clock at the instant of the stamp.
  void schedule() {
    const Time stamp = std::max(timeline_.now(), outside_.station_now());
    outside_.arrived = std::min(outside_.arrived.value_or(stamp), stamp);
    timeline_.cancel(delivery_);
    delivery_ = timeline_.at(stamp, [this] { deliver(); });
  }
  void deliver() {
    const auto bytes = std::exchange(inbox_, {});
    const auto broken = std::exchange(broken_, std::nullopt);
    if (user_ != nullptr && !bytes.empty()) user_->on_bytes(bytes);
    if (user_ != nullptr && broken) user_->on_break(*broken);
  }

  Outside::Parts& outside_;
  Timeline& timeline_;
  Stream stream_;
  std::string address_;
  LinkUser* user_ = nullptr;
  std::array<std::uint8_t, 4096> buffer_{};
  std::vector<std::uint8_t> inbox_;
  std::optional<std::string> broken_;
  Timeline::Token delivery_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

/// Holds the far side open, so that programs may come and go.
class TerminalLink final : public StreamLink<asio::posix::stream_descriptor> {
 public:
  TerminalLink(Outside::Parts& outside, Timeline& timeline, const PseudoTerminal& terminal)
      : StreamLink(outside, timeline, asio::posix::stream_descriptor(outside.context, terminal.near_side),
                   terminal.path),
        far_side_(terminal.far_side) {}
  ~TerminalLink() override { ::close(far_side_); }

 private:
  int far_side_;
};

/// One program after the other.
class ServerLink final : public StreamLink<tcp::socket> {
 public:
  ServerLink(Outside::Parts& outside, Timeline& timeline, tcp::acceptor acceptor)
      : StreamLink(outside, timeline, tcp::socket(outside.context),
                   "127.0.0.1:" + std::to_string(acceptor.local_endpoint().port())),
        acceptor_(std::move(acceptor)) {
    accept();
  }
  ~ServerLink() override { *listening_ = false; }

 private:
  void accept() {
    acceptor_.async_accept([this, listening = listening_](error_code problem, tcp::socket socket) {
      if (!*listening || problem) return;
      stream() = std::move(socket);
      stream().set_option(tcp::no_delay(true));
      begin();
    });
  }
  void ended(const std::string& why) override {
    error_code ignored;
    stream().close(ignored);
    StreamLink::ended(why);
    accept();
  }

  tcp::acceptor acceptor_;
  std::shared_ptr<bool> listening_ = std::make_shared<bool>(true);
};

}  // namespace

Outside::Outside(double factor) : parts_(std::make_unique<Parts>(factor)) {}

Outside::~Outside() = default;

Time Outside::wait_until(Time when) {
  Parts& p = *parts_;
  if (!p.begun) {  // the clocks are set alike at the first wait
    p.begun = p.wall_origin = Clock::now();
    p.station_origin = p.waited_for;
  }
  const Time from = p.station_now();
  const auto real = std::chrono::duration<double, std::nano>(
      static_cast<double>((when - p.station_origin).count()) / p.factor);
  const bool far = when == Timeline::never || real > std::chrono::hours(1000);
  const Clock::time_point soon = Clock::now() + longest_wait;
  const Clock::time_point due =
      far ? soon : p.wall_origin + std::chrono::duration_cast<Clock::duration>(real);
  const bool whole = due <= soon;
  p.waited_for = when;
  p.arrived.reset();
  asio::steady_timer timer(p.context, std::min(due, soon));
  bool over = false;
  timer.async_wait([&over](error_code) { over = true; });
  p.context.restart();
  p.context.poll();  // also when time is short
  while (!over && !p.arrived) p.context.run_one();
  timer.cancel();
  while (!over) p.context.run_one();
  if (p.arrived) return std::min(*p.arrived, when);
  return whole ? when : std::clamp(p.station_now(), std::min(from, when), when);
}

void Outside::resumed(Time now) {
  parts_->begun = parts_->wall_origin = Clock::now();
  parts_->station_origin = now;
}

void Outside::wake() {
  asio::post(parts_->context, [parts = parts_.get()] {
    const Time now = parts->station_now();
    parts->arrived = std::min(parts->arrived.value_or(now), now);
  });
}

std::unique_ptr<OutsideLink> Outside::open_pseudo_terminal(Timeline& timeline) {
  auto link = std::make_unique<TerminalLink>(*parts_, timeline, runtime::drivers::open_pseudo_terminal());
  link->begin();
  return link;
}

std::unique_ptr<OutsideLink> Outside::listen_tcp(Timeline& timeline, std::uint16_t port) {
  error_code problem;
  tcp::acceptor acceptor(parts_->context);
  const tcp::endpoint here(asio::ip::address_v4::loopback(), port);
  acceptor.open(here.protocol(), problem);
  if (!problem) acceptor.set_option(tcp::acceptor::reuse_address(true), problem);
  if (!problem) acceptor.bind(here, problem);
  if (!problem) acceptor.listen(1, problem);
  if (problem) refuse("listening on TCP port " + std::to_string(port), problem);
  return std::make_unique<ServerLink>(*parts_, timeline, std::move(acceptor));
}

std::unique_ptr<OutsideLink> Outside::connect_tcp(Timeline& timeline, const std::string& host,
                                                  std::uint16_t port) {
  const std::string address = host + ":" + std::to_string(port);
  error_code problem;
  tcp::socket socket(parts_->context);
  tcp::resolver resolver(parts_->context);
  const auto found = resolver.resolve(host, std::to_string(port), problem);
  if (problem) refuse("looking up " + address, problem);
  for (const auto& entry : found) {
    error_code ignored;
    socket.close(ignored);
    socket.connect(entry.endpoint(), problem);
    if (!problem) break;
  }
  if (problem) refuse("connecting to " + address, problem);
  socket.set_option(tcp::no_delay(true));
  auto link = std::make_unique<StreamLink<tcp::socket>>(*parts_, timeline, std::move(socket), address);
  link->begin();
  return link;
}

std::unique_ptr<OutsideLink> Outside::open_serial(Timeline& timeline, const std::string& path,
                                                  unsigned baud) {
  using Port = asio::serial_port;
  error_code problem;
  Port port(parts_->context);
  port.open(path, problem);
  if (!problem) port.set_option(Port::baud_rate(baud), problem);
  if (!problem) port.set_option(Port::character_size(8), problem);
  if (!problem) port.set_option(Port::parity(Port::parity::none), problem);
  if (!problem) port.set_option(Port::stop_bits(Port::stop_bits::one), problem);
  if (!problem) port.set_option(Port::flow_control(Port::flow_control::none), problem);
  if (problem) refuse("opening serial port " + path, problem);
  // As a plain descriptor, whose writes may be told not to wait.
  const int descriptor = ::dup(port.native_handle());
  if (descriptor < 0) throw std::runtime_error("opening serial port " + path + ": no more descriptors");
  auto link = std::make_unique<StreamLink<asio::posix::stream_descriptor>>(
      *parts_, timeline, asio::posix::stream_descriptor(parts_->context, descriptor), path);
  link->begin();
  return link;
}

}  // namespace pal::runtime::drivers
