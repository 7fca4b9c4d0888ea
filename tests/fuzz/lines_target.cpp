// Any bytes as lines. An input that begins with '+' has shown the token before.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzzed_session.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pal::fuzz::FuzzedSession dialogue(pal::server::line_session);
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  if (!rest.empty() && rest.front() == '+') {
    rest.remove_prefix(1);
    dialogue.give("token " + dialogue.context.tokens.programmer + "\r");
  }
  for (std::size_t i = 0; i < rest.size(); i += 7) dialogue.give(rest.substr(i, 7));
  return 0;
}
