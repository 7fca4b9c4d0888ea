// Joins two links: what arrives at one is sent on by the other.
#pragma once

#include "runtime/drivers/link.hpp"

namespace pal::runtime::drivers {

/// A break of one side is not passed on: it is as if a cable were unplugged at the far end of a converter.
class Bridge {
 public:
  /// Both outlive the bridge, which becomes the user of both.
  Bridge(Link& first, Link& second);
  ~Bridge();
  Bridge(const Bridge&) = delete;
  Bridge& operator=(const Bridge&) = delete;

 private:
  class Side final : public LinkUser {
   public:
    explicit Side(Link& other) : other_(other) {}
    void on_bytes(Bytes bytes) override { other_.write(bytes); }
    void on_break(std::string_view) override {}

   private:
    Link& other_;
  };
  Link& first_;
  Link& second_;
  Side from_first_;
  Side from_second_;
};

}  // namespace pal::runtime::drivers
