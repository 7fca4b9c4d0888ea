#include "runtime/drivers/range_finder/driver.hpp"

#include <algorithm>
#include <utility>

namespace pal::runtime::drivers {
namespace {

using range_finder::Codec;
using range_finder::points;

constexpr std::size_t profile_request = 0;
constexpr std::size_t profile_port = 1;

std::vector<PortSpec> range_finder_ports() {
  return {{"request profile", true, {}},
          {"profile",
           false,
           {{"x", "mm", FieldKind::number, points},
            {"z", "mm", FieldKind::number, points},
            {"valid", "", FieldKind::number, points},
            {"taken", "ms"}}}};
}

}  // namespace

RangeFinderDriver::RangeFinderDriver(Timeline& timeline, Link& link, RangeFinderDriverOptions options)
    : LinkedDriver(timeline, link, options.name, range_finder_ports()),
      options_(std::move(options)),
      fields_(3 * points + 1) {}

void RangeFinderDriver::prepare() {
  try_again();
  step_ = Step::start;
  asked_ = 0;
  codec_.expect_ready();
  write(as_bytes("INIT\r"));
  await(options_.start_within);
}

void RangeFinderDriver::receive(std::size_t port, std::span<const double>) {
  if (port == profile_request) ask();
}

void RangeFinderDriver::ask() {
  if (asked_++ == 0) await(options_.profile_within);
  write(as_bytes("PROFILE\r"));
}

void RangeFinderDriver::arrived(Bytes bytes) {
  for (const std::uint8_t byte : bytes) {
    switch (codec_.feed(byte)) {
      case Codec::Event::none:
        break;
      case Codec::Event::garbled:
        return fail(codec_.problem());
      case Codec::Event::ready:
        started();
        break;
      case Codec::Event::began:
        began();
        break;
      case Codec::Event::profile:
        complete();
    }
    if (!trouble().empty()) return;
  }
}

void RangeFinderDriver::started() {
  // The line says when it began to leave.
  const Time line = range_finder::line.duration(std::string_view("READY 255 0000000000\r\n").size());
  epoch_ = timeline().now() - line - std::chrono::microseconds(codec_.ready_at());
  step_ = Step::discard;
  ask();
}

void RangeFinderDriver::began() {
  if (codec_.answers() > asked_) {
    return fail("sends a profile for " + std::to_string(codec_.answers()) + " requests, of which " +
                std::to_string(asked_) + " were made");
  }
  asked_ -= codec_.answers();
  await(options_.profile_within);
  if (host() == nullptr) return;
  for (int i = 0; i < codec_.answers(); ++i) host()->mark_busy(true);
}

void RangeFinderDriver::complete() {
  arrived_in_time();
  if (asked_ > 0) await(options_.profile_within);
  if (step_ == Step::discard) step_ = Step::none;  // the mirror was not yet at its full swing
  if (host() == nullptr) return;
  const range_finder::Profile& profile = codec_.profile();
  auto next = std::copy(profile.x.begin(), profile.x.end(), fields_.begin());
  next = std::copy(profile.z.begin(), profile.z.end(), next);
  next = std::copy(profile.valid.begin(), profile.valid.end(), next);
  const Time by_station = epoch_ + std::chrono::microseconds(profile.began);
  const Time taken = by_station - (timeline().now() - host()->now());
  *next = static_cast<double>(taken.count()) * 1e-6;
  host()->mark_busy(false);
  host()->deliver(profile_port, fields_);
}

std::string RangeFinderDriver::missing() const {
  if (step_ == Step::start) return "it was not ready after INIT";
  const std::string part = codec_.missing();
  return part.empty() ? "no profile came" : part;
}

void RangeFinderDriver::give_up() {
  step_ = Step::none;
  asked_ = 0;
}

}  // namespace pal::runtime::drivers
