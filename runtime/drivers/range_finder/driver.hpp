// The driver of the range finder.
#pragma once

#include <string>
#include <vector>

#include "runtime/drivers/linked_driver.hpp"
#include "runtime/drivers/range_finder/codec.hpp"

namespace pal::runtime::drivers {

struct RangeFinderDriverOptions {
  std::string name = "range-finder";
  // How long the range finder may take before it is in trouble.
  Time start_within = std::chrono::seconds(2);
  Time profile_within = std::chrono::milliseconds(200);
};

/// Ports: `request profile` to the device; `profile` from it (x and z in mm, REAL[255]; valid, BOOLEAN[255];
/// taken, in ms of the run). The scan began at `taken`. A point that is not valid has x and z 0.
///
/// The mirror swings by itself, a scan every 78 ms. A request gets the next scan that begins, 76 ms after its
/// beginning. prepare() starts the range finder and discards its first profile. A missing or wrong profile is
/// a fault.
class RangeFinderDriver final : public LinkedDriver {
 public:
  RangeFinderDriver(Timeline& timeline, Link& link, RangeFinderDriverOptions options = {});

  void prepare() override;
  bool ready() const override { return step_ == Step::none; }
  void open() override {}
  void receive(std::size_t port, std::span<const double> fields) override;

 private:
  enum class Step { none, start, discard };

  void arrived(Bytes bytes) override;
  void give_up() override;
  std::string missing() const override;

  void ask();
  void started();
  void began();
  void complete();

  RangeFinderDriverOptions options_;
  range_finder::Codec codec_;
  Step step_ = Step::none;
  int asked_ = 0;  // requests that no scan has taken yet
  Time epoch_{};   // when the range finder's clock stood at 0, by the station's
  std::vector<double> fields_;
};

}  // namespace pal::runtime::drivers
