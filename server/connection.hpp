// One client with its socket: what both protocols share.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <string>

#include "server/outbox.hpp"
#include "server/session.hpp"

namespace pal::server {

/// What clients need of the server.
struct ConnectionContext {
  boost::asio::io_context& io;
  SessionContext& context;
  OutboxLimits outbox;
  std::chrono::milliseconds admit_within, idle;
};

/// Lives as long as an operation on its socket runs, or the server holds it.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  explicit Connection(ConnectionContext& connection_context)
      : context_(connection_context), outbox_(connection_context.outbox), admission_(connection_context.io) {}
  virtual ~Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  virtual void start() = 0;
  bool gone() const { return gone_; }
  /// It has not shown the token yet, and goes when newcomers need its place. A line that stays never does.
  virtual bool may_be_dropped() const { return !session_ || !session_->admitted(); }
  Session* session() { return session_.get(); }
  /// So many samples that it wanted were left out before they came here.
  void lose(std::uint64_t samples) {
    if (session_ && (session_->looks() || session_->watches_channels())) outbox_.lose(samples);
  }
  /// The server ends: the client is told, after all that waits for it.
  void end() {
    if (gone_ || closing_) return;
    ends_ = true;
    reason_ = "the server ends";
    closing_ = true;
    pump();
  }
  /// The client has gone, or must. Not from inside its session.
  void leave() {
    if (gone_) return;
    gone_ = true;
    admission_.cancel();
    session_.reset();
    cut();
  }

 protected:
  /// Cuts the connection at once.
  virtual void cut() = 0;
  /// Starts the write of a message; written() when it is done.
  virtual void write(const OutgoingMessage& message) = 0;
  /// All has been said that was to be said before hanging up.
  virtual void close() = 0;

  SessionOutput output() {
    return {[this](std::string text) { say(std::move(text)); },
            [this](LiveMessage message) {
              outbox_.put_sample(std::move(message));
              pump();
            },
            [this](std::string reason) {
              reason_ = std::move(reason);
              closing_ = true;
              pump();
            }};
  }
  void admit_soon() {
    admission_.expires_after(context_.admit_within);
    admission_.async_wait([weak = weak_from_this()](const boost::system::error_code& problem) {
      const auto self = weak.lock();
      if (!problem && self && self->session_ && !self->session_->admitted()) self->leave();
    });
  }
  void written(bool well) {
    writing_ = false;
    if (well) {
      pump();
    } else {
      leave();
    }
  }
  /// It has not read for so long that something would be left out.
  virtual void overflow() { leave(); }
  void forget_what_waits() { outbox_ = Outbox(context_.outbox); }
  bool closing() const { return closing_; }
  /// Why it is closing, in a few words.
  const std::string& reason() const { return reason_; }
  /// … because the server ends.
  bool ends() const { return ends_; }
  /// After close(): the next client may come by the same line.
  void stay_open() { closing_ = false; }

  ConnectionContext& context_;
  std::unique_ptr<Session> session_;

 private:
  void say(std::string text) {
    if (closing_) return;
    if (outbox_.put(std::move(text))) return pump();
    // Not from inside the session, which is at work.
    boost::asio::post(context_.io, [self = shared_from_this()] { self->overflow(); });
  }
  void pump() {
    if (writing_ || gone_) return;
    if (auto message = outbox_.take()) {
      writing_ = true;
      current_ = std::move(*message);
      write(current_);
    } else if (closing_) {
      close();
    }
  }

  Outbox outbox_;
  boost::asio::steady_timer admission_;
  OutgoingMessage current_;
  std::string reason_;
  bool writing_ = false, closing_ = false, gone_ = false, ends_ = false;
};

using ConnectionPointer = std::shared_ptr<Connection>;

}  // namespace pal::server
