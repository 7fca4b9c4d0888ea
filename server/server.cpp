#include "server/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/write.hpp>
#include <condition_variable>
#include <csignal>
#include <deque>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <vector>

#include "server/connections.hpp"
#include "server/terminal.hpp"

namespace pal::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

// What may wait for the server's thread: it takes what waits in one go, so only events for which no time
// passes fill it.
constexpr std::size_t most_waiting = 10'000;
constexpr std::size_t most_samples = 64;

tcp::acceptor listen_at(asio::io_context& io, const std::string& address, std::uint16_t port) {
  error_code problem;
  const auto where = asio::ip::make_address(address == "localhost" ? "127.0.0.1" : address, problem);
  if (problem) throw std::runtime_error(fmt::format("'{}' is no address", address));
  tcp::acceptor acceptor(io);
  const tcp::endpoint endpoint(where, port);
  acceptor.open(endpoint.protocol(), problem);
  if (!problem) acceptor.set_option(asio::socket_base::reuse_address(true), problem);
  if (!problem) acceptor.bind(endpoint, problem);
  if (!problem) acceptor.listen(asio::socket_base::max_listen_connections, problem);
  if (problem) throw std::runtime_error(fmt::format("{}:{}: {}", address, port, problem.message()));
  return acceptor;
}

/// To a client by lines for which there is no room: 50 characters after the '!', as every refusal.
constexpr std::string_view no_room = "!the server has as many clients as it takes       \r\n";

/// What another thread leaves for the server's.
struct Waiting {
  std::vector<Event> events;
  std::deque<std::shared_ptr<const Telemetry>> telemetry;
  std::deque<std::pair<Duration, std::shared_ptr<const Profile>>> profiles;
  std::uint64_t lost = 0;  // samples of either
};

}  // namespace

struct Server::Parts {
  explicit Parts(ServerOptions the_options)
      : options(std::move(the_options)),
        web(listen_at(io, options.address, options.port)),
        signals(io),
        glance(io) {
    options.access.port = web.local_endpoint().port();
    if (options.line_port) lines.emplace(listen_at(io, options.address, *options.line_port));
    if (options.line_terminal) {
      OpenTerminal opened = open_pseudo_terminal();
      terminal.emplace(io, opened.descriptor);
      terminal_path = opened.path;
    }
    if (!options.line_serial.empty())
      serial.emplace(io, open_serial(options.line_serial, options.baud).descriptor);
  }

  void start(Desk& the_desk, bool with_signals) {
    desk = &the_desk;
    context.emplace(SessionContext{the_desk, history, options.token, [this](std::function<void()> action) {
                                     asio::post(io, std::move(action));
                                   }});
    connection_context.emplace(
        ConnectionContext{io, *context, options.outbox, options.admit_within, options.idle});
    if (with_signals) {
      signals.add(SIGINT);
      signals.add(SIGTERM);
      signals.async_wait([this](const error_code& problem, int) {
        if (!problem) desk->end();
      });
    }
    see_who_looks();
    accept_web();
    if (lines) accept_line();
    if (terminal) enter(line_connection(*connection_context, std::move(*terminal)));
    if (serial) enter(line_connection(*connection_context, std::move(*serial)));
    thread = std::thread([this] { io.run(); });
  }

  void stop() {
    if (!thread.joinable()) return;
    asio::post(io, [this] {
      error_code ignored;
      web.close(ignored);
      if (lines) lines->close(ignored);
      signals.cancel(ignored);
      for (const ConnectionPointer& client : clients) client->leave();
      io.stop();
    });
    thread.join();
    clients.clear();
  }

  void accept_web() {
    web.async_accept([this](const error_code& problem, tcp::socket socket) {
      if (problem == asio::error::operation_aborted) return;
      error_code ignored;
      // Answers are short, and a client waits for them.
      if (!problem) socket.set_option(tcp::no_delay(true), ignored);
      forget_gone();
      const std::size_t most = options.most_clients;
      // A client that is too many is told so, but not each of hundreds.
      if (!problem && clients.size() < 2 * most)
        enter(web_socket_connection(*connection_context, options.access, std::move(socket),
                                    clients.size() >= most));
      accept_web();
    });
  }
  void accept_line() {
    lines->async_accept([this](const error_code& problem, tcp::socket socket) {
      if (problem == asio::error::operation_aborted) return;
      error_code ignored;
      if (!problem) socket.set_option(asio::socket_base::keep_alive(true), ignored);
      forget_gone();
      if (!problem && clients.size() < options.most_clients) {
        enter(line_connection(*connection_context, std::move(socket)));
      } else if (!problem) {
        socket.non_blocking(true, ignored);
        asio::write(socket, asio::buffer(no_room), ignored);
      }
      accept_line();
    });
  }
  void forget_gone() {
    clients.erase(std::remove_if(clients.begin(), clients.end(),
                                 [](const ConnectionPointer& each) { return each->gone(); }),
                  clients.end());
  }
  void enter(const ConnectionPointer& client) {
    clients.push_back(client);
    client->start();
  }

  // In any thread.
  void leave(const std::function<void()>& add) {
    bool first = false;
    {
      const std::lock_guard lock(mutex);
      add();
      first = !std::exchange(called, true);
    }
    if (first) asio::post(io, [this] { take_what_waits(); });
  }

  void take_what_waits() {
    Waiting taken;
    {
      const std::lock_guard lock(mutex);
      taken = std::exchange(waiting, {});
      called = false;
    }
    room.notify_all();
    // By number: a session that leaves pauses what it ran, which is an event.
    for (const Event& event : taken.events) {
      history.add(event);
      for_each([&](Session& session) { session.happened(event); });
    }
    for (const ConnectionPointer& client : clients) client->lose(taken.lost);
    for (const auto& telemetry : taken.telemetry)
      for_each([&](Session& session) { session.show(telemetry); });
    for (const auto& [time, profile] : taken.profiles)
      for_each([&, when = time, what = profile](Session& session) { session.show(when, what); });
  }
  void see_who_looks() {
    bool looks = false;
    for_each([&](const Session& session) { looks = looks || session.looks(); });
    looked_at = looks;
    glance.expires_after(std::chrono::milliseconds(50));
    glance.async_wait([this](const error_code& problem) {
      if (!problem) see_who_looks();
    });
  }
  template <class Use>
  void for_each(const Use& use) {
    for (const ConnectionPointer& client : clients)
      if (Session* session = client->session()) use(*session);
  }

  ServerOptions options;
  asio::io_context io;
  tcp::acceptor web;
  std::optional<tcp::acceptor> lines;
  std::optional<asio::posix::stream_descriptor> terminal, serial;
  std::string terminal_path;
  asio::signal_set signals;
  asio::steady_timer glance;
  Desk* desk = nullptr;
  History history;
  std::optional<SessionContext> context;
  std::optional<ConnectionContext> connection_context;
  std::vector<ConnectionPointer> clients;
  std::thread thread;

  std::mutex mutex;
  std::condition_variable room;
  Waiting waiting;
  bool called = false;  // take_what_waits() will run
  std::atomic<bool> looked_at = false;
};

Server::Server(ServerOptions options) : parts_(std::make_unique<Parts>(std::move(options))) {}

Server::~Server() {
  stop();
}

void Server::start(Desk& desk, bool signals) {
  parts_->start(desk, signals);
}

void Server::stop() {
  parts_->stop();
}

std::uint16_t Server::port() const {
  return static_cast<std::uint16_t>(parts_->options.access.port);
}

std::optional<std::uint16_t> Server::line_port() const {
  if (!parts_->lines) return std::nullopt;
  return parts_->lines->local_endpoint().port();
}

const std::string& Server::terminal() const {
  return parts_->terminal_path;
}

void Server::happened(const Event& event) {
  parts_->leave([&] { parts_->waiting.events.push_back(event); });
}

void Server::make_room() {
  std::unique_lock lock(parts_->mutex);
  // A server that ends takes nothing any more.
  parts_->room.wait_for(lock, std::chrono::seconds(1),
                        [this] { return parts_->waiting.events.size() < most_waiting; });
}

bool Server::wanted() const noexcept {
  return parts_->looked_at.load(std::memory_order_relaxed);
}

void Server::show(const Telemetry& telemetry) {
  parts_->leave([&] {
    auto& samples = parts_->waiting.telemetry;
    samples.push_back(std::make_shared<Telemetry>(telemetry));
    if (samples.size() <= most_samples) return;
    samples.pop_front();
    ++parts_->waiting.lost;
  });
}

void Server::show(Duration time, const Profile& profile) {
  parts_->leave([&] {
    auto& samples = parts_->waiting.profiles;
    samples.emplace_back(time, std::make_shared<Profile>(profile));
    if (samples.size() <= most_samples) return;
    samples.pop_front();
    ++parts_->waiting.lost;
  });
}

}  // namespace pal::server
