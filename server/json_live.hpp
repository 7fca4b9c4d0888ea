// Live data for one client of the JSON protocol: what it watches, and the messages of it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/channels.hpp"
#include "server/json_requests.hpp"
#include "server/session.hpp"

namespace pal::server {

class LiveView {
 public:
  using Clock = std::function<std::chrono::steady_clock::time_point()>;

  /// The output outlives it. `channels`: those that the cell has; null: none.
  /// `latest`: the last rows of each channel that has such; null: they are not known.
  LiveView(const SessionOutput& output, const Channels* channels,
           const std::map<std::string, std::shared_ptr<const Rows>>* latest = nullptr,
           Clock clock = std::chrono::steady_clock::now)
      : output_(output), channels_(channels), latest_(latest), clock_(std::move(clock)) {}

  /// At most every so much time of the cell; zero: no telemetry.
  void watch_telemetry(Duration period);
  /// As the schema's params of channels.watch, in place of what was watched before. Throws Problem.
  void watch_channels(const Members& members);

  bool looks() const { return period_ > Duration::zero(); }
  bool watches_channels() const { return !watched_.empty(); }

  void show(const std::shared_ptr<const Telemetry>& telemetry);
  void show(Duration time, const std::shared_ptr<const Profile>& profile);
  void show(const ShownBlock& block);
  void show(const std::shared_ptr<const Rows>& rows);
  /// Sends the last rows of what is watched: the cell may stand, and no others come.
  void begin();
  /// Sends rows that were left out, if none have come behind them.
  void catch_up();

 private:
  struct Watched {
    std::size_t channel = 0;
    bool binary = false;
    Duration period{};
    Decimator decimator;
    Duration due{};  // of a profile, of rows
    // Of rows.
    std::chrono::steady_clock::time_point due_on_the_wall{}, came{};
    std::shared_ptr<const Rows> late{};
  };

  void send(Watched& watched, const std::shared_ptr<const Rows>& rows);
  /// How long spans are at the least, lest there be more bytes than a client is given in a second.
  Duration least_span(double pace) const;

  const SessionOutput& output_;
  const Channels* channels_;
  const std::map<std::string, std::shared_ptr<const Rows>>* latest_;
  Clock clock_;
  Duration period_{}, due_{};
  std::vector<Watched> watched_;
};

/// As the schema's Channel.
Json describe(const Channel& channel);

}  // namespace pal::server
