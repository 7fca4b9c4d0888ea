#include "server/outbox.hpp"

#include <utility>

namespace pal::server {

bool Outbox::put(std::string text) {
  if (bytes_ + text.size() > limits_.most_bytes) return false;
  bytes_ += text.size();
  texts_.push_back(std::move(text));
  return true;
}

void Outbox::put_sample(LiveMessage message) {
  if (samples_.size() >= limits_.most_samples) {
    dropped_ += samples_.front().samples;
    samples_.pop_front();
  }
  samples_.push_back(std::move(message));
}

std::optional<OutgoingMessage> Outbox::take() {
  if (!texts_.empty()) {
    std::string text = std::move(texts_.front());
    texts_.pop_front();
    bytes_ -= text.size();
    return OutgoingMessage{std::move(text)};
  }
  if (samples_.empty()) return std::nullopt;
  const LiveMessage message = std::move(samples_.front());
  samples_.pop_front();
  return OutgoingMessage{message.make(dropped_), message.binary};
}

}  // namespace pal::server
