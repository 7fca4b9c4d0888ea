#include "runtime/drivers/alter/codec.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pal::runtime::drivers::alter {
namespace {

constexpr std::uint8_t start = 0x7e;
constexpr std::size_t head_size = 3;  // start, type, length of the body
constexpr std::size_t check_size = 2;
constexpr std::size_t position_size = 3;    // bytes a figure
constexpr std::size_t correction_size = 2;  // bytes a figure
constexpr std::size_t request_size = 2 + 6 * position_size;
constexpr std::size_t answer_size = 2 + 6 * correction_size;
constexpr std::size_t longest_text = 120;

// CRC-16/CCITT-FALSE: polynomial 0x1021, beginning with 0xffff; over type, length and body.
std::uint16_t check_of(Bytes bytes) {
  unsigned check = 0xffffU;
  for (const std::uint8_t byte : bytes) {
    check ^= static_cast<unsigned>(byte) << 8U;
    for (int bit = 0; bit < 8; ++bit)
      check = ((check & 0x8000U) != 0 ? (check << 1U) ^ 0x1021U : check << 1U) & 0xffffU;
  }
  return static_cast<std::uint16_t>(check);
}

// High byte first, two's complement.
void put(std::vector<std::uint8_t>& bytes, double figure, std::size_t size) {
  const double most = std::ldexp(1.0, static_cast<int>(8 * size) - 1) - 1;
  const double steps = std::clamp(std::round(figure / resolution), -most, most);
  const auto value = static_cast<std::uint32_t>(static_cast<std::int32_t>(steps));
  for (std::size_t i = size; i-- > 0;) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

double get(const std::uint8_t* bytes, std::size_t size) {
  std::uint32_t value = (bytes[0] & 0x80U) != 0 ? 0xffffffffU : 0U;
  for (std::size_t i = 0; i < size; ++i) value = (value << 8U) | bytes[i];
  return static_cast<double>(static_cast<std::int32_t>(value)) * resolution;
}

Figures get_figures(const std::uint8_t* bytes, std::size_t size) {
  Figures figures{};
  for (std::size_t i = 0; i < figures.size(); ++i) figures[i] = get(bytes + i * size, size);
  return figures;
}

struct Body {
  std::uint8_t type;
  std::vector<std::uint8_t> bytes;
};

Body body_of(const Request& request) {
  Body body{'R', {request.cycle, static_cast<std::uint8_t>(request.moving ? 1 : 0)}};
  for (const double figure : request.position) put(body.bytes, figure, position_size);
  return body;
}

Body body_of(const Answer& answer) {
  Body body{'A', {answer.cycle, static_cast<std::uint8_t>(answer.motion ? 1 : 0)}};
  for (const double figure : answer.correction) put(body.bytes, figure, correction_size);
  return body;
}

Body body_of(const Ended& ended) {
  const std::string text = ended.text.substr(0, longest_text);
  Body body{'E', {static_cast<std::uint8_t>(ended.reason)}};
  body.bytes.insert(body.bytes.end(), text.begin(), text.end());
  return body;
}

std::variant<Frame, Garbled> decode(std::uint8_t type, Bytes body) {
  if (type == 'R' && body.size() == request_size && body[1] <= 1)
    return Request{body[0], body[1] != 0, get_figures(body.data() + 2, position_size)};
  if (type == 'A' && body.size() == answer_size && body[1] <= 1)
    return Answer{body[0], body[1] != 0, get_figures(body.data() + 2, correction_size)};
  if (type == 'E' && !body.empty() && body[0] <= static_cast<unsigned>(Ended::Reason::arm_fault))
    return Ended{static_cast<Ended::Reason>(body[0]), std::string(as_text(body.subspan(1)))};
  return Garbled{"a frame has a type, a length or a mode that ALTER does not know"};
}

}  // namespace

std::vector<std::uint8_t> encode(const Frame& frame) {
  const Body body = std::visit([](const auto& kind) { return body_of(kind); }, frame);
  std::vector<std::uint8_t> bytes{start, body.type, static_cast<std::uint8_t>(body.bytes.size())};
  bytes.insert(bytes.end(), body.bytes.begin(), body.bytes.end());
  const std::uint16_t check = check_of(Bytes(bytes).subspan(1));
  bytes.push_back(static_cast<std::uint8_t>(check >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(check & 0xffU));
  return bytes;
}

void Decoder::feed(Bytes bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<std::variant<Frame, Garbled>> Decoder::next() {
  const auto first = std::find(bytes_.begin(), bytes_.end(), start);
  const bool strays = first != bytes_.begin();
  bytes_.erase(bytes_.begin(), first);
  if (strays) return Garbled{"bytes came that no frame begins with"};
  if (bytes_.size() < head_size) return std::nullopt;
  const std::size_t size = bytes_[2];
  if (size > 1 + longest_text) {
    bytes_.erase(bytes_.begin());
    return Garbled{"a frame is longer than frames are"};
  }
  const std::size_t whole = head_size + size + check_size;
  if (bytes_.size() < whole) return std::nullopt;
  const Bytes frame = Bytes(bytes_).first(whole);
  const auto check = static_cast<std::uint16_t>((frame[whole - 2] << 8U) | frame[whole - 1]);
  if (check != check_of(frame.subspan(1, head_size - 1 + size))) {
    bytes_.erase(bytes_.begin());  // what looked like a start may have been none
    return Garbled{"a frame's checksum is wrong"};
  }
  auto result = decode(frame[1], frame.subspan(head_size, size));
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(whole));
  return result;
}

}  // namespace pal::runtime::drivers::alter
