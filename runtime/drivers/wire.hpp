// A serial line in virtual time: what joins a driver to an emulated device in one process.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/drivers/link.hpp"
#include "runtime/drivers/timeline.hpp"

namespace pal::runtime::drivers {

/// How fast a line is. A start bit, eight bits and a stop bit make ten bits a byte.
struct LineSpeed {
  double baud = 9600;
  double bits_per_byte = 10;

  /// The time from the first bit of the first byte to the last bit of the last byte.
  Time duration(std::size_t bytes) const;
};

/// Carries the bytes of a wire, for example through a pair of file descriptors; it does not add to their
/// time. Returns the bytes that came out at the other end: the same ones, unless something is broken.
class Carrier {
 public:
  virtual ~Carrier() = default;
  enum class Direction { to_b, to_a };
  virtual std::vector<std::uint8_t> carry(Direction direction, Bytes bytes) = 0;
};

/// Two ends, a and b, and a line in each direction. Bytes that are written together arrive together, when the
/// last one has passed: at max(now, the line is free) + duration. The timeline then calls the other end.
class Wire {
 public:
  /// Changes bytes on their way, for tests and for faults on demand: may change, drop or add some.
  using Tamper = std::function<void(Carrier::Direction, std::vector<std::uint8_t>&)>;

  /// `carrier` null: the bytes stay in the process. Everything given outlives the wire.
  Wire(Timeline& timeline, LineSpeed speed, Carrier* carrier = nullptr);
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;
  ~Wire();

  Link& a() { return a_; }
  Link& b() { return b_; }
  const LineSpeed& speed() const { return speed_; }

  void tamper(Tamper tamper) { tamper_ = std::move(tamper); }
  /// Everything written from now on in this direction arrives later by this time; the order stays.
  void delay(Carrier::Direction direction, Time by);
  /// Both ends learn it at this instant; what is on its way is lost.
  void cut(std::string_view reason);
  /// Plugged in again.
  void mend() { broken_ = false; }

 private:
  class End final : public Link {
   public:
    End(Wire& wire, Carrier::Direction direction) : wire_(wire), direction_(direction) {}
    void connect(LinkUser* user) override { user_ = user; }
    void write(Bytes bytes) override { wire_.send(*this, bytes); }
    LinkUser* user() const { return user_; }

   private:
    friend class Wire;
    struct Parcel {
      std::vector<std::uint8_t> bytes;
      Timeline::Token arrival;
    };
    Wire& wire_;
    Carrier::Direction direction_;
    LinkUser* user_ = nullptr;
    Time free_at_{};
    Time later_by_{};
    Time last_arrival_{};
    std::deque<Parcel> under_way_;  // written here, not arrived
  };

  void send(End& from, Bytes bytes);
  void arrive(End& from);
  void drop(End& from);

  Timeline& timeline_;
  LineSpeed speed_;
  Carrier* carrier_;
  Tamper tamper_;
  bool broken_ = false;
  End a_;
  End b_;
};

}  // namespace pal::runtime::drivers
