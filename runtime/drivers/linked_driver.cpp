#include "runtime/drivers/linked_driver.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace pal::runtime::drivers {

LinkedDriver::LinkedDriver(Timeline& timeline, Link& link, std::string name, std::vector<PortSpec> ports)
    : timeline_(timeline), link_(link), name_(std::move(name)), ports_(std::move(ports)) {
  link_.connect(this);
}

LinkedDriver::~LinkedDriver() {
  timeline_.cancel(time_out_);
  link_.connect(nullptr);
}

void LinkedDriver::await(Time time) {
  timeline_.cancel(time_out_);
  awaited_for_ = time;
  time_out_ = timeline_.after(time, [this] { late(); });
}

void LinkedDriver::late() {
  fail(missing() + " within " + in_milliseconds(awaited_for_) +
       "; is it switched on, and is its cable plugged in?");
}

void LinkedDriver::on_break(std::string_view reason) {
  fail("the link is broken: " + std::string(reason));
}

void LinkedDriver::fail(std::string reason) {
  if (!trouble_.empty()) return;
  timeline_.cancel(time_out_);
  trouble_ = std::move(reason);
  give_up();
  if (host_ != nullptr) host_->fault(trouble_);
}

std::string in_milliseconds(Time time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g ms", static_cast<double>(time.count()) * 1e-6);
  return text;
}

std::string in_hexadecimal(Bytes bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    char number[8];
    std::snprintf(number, sizeof number, text.empty() ? "%02x" : " %02x", static_cast<unsigned>(byte));
    text += number;
  }
  return text;
}

std::string shown(Bytes bytes) {
  const auto printable = [](std::uint8_t byte) { return byte >= 0x20 && byte < 0x7f; };
  if (!std::all_of(bytes.begin(), bytes.end(), printable)) return in_hexadecimal(bytes);
  return '"' + std::string(as_text(bytes)) + '"';
}

}  // namespace pal::runtime::drivers
