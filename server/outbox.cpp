#include "server/outbox.hpp"

#include <utility>

namespace pal::server {

bool Outbox::put(std::string text) {
  if (bytes_ + text.size() > limits_.most_bytes) return false;
  bytes_ += text.size();
  texts_.push_back(std::move(text));
  return true;
}

void Outbox::put_sample(Sample sample) {
  if (samples_.size() >= limits_.most_samples) {
    samples_.pop_front();
    ++dropped_;
  }
  samples_.push_back(std::move(sample));
}

std::optional<std::string> Outbox::take() {
  if (!texts_.empty()) {
    std::string text = std::move(texts_.front());
    texts_.pop_front();
    bytes_ -= text.size();
    return text;
  }
  if (samples_.empty()) return std::nullopt;
  const Sample sample = std::move(samples_.front());
  samples_.pop_front();
  return sample(dropped_);
}

}  // namespace pal::server
