// The frames of the ALTER line.
#include <catch2/catch.hpp>

#include "runtime/drivers/alter/codec.hpp"

namespace pal::runtime::drivers::alter {
namespace {

using namespace std::chrono_literals;

Frame decoded(const std::vector<std::uint8_t>& bytes) {
  Decoder decoder;
  decoder.feed(bytes);
  const auto found = decoder.next();
  REQUIRE(found.has_value());
  REQUIRE(std::holds_alternative<Frame>(*found));
  return std::get<Frame>(*found);
}

TEST_CASE("each kind of frame comes back as it was", "[alter]") {
  const Request request{7, true, {460.125, -200.5, -151.8, 180, -0.001, 12.5}};
  const Answer answer{255, true, {-32.767, 0.001, 0, 32.767, -1, 0.56}};
  const Ended ended{Ended::Reason::impossible, "joint 3 would leave its range"};
  const Request again = std::get<Request>(decoded(encode(request)));
  CHECK(again.cycle == 7);
  CHECK(again.moving);
  for (std::size_t i = 0; i < 6; ++i) CHECK(again.position[i] == Approx(request.position[i]).margin(1e-9));
  const Answer back = std::get<Answer>(decoded(encode(answer)));
  CHECK(back.cycle == 255);
  for (std::size_t i = 0; i < 6; ++i) CHECK(back.correction[i] == Approx(answer.correction[i]).margin(1e-9));
  CHECK(std::get<Ended>(decoded(encode(ended))) == ended);
}

TEST_CASE("the dialogue of docs/workcell/alter.md, byte for byte", "[alter]") {
  const std::vector<std::uint8_t> expected{0x7e, 'A',  0x0e, 0x05, 0x01, 0x00, 0x00, 0x00, 0x00, 0x02,
                                           0x30, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xaa, 0xa4};
  const auto bytes = encode(Answer{5, true, {0, 0, 0.56, 0, 0, 0}});
  CHECK(bytes.size() == expected.size());
  CHECK(bytes == expected);
}

TEST_CASE("a frame is found however the bytes are cut", "[alter]") {
  const auto bytes = encode(Request{1, false, {1, 2, 3, 4, 5, 6}});
  Decoder decoder;
  for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
    decoder.feed(Bytes(bytes).subspan(i, 1));
    REQUIRE_FALSE(decoder.next());
  }
  decoder.feed(Bytes(bytes).last(1));
  const auto found = decoder.next();
  REQUIRE(found);
  CHECK(std::holds_alternative<Frame>(*found));
}

TEST_CASE("any single bit that flips is noticed, and the next frame is found again", "[alter]") {
  const auto good = encode(Answer{9, true, {1, -2, 3, -4, 5, -6}});
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    auto bytes = good;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    Decoder decoder;
    decoder.feed(bytes);
    bool garbled = false;
    int frames = 0;
    for (int i = 0; i < 8; ++i) {  // a wrong length may swallow some of what follows
      decoder.feed(good);
      while (const auto found = decoder.next()) {
        if (std::holds_alternative<Garbled>(*found)) garbled = true;
        if (const auto* frame = std::get_if<Frame>(&*found)) {
          CHECK(std::get<Answer>(*frame) == std::get<Answer>(decoded(good)));
          ++frames;
        }
      }
    }
    CAPTURE(bit);
    CHECK(garbled);
    CHECK(frames > 0);
  }
}

TEST_CASE("the protocol keeps the environment's times: a tick every 28 ms, an answer within 20 ms",
          "[alter]") {
  const Time request = line.duration(encode(Request{}).size());
  const Time answer = line.duration(encode(Answer{}).size());
  CHECK(request == 2170139ns);  // 25 bytes of 10 bits at 115200 baud
  CHECK(answer == 1649306ns);   // 19 bytes
  // The driver's tick comes when the request has passed; an answer 20 ms later must still be there in time.
  CHECK(request + 20ms + answer <= answer_within);
  CHECK(answer_within < period);
  CHECK(request < period);  // requests do not wait for one another: ticks are as regular as cycles
}

}  // namespace
}  // namespace pal::runtime::drivers::alter
