#include "sim/report/message_log.hpp"

#include <algorithm>
#include <cstring>

namespace pal::sim {
namespace {

/// Before the fields of a message in the file.
struct Head {
  runtime::Time::rep time;
  std::size_t device, port, fields;
};

constexpr std::size_t bytes_at_a_time = 1U << 16U;

}  // namespace

MessageLog::MessageLog(trace::SpoolPlace place) : file_(std::make_shared<trace::SpoolFile>(place)) {}

void MessageLog::passed(runtime::Time when, const runtime::Device& device, std::size_t port,
                        std::span<const double> fields) {
  // A message without fields says nothing that the trace does not say.
  if (fields.empty()) return;
  const Head head{when.count(), number_of(device), port, fields.size()};
  record_.resize(sizeof head + fields.size_bytes());
  std::memcpy(record_.data(), &head, sizeof head);
  std::memcpy(record_.data() + sizeof head, fields.data(), fields.size_bytes());
  if (file_->append(record_.data(), record_.size())) ++size_;
}

void MessageLog::for_each(const std::function<void(const LoggedMessage&)>& see) const {
  Reader reader(*this);
  while (const LoggedMessage* message = reader.next()) see(*message);
}

const LoggedMessage* MessageLog::Reader::next() {
  Head head{};
  if (!take(&head, sizeof head)) return nullptr;
  message_.time = runtime::Time(head.time);
  message_.device = head.device;
  message_.port = head.port;
  message_.fields.resize(head.fields);
  return take(message_.fields.data(), head.fields * sizeof(double)) ? &message_ : nullptr;
}

/// False: the file has no more.
bool MessageLog::Reader::take(void* to, std::size_t count) {
  auto* place = static_cast<std::byte*>(to);
  while (count > 0) {
    if (taken_ == room_.size()) {
      room_.resize(bytes_at_a_time);
      room_.resize(log_.file_->read(offset_, room_.data(), room_.size()));
      offset_ += room_.size();
      taken_ = 0;
      if (room_.empty()) return false;
    }
    const std::size_t part = std::min(count, room_.size() - taken_);
    std::memcpy(place, room_.data() + taken_, part);
    place += part;
    taken_ += part;
    count -= part;
  }
  return true;
}

std::size_t MessageLog::number_of(const runtime::Device& device) {
  const auto found = std::find_if(devices_.begin(), devices_.end(),
                                  [&](const DeviceNames& known) { return known.name == device.name(); });
  if (found == devices_.end()) {
    devices_.push_back({device.name(), device.ports()});
    return devices_.size() - 1;
  }
  return static_cast<std::size_t>(found - devices_.begin());
}

}  // namespace pal::sim
