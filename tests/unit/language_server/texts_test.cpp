// Framing, positions and URIs.
#include <catch2/catch.hpp>
#include <sstream>

#include "language_server/framing.hpp"
#include "language_server/text.hpp"
#include "language_server/uri.hpp"

using namespace pal::language_server;

TEST_CASE("messages are framed, and a bad header does not end the stream") {
  std::istringstream in(
      "Content-Length: 2\r\n\r\n{}content-length:3\r\nContent-Type: x\r\n\r\nabcNo: length\r\n\r\n"
      "Content-Length: x\r\n\r\nContent-Length: 1\r\n\r\nyContent-Length: 9\r\n\r\nshort");
  CHECK(std::get<std::string>(read_message(in)) == "{}");
  CHECK(std::get<std::string>(read_message(in)) == "abc");
  CHECK(std::holds_alternative<BadHeader>(read_message(in)));
  CHECK(std::holds_alternative<BadHeader>(read_message(in)));
  CHECK(std::get<std::string>(read_message(in)) == "y");
  CHECK(std::holds_alternative<EndOfInput>(read_message(in)));
  std::ostringstream out;
  write_message("\u00e4", out);
  CHECK(out.str() == "Content-Length: 2\r\n\r\n\u00e4");
}

TEST_CASE("columns are UTF-16") {
  Text text("a\u00e4\U0001F600b\r\nsecond\rthird");
  CHECK(text.lines() == 3);
  CHECK(text.offset({0, 2}) == 3);
  CHECK(text.offset({0, 3}) == 3);  // within the pair
  CHECK(text.offset({0, 4}) == 7);
  CHECK(text.offset({0, 99}) == 8);
  CHECK(text.position(7) == Position{0, 4});
  CHECK(text.position(text.offset({2, 3})) == Position{2, 3});
  CHECK(text.offset({9, 0}) == text.content().size());
  text.replace({0, 1}, {0, 4}, "xyz\n");
  CHECK(text.content() == "axyz\nb\r\nsecond\rthird");
  text.replace({1, 1}, {0, 4}, "");  // in the wrong order
  CHECK(text.content() == "axyz\r\nsecond\rthird");
}

TEST_CASE("URIs have escapes") {
  CHECK(path_of("file:///a/b%20c/%C3%A4.pal") == "/a/b c/\u00e4.pal");
  CHECK(path_of("file:///a/./x/../b.pal") == "/a/b.pal");
  CHECK(path_of("file:/a.pal") == "/a.pal");
  CHECK(path_of("file:///a%zz.pal") == "/a%zz.pal");
  CHECK_FALSE(path_of("untitled:1"));
  CHECK_FALSE(path_of("file://"));
  CHECK_FALSE(path_of("file:///a%00b"));
  CHECK(uri_of("/a b/\u00e4.pal") == "file:///a%20b/%C3%A4.pal");
  CHECK(path_of(uri_of("/100%/#?.pal")) == "/100%/#?.pal");
}
