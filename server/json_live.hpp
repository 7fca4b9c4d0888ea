// Live data for one client of the JSON protocol: what it watches, and the messages of it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "server/channels.hpp"
#include "server/json_requests.hpp"
#include "server/session.hpp"

namespace pal::server {

class LiveView {
 public:
  /// The output outlives it. `channels`: those that the cell has; null: none.
  LiveView(const SessionOutput& output, const Channels* channels) : output_(output), channels_(channels) {}

  /// At most every so much time of the cell; zero: no telemetry.
  void watch_telemetry(Duration period);
  /// As the schema's params of channels.watch, in place of what was watched before. Throws Problem.
  void watch_channels(const Members& members);

  bool looks() const { return period_ > Duration::zero(); }
  bool watches_channels() const { return !watched_.empty(); }

  void show(const std::shared_ptr<const Telemetry>& telemetry);
  void show(Duration time, const std::shared_ptr<const Profile>& profile);
  void show(const ShownBlock& block);

 private:
  struct Watched {
    std::size_t channel = 0;
    bool binary = false;
    Duration period{};
    Decimator decimator;
    Duration due{};  // of a profile
  };

  /// How long spans are at the least, lest there be more bytes than a client is given in a second.
  Duration least_span(double pace) const;

  const SessionOutput& output_;
  const Channels* channels_;
  Duration period_{}, due_{};
  std::vector<Watched> watched_;
};

/// As the schema's Channel.
Json describe(const Channel& channel);

}  // namespace pal::server
