// Any bytes at the WebSocket, a message a line. An input that begins with '+' has shown the token before.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzzed_session.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pal::fuzz::FuzzedSession dialogue(pal::server::json_session);
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  if (!rest.empty() && rest.front() == '+') {
    rest.remove_prefix(1);
    dialogue.give(R"({"jsonrpc": "2.0", "method": "hello", "params": {"token": ")" +
                  dialogue.context.tokens.programmer + "\"}}");
  }
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    dialogue.give(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return 0;
}
