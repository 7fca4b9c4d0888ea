// A client at a WebSocket.
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <optional>

#include "server/connections.hpp"

namespace pal::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

constexpr std::size_t largest_header = 8192;
// Before the token only a hello is waited for.
constexpr std::size_t largest_hello = 1024;
constexpr std::size_t largest_message = (std::size_t{1} << 20) + 65536;

class WebSocketConnection final : public Connection {
 public:
  WebSocketConnection(ConnectionContext& connection_context, const AccessRules& rules, const PageFiles& files,
                      asio::ip::tcp::socket socket)
      : Connection(connection_context), rules_(rules), files_(files), stream_(std::move(socket)) {}

  void start() override {
    parser_.emplace();
    parser_->header_limit(largest_header);
    parser_->body_limit(std::uint64_t{0});
    beast::get_lowest_layer(stream_).expires_after(context_.admit_within);
    http::async_read(stream_.next_layer(), buffer_, *parser_,
                     [self = here()](beast::error_code problem, std::size_t) {
                       if (problem) return self->refuse(problem);
                       self->on_request();
                     });
  }

 private:
  void cut() override {
    beast::error_code ignored;
    beast::get_lowest_layer(stream_).socket().close(ignored);
  }
  std::shared_ptr<WebSocketConnection> here() {
    return std::static_pointer_cast<WebSocketConnection>(shared_from_this());
  }

  /// What is no request is told so; a client that has gone is not.
  void refuse(beast::error_code problem) {
    if (problem == http::error::header_limit)
      return respond(http::status::request_header_fields_too_large,
                     "The head of this request is too long.\n");
    if (problem == http::error::body_limit)
      return respond(http::status::payload_too_large,
                     "This is a WebSocket that talks JSON-RPC 2.0, and files.\n");
    if (problem.category() != http::make_error_code(http::error::bad_method).category() ||
        problem == http::error::end_of_stream || problem == http::error::partial_message)
      return leave();
    respond(http::status::bad_request, "This is no request of HTTP.\n");
  }
  void on_request() {
    const auto& request = parser_->get();
    const auto text = [](beast::string_view view) { return std::string_view(view.data(), view.size()); };
    if (!host_allowed(text(request[http::field::host]), rules_))
      return respond(http::status::forbidden, "This host is not allowed; --allow-host allows it.\n");
    if (!websocket::is_upgrade(request)) return send_file();
    if (!origin_allowed(text(request[http::field::origin]), rules_))
      return respond(http::status::forbidden, "This origin is not allowed; --allow-origin allows it.\n");
    beast::get_lowest_layer(stream_).expires_never();
    stream_.set_option(websocket::stream_base::timeout{context_.admit_within, context_.idle, true});
    stream_.read_message_max(largest_hello);
    stream_.text(true);
    stream_.async_accept(request, [self = here()](beast::error_code problem) {
      if (problem) return self->leave();
      self->parser_.reset();
      self->session_ = json_session(self->context_.context, self->output());
      self->admit_soon();
      self->read();
    });
  }
  void send_file() {
    const auto& request = parser_->get();
    const auto text = [](beast::string_view view) { return std::string(view.data(), view.size()); };
    if (request.method() != http::verb::get && request.method() != http::verb::head) {
      response_.set(http::field::allow, "GET, HEAD");
      return respond(http::status::method_not_allowed,
                     "This is a WebSocket that talks JSON-RPC 2.0, and files.\n");
    }
    const PageAnswer answer = files_.answer({text(request.target()), text(request[http::field::host]),
                                             text(request[http::field::accept_encoding]),
                                             text(request[http::field::if_none_match])});
    for (const auto& [name, value] : answer.fields) response_.set(name, value);
    response_.result(answer.status);
    response_.version(11);
    response_.keep_alive(false);
    response_.body() = request.method() == http::verb::head ? std::string() : answer.body;
    response_.content_length(answer.body.size());
    http::async_write(stream_.next_layer(), response_,
                      [self = here()](beast::error_code, std::size_t) { self->hang_up(); });
  }
  void hang_up() {
    beast::error_code ignored;
    beast::get_lowest_layer(stream_).socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    leave();
  }
  void respond(http::status status, std::string text) {
    response_.result(status);
    response_.version(11);
    response_.keep_alive(false);
    response_.set(http::field::content_type, "text/plain; charset=utf-8");
    response_.body() = std::move(text);
    response_.prepare_payload();
    http::async_write(stream_.next_layer(), response_,
                      [self = here()](beast::error_code, std::size_t) { self->leave(); });
  }

  void read() {
    buffer_.clear();
    stream_.async_read(buffer_, [self = here()](beast::error_code problem, std::size_t) {
      if (problem) return self->leave();
      if (!self->session_ || self->closing()) return;
      if (!self->stream_.got_text())
        return self->close(websocket::close_code::unknown_data, "send text, not bytes");
      const auto data = self->buffer_.cdata();
      self->session_->take({static_cast<const char*>(data.data()), data.size()});
      if (self->session_ && self->session_->admitted()) self->stream_.read_message_max(largest_message);
      // Also when it is closing: the other side's part of it is read.
      self->read();
    });
  }
  void write(const OutgoingMessage& message) override {
    stream_.binary(message.binary);
    stream_.async_write(asio::buffer(message.text),
                        [self = here()](beast::error_code problem, std::size_t) { self->written(!problem); });
  }
  void close() override {
    close(ends() ? websocket::close_code::going_away : websocket::close_code::policy_error, reason());
  }
  void close(websocket::close_code why, const std::string& words) {
    // From outside the session, which is at work.
    asio::post(context_.io, [self = here(), why, words] {
      if (self->gone() || std::exchange(self->closed_, true)) return;
      self->stream_.async_close({why, words}, [self](beast::error_code) { self->leave(); });
    });
  }
  const AccessRules& rules_;
  const PageFiles& files_;
  websocket::stream<beast::tcp_stream> stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  http::response<http::string_body> response_;
  bool closed_ = false;
};

}  // namespace

ConnectionPointer web_socket_connection(ConnectionContext& connection_context, const AccessRules& rules,
                                        const PageFiles& files, boost::asio::ip::tcp::socket socket) {
  return std::make_shared<WebSocketConnection>(connection_context, rules, files, std::move(socket));
}

}  // namespace pal::server
