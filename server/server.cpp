#include "server/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <condition_variable>
#include <csignal>
#include <deque>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "server/connections.hpp"
#include "server/json_events.hpp"
#include "server/terminal.hpp"
#include "server/urgency.hpp"

namespace pal::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

// What may wait for the server's thread: it takes what waits in one go, so only events for which no time
// passes fill it.
constexpr std::size_t most_waiting = 10'000;
constexpr std::size_t most_samples = 64;
constexpr std::size_t most_blocks = 64;
constexpr std::size_t most_rows = 256;
// Records, so that requests come in between.
constexpr std::size_t records_at_once = 80;

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

/// What another thread leaves for the server's.
struct Waiting {
  std::vector<Event> events;
  std::deque<std::shared_ptr<const Telemetry>> telemetry;
  std::deque<std::pair<Duration, std::shared_ptr<Profile>>> profiles;
  std::deque<std::shared_ptr<const SampleBlock>> blocks;
  std::deque<std::shared_ptr<const Rows>> rows;
  std::uint64_t lost = 0;  // samples of all these
};

}  // namespace

struct Server::Parts {
  explicit Parts(ServerOptions the_options)
      : options(std::move(the_options)),
        web(listen_at(io, options.address, options.port)),
        signals(io),
        glance(io),
        farewell(io),
        page_files(options.pages) {
    options.access.port = web.local_endpoint().port();
    if (options.line_port) {
      lines.emplace(listen_at(io, options.address, *options.line_port));
      // Once the server's thread runs, the acceptors are its own; so both ports are kept.
      options.line_port = lines->local_endpoint().port();
    }
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
    checks.emplace(true);
    disk.emplace(true);
    reading.emplace(true);
    studies.emplace(true);
    context.emplace(
        SessionContext{the_desk, history, options.tokens,
                       [this](std::function<void()> action) { asio::post(io, std::move(action)); }, *checks,
                       *disk, *reading});
    context->store = options.store;
    context->knowledge = options.knowledge;
    context->version = options.version;
    context->channels = &options.channels;
    context->runs = options.runs;
    context->studies = &*studies;
    context->trials = options.trials;
    context->scene = options.scene;
    context->recording = options.recording;
    context->latest = &latest;
    context->full = [this] {
      return count_of([](Session& each) { return !each.extra(); }) >= options.most_clients;
    };
    connection_context.emplace(
        ConnectionContext{io, *context, options.outbox, options.admit_within, options.idle});
    if (with_signals) {
      for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        struct sigaction before {};
        ::sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) signals.add(signal);
      }
      signals.async_wait([this](const error_code& problem, int) {
        if (!problem) desk->end();
      });
    }
    context->looks_otherwise = [this] { see_who_looks(); };
    look_around();
    accept_web();
    if (lines) accept_line();
    if (terminal) enter(line_connection(*connection_context, std::move(*terminal)));
    if (serial) enter(line_connection(*connection_context, std::move(*serial)));
    thread = std::thread([this] {
      answer_soon();
      io.run();
    });
  }

  void stop() {
    if (!thread.joinable()) return;
    asio::post(io, [this] {
      error_code ignored;
      web.close(ignored);
      if (lines) lines->close(ignored);
      signals.cancel(ignored);
      // The desk's end is an event, too, and the cell's thread may come here before it.
      take_what_waits();
      // Those that stand in a queue have been told what happened; a client that does not read does not keep
      // us.
      for (const ConnectionPointer& client : clients) client->end();
      goodbye_by = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
      wait_for_farewells();
    });
    thread.join();
    // What these do for a client that is not served any more is not wanted.
    checks.reset();
    disk.reset();
    reading.reset();
    studies.reset();
    clients.clear();
  }
  void wait_for_farewells() {
    forget_gone();
    if (clients.empty() || std::chrono::steady_clock::now() > goodbye_by) {
      for (const ConnectionPointer& client : clients) client->leave();
      return io.stop();
    }
    farewell.expires_after(std::chrono::milliseconds(5));
    farewell.async_wait([this](const error_code&) { wait_for_farewells(); });
  }

  void accept_web() {
    web.async_accept([this](const error_code& problem, tcp::socket socket) {
      if (problem == asio::error::operation_aborted) return;
      error_code ignored;
      // Answers are short, and a client waits for them.
      if (!problem) socket.set_option(tcp::no_delay(true), ignored);
      if (!problem) make_place();
      if (!problem)
        enter(web_socket_connection(*connection_context, options.access, page_files, std::move(socket)));
      accept_web();
    });
  }
  void accept_line() {
    lines->async_accept([this](const error_code& problem, tcp::socket socket) {
      if (problem == asio::error::operation_aborted) return;
      error_code ignored;
      if (!problem) socket.set_option(asio::socket_base::keep_alive(true), ignored);
      if (!problem) make_place();
      if (!problem) enter(line_connection(*connection_context, std::move(socket)));
      accept_line();
    });
  }
  /// Nobody keeps others out: clients that have shown no token go oldest first, and so do those that came
  /// when the places were taken.
  void make_place() {
    forget_gone();
    drop_oldest(options.most_unknown, [](Connection& each) { return each.may_be_dropped(); });
    drop_oldest(options.most_extra, [](Connection& each) {
      return each.session() != nullptr && each.session()->admitted() && each.session()->extra();
    });
  }
  template <class Which>
  void drop_oldest(std::size_t most, const Which& which) {
    std::size_t count = 0;
    for (const ConnectionPointer& each : clients) count += which(*each) ? 1U : 0U;
    for (const ConnectionPointer& each : clients) {
      if (count < most) break;
      if (!which(*each)) continue;
      each->leave();
      --count;
    }
    forget_gone();
  }
  template <class Which>
  std::size_t count_of(const Which& which) {
    std::size_t count = 0;
    for_each([&](Session& each) { count += each.admitted() && which(each) ? 1U : 0U; });
    return count;
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
      const std::string told = event_text(event);
      history.add(event.number, told);
      for_each([&](Session& session) { session.happened(event, told); });
    }
    show_blocks(taken.blocks);
    for (const ConnectionPointer& client : clients) client->lose(taken.lost);
    for (const auto& rows : taken.rows) {
      latest[rows->channel] = rows;
      for_each([&](Session& session) { session.show(rows); });
    }
    for (const auto& telemetry : taken.telemetry)
      for_each([&](Session& session) { session.show(telemetry); });
    for (const auto& [time, profile] : taken.profiles) {
      for (const Channel& channel : options.channels)
        if (channel.marks) profile->marks = channel.marks(*profile);
      for_each([&, when = time, what = profile](Session& session) { session.show(when, what); });
    }
  }
  /// The first ones; the others come behind what else waits for this thread.
  void show_blocks(std::deque<std::shared_ptr<const SampleBlock>>& blocks) {
    for (std::size_t records = 0; records < records_at_once && !blocks.empty();) {
      const ShownBlock shown(options.channels, std::move(blocks.front()));
      records += shown.block().size();
      blocks.pop_front();
      for_each([&](Session& session) { session.show(shown); });
    }
    if (blocks.empty()) return;
    leave([&] {
      std::uint64_t lost = 0;
      blocks.insert(blocks.end(), waiting.blocks.begin(), waiting.blocks.end());
      while (blocks.size() > most_blocks) {
        lost += blocks.front()->size();
        blocks.pop_front();
      }
      waiting.blocks = std::move(blocks);
      waiting.lost += lost;
    });
  }
  void see_who_looks() {
    bool looks = false, watches = false;
    for_each([&](const Session& session) {
      looks = looks || session.looks();
      watches = watches || session.watches_channels();
    });
    looked_at = looks;
    watched = watches;
  }
  /// Sessions come and go.
  void look_around() {
    see_who_looks();
    for_each([](Session& session) { session.catch_up(); });
    glance.expires_after(std::chrono::milliseconds(50));
    glance.async_wait([this](const error_code& problem) {
      if (!problem) look_around();
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
  asio::steady_timer glance, farewell;
  std::chrono::steady_clock::time_point goodbye_by{};
  PageFiles page_files;
  Desk* desk = nullptr;
  History history;
  std::map<std::string, std::shared_ptr<const Rows>> latest;  // by channel
  std::optional<Workshop> checks, disk, reading, studies;
  std::optional<SessionContext> context;
  std::optional<ConnectionContext> connection_context;
  std::vector<ConnectionPointer> clients;
  std::thread thread;

  std::mutex mutex;
  std::condition_variable room;
  Waiting waiting;
  bool called = false;  // take_what_waits() will run
  std::atomic<bool> looked_at = false, watched = false;
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
  return parts_->options.line_port;
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
  if (parts_->options.recording != nullptr) parts_->options.recording->take(time, profile);
  parts_->leave([&] {
    auto& samples = parts_->waiting.profiles;
    samples.emplace_back(time, std::make_shared<Profile>(profile));
    if (samples.size() <= most_samples) return;
    samples.pop_front();
    ++parts_->waiting.lost;
  });
}

bool Server::watched() const noexcept {
  return parts_->watched.load(std::memory_order_relaxed) ||
         (parts_->options.recording != nullptr && parts_->options.recording->records());
}

void Server::show(std::shared_ptr<const SampleBlock> block) {
  if (parts_->options.recording != nullptr) parts_->options.recording->take(block);
  parts_->leave([&] {
    auto& blocks = parts_->waiting.blocks;
    blocks.push_back(std::move(block));
    if (blocks.size() <= most_blocks) return;
    parts_->waiting.lost += blocks.front()->size();
    blocks.pop_front();
  });
}

void Server::show(std::vector<std::shared_ptr<const Rows>> rows) {
  if (parts_->options.recording != nullptr) parts_->options.recording->take(rows);
  parts_->leave([&] {
    auto& all = parts_->waiting.rows;
    all.insert(all.end(), rows.begin(), rows.end());
    while (all.size() > most_rows) {
      all.pop_front();
      ++parts_->waiting.lost;
    }
  });
}

}  // namespace pal::server
