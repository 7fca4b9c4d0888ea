#include "server/client.hpp"

#include <fmt/format.h>

#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <nlohmann/json.hpp>

namespace pal::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using Json = nlohmann::ordered_json;

// Of an answer: a skill may last.
constexpr std::chrono::hours patience{24};

/// With the place and the way out in its text.
RemoteError remote_error(const Json& error) {
  std::string text = error.value("message", std::string());
  const Json data = error.value("data", Json::object());
  const Json place = data.value("place", Json::object());
  if (place.contains("file") && place.contains("line"))
    text = fmt::format("{}:{}:{}: {}", place.value("file", std::string()), place.value("line", 0),
                       place.value("column", 0), text);
  if (const std::string hint = data.value("hint", std::string()); !hint.empty()) text += "; " + hint;
  return {error.value("code", 0), text};
}

}  // namespace

struct Client::Parts {
  asio::io_context io;
  websocket::stream<beast::tcp_stream> stream{io};
  beast::flat_buffer buffer;
  bool reading = false;
  std::optional<beast::error_code> read;  // how the read ended
  std::deque<Json> notifications;
  int last_id = 0;
};

Client::Client(const std::string& address, std::uint16_t port, const std::string& origin)
    : parts_(std::make_unique<Parts>()) {
  auto& stream = parts_->stream;
  const std::string host = fmt::format("{}:{}", address, port);
  try {
    beast::get_lowest_layer(stream).connect({asio::ip::make_address(address), port});
    beast::get_lowest_layer(stream).socket().set_option(asio::ip::tcp::no_delay(true));
    stream.read_message_max(std::size_t{64} << 20);
    stream.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
      if (!origin.empty()) request.set(beast::http::field::origin, origin);
    }));
    websocket::response_type response;
    beast::error_code problem;
    stream.handshake(response, host, "/", problem);
    if (problem == websocket::error::upgrade_declined && !response.body().empty()) {
      std::string said = response.body();  // "…\n"
      said.erase(said.find_last_not_of(".\r\n") + 1);
      throw std::runtime_error(fmt::format("{}: {}", host, said));
    }
    if (problem) throw boost::system::system_error(problem);
    stream.text(true);
  } catch (const boost::system::system_error& problem) {
    throw std::runtime_error(fmt::format("{}: {}", host, problem.code().message()));
  }
}

Client::~Client() {
  beast::error_code ignored;
  beast::get_lowest_layer(parts_->stream).socket().close(ignored);
}

void Client::send(const std::string& message) {
  std::optional<beast::error_code> written;
  parts_->stream.async_write(asio::buffer(message),
                             [&](beast::error_code problem, std::size_t) { written = problem; });
  parts_->io.restart();
  while (!written) parts_->io.run_one();
  if (*written) throw std::runtime_error("the server has hung up: " + written->message());
}

std::optional<std::string> Client::receive(std::chrono::milliseconds longest) {
  if (!parts_->reading) {
    parts_->reading = true;
    parts_->read.reset();
    parts_->stream.async_read(parts_->buffer,
                              [this](beast::error_code problem, std::size_t) { parts_->read = problem; });
  }
  parts_->io.restart();
  const auto end = std::chrono::steady_clock::now() + longest;
  while (!parts_->read && parts_->io.run_one_until(end) > 0) {
  }
  if (!parts_->read) return std::nullopt;
  parts_->reading = false;
  if (*parts_->read) {
    const auto& reason = parts_->stream.reason().reason;
    throw std::runtime_error("the server has hung up: " + (reason.empty()
                                                               ? parts_->read->message()
                                                               : std::string(reason.data(), reason.size())));
  }
  std::string text = beast::buffers_to_string(parts_->buffer.data());
  parts_->buffer.clear();
  return text;
}

std::string Client::call(const std::string& method, const std::string& parameters) {
  const int id = ++parts_->last_id;
  const Json request{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", Json::parse(parameters)}};
  send(request.dump());
  for (;;) {
    const auto text = receive(patience);
    if (!text) throw std::runtime_error("the server does not answer");
    Json message = Json::parse(*text, nullptr, false);
    if (!message.is_object()) throw std::runtime_error("the server does not speak JSON-RPC");
    if (!message.contains("id")) {
      parts_->notifications.push_back(std::move(message));
    } else if (message["id"].is_null() || message["id"] == id) {
      if (message.contains("error")) throw remote_error(message["error"]);
      return message["result"].dump();
    }
  }
}

std::optional<std::string> Client::next(std::chrono::milliseconds longest) {
  if (!parts_->notifications.empty()) {
    const std::string text = parts_->notifications.front().dump();
    parts_->notifications.pop_front();
    return text;
  }
  return receive(longest);
}

}  // namespace pal::server
