// A client that speaks lines, at a socket.
#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>

#include "server/connections.hpp"

namespace pal::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

template <class Stream>
class LineConnection final : public Connection {
 public:
  // A socket goes with its client, a terminal stays.
  static constexpr bool stays = std::is_same_v<Stream, asio::posix::stream_descriptor>;

  LineConnection(ConnectionContext& connection_context, Stream stream)
      : Connection(connection_context), stream_(std::move(stream)), again_(connection_context.io) {}

  bool may_be_dropped() const override { return !stays && Connection::may_be_dropped(); }
  void start() override {
    begin_session();
    read();
  }

 private:
  void cut() override {
    again_.cancel();
    error_code ignored;
    stream_.close(ignored);
  }
  std::shared_ptr<LineConnection> here() {
    return std::static_pointer_cast<LineConnection>(shared_from_this());
  }

  void begin_session() {
    session_ = line_session(context_.context, output());
    if (!stays) admit_soon();
  }
  void read() {
    stream_.async_read_some(asio::buffer(bytes_), [self = here()](error_code problem, std::size_t count) {
      if (self->gone()) return;
      if (!problem) {
        if (self->session_ && !self->closing()) self->session_->take({self->bytes_.data(), count});
        return self->read();
      }
      if (stays && problem != asio::error::operation_aborted) return self->wait_for_another();
      self->leave();
    });
  }
  /// No program has the far end of the terminal open.
  void wait_for_another() {
    session_.reset();
    begin_session();
    again_.expires_after(std::chrono::milliseconds(100));
    again_.async_wait([self = here()](error_code problem) {
      if (!problem && !self->gone()) self->read();
    });
  }
  void write(const OutgoingMessage& message) override {
    asio::async_write(stream_, asio::buffer(message.text), [self = here()](error_code problem, std::size_t) {
      // What is not read at a terminal is lost.
      self->written(!problem || (stays && problem != asio::error::operation_aborted));
    });
  }
  void overflow() override {
    if (!stays) return leave();
    forget_what_waits();
    session_.reset();
    begin_session();
  }
  void close() override {
    asio::post(context_.io, [self = here()] {
      if (self->gone()) return;
      if (!stays || self->ends()) return self->leave();
      self->session_.reset();
      self->stay_open();
      self->begin_session();
    });
  }

  Stream stream_;
  asio::steady_timer again_;
  std::array<char, 4096> bytes_{};
};

}  // namespace

ConnectionPointer line_connection(ConnectionContext& connection_context, asio::ip::tcp::socket socket) {
  return std::make_shared<LineConnection<asio::ip::tcp::socket>>(connection_context, std::move(socket));
}

ConnectionPointer line_connection(ConnectionContext& connection_context,
                                  asio::posix::stream_descriptor line) {
  return std::make_shared<LineConnection<asio::posix::stream_descriptor>>(connection_context,
                                                                          std::move(line));
}

}  // namespace pal::server
