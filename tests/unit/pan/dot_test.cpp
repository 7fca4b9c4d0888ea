// Bodies as DOT and as SVG.
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <thread>

#include "pal/pan/dot.hpp"
#include "pal/pan/dump.hpp"
#include "tests/unit/pan/touch_network.hpp"

namespace pal::pan {
namespace {

const ModuleId sm1(std::size_t{0});
const ModuleId mc1(std::size_t{1});
const DotOptions thesis{DotOptions::Direction::left_to_right, true};

/// Everything that `pattern`'s first group matches, in order.
std::vector<std::string> all(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

/// For a person to look at: build/<preset>/tests/unit/pan/*.svg.
void save(const std::string& name, const std::string& text) {
  std::ofstream(std::string(PAL_BINARY_DIR) + "/" + name, std::ios::binary) << text;
}

TEST_CASE("a module drawn from the top down holds every node's content in its attributes") {
  const std::string dot = to_dot(touch_network(), mc1);
  CHECK(all(dot, "pal_kind=\"([a-z_]+)\"") == std::vector<std::string>{"start", "repeat", "wait", "send",
                                                                       "wait", "perform", "perform", "merge",
                                                                       "send", "until"});
  CHECK(all(dot, "pal_node=\"([0-9]+)\"") ==
        std::vector<std::string>{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"});
  CHECK(all(dot, "pal_message=\"([^\"]+)\"") ==
        std::vector<std::string>{"tick", "request motion", "motion", "correction"});
  CHECK(all(dot, "pal_sender=\"([^\"]+)\"") == std::vector<std::string>{"alter", "SM1"});
  CHECK(all(dot, "pal_receiver=\"([^\"]+)\"") == std::vector<std::string>{"SM1", "alter"});
  CHECK(all(dot, "pal_within_ns=\"([^\"]+)\"") == std::vector<std::string>{"4000000"});
  CHECK(all(dot, "pal_activity=\"([^\"]+)\"") == std::vector<std::string>{"obey", "hold"});
  CHECK(all(dot, "pal_mate=\"([^\"]+)\"") == std::vector<std::string>{"9", "7", "4", "1"});
  CHECK(all(dot, "pal_branch=\"([^\"]+)\"") == std::vector<std::string>{"0", "1"});
}

TEST_CASE("each arm of a CASE begins with its condition, in the order of the text") {
  const std::string dot = to_dot(touch_network(), sm1);
  CHECK(
      all(dot, "pal_kind=\"guard\", pal_guard=\"([^\"]+)\"") ==
      std::vector<std::string>{"pc-force = TRUE", "pc-force = FALSE", "pc-reach = FALSE", "pc-reach = TRUE"});
  CHECK_THAT(dot, Catch::Contains("\"15 CASE\" -> \"15.0 pc-force = TRUE\" [pal_branch=\"0\""));
  CHECK_THAT(dot, Catch::Contains("\"15.0 pc-force = TRUE\" -> \"16 stand-still\""));
}

TEST_CASE("the blocks of a CONCURRENT stand between two bars") {
  const std::string dot = to_dot(touch_network(), sm1);
  CHECK(all(dot, "pal_thread=\"([^\"]+)\"") == std::vector<std::string>{"SM1.1", "SM1.2"});
  // The first block cannot end: it is stopped. The second ends.
  CHECK_THAT(dot,
             Catch::Contains("\"10 UNTIL( forever )\" -> \"24 END CONCURRENT\":b0:n [pal_stops=\"true\""));
  CHECK(all(dot, "-> \"24 END CONCURRENT\":(b[0-9]):n \\[[^\\]]*pal_block_end=\"true\"") ==
        std::vector<std::string>{"b1"});
}

TEST_CASE("loops are back arcs") {
  const std::string dot = to_dot(touch_network(), sm1);
  CHECK(all(dot, "(\"[^\"]+\" -> \"[^\"]+\") \\[pal_back=\"true\"").size() == 2);
  CHECK_THAT(dot,
             Catch::Contains("\"6 REPEAT\" -> \"10 UNTIL( forever )\" [pal_back=\"true\", dir=\"back\""));
}

TEST_CASE("with letters, equal statements have one letter and the key has all of them") {
  const std::string dot = to_dot(touch_network(), sm1, thesis);
  CHECK_THAT(dot,
             Catch::Contains(
                 "\"2 TXM( request Zforce from LS1 )\" [pal_kind=\"send\", pal_message=\"request Zforce\", "
                 "pal_receiver=\"LS1\", pal_node=\"2\", label=\"B\""));
  CHECK(all(dot, "label=\"(B)\"").size() == 2);
  CHECK(all(dot, "<B>([A-Z]+|c[0-9])</B>").size() == 15);
  CHECK_THAT(dot, Catch::Contains("label=\"not c1\""));
}

TEST_CASE("a key says what the colours and lines mean that a drawing has, and no others") {
  for (const DotOptions& options : {DotOptions(), thesis}) {
    const std::string skill_module = to_dot(touch_network(), sm1, options);
    for (const char* meaning :
         {">message<", ">condition<", ">activity<", ">diamond: CASE<", ">bold: back to REPEAT<"})
      CHECK_THAT(skill_module, Catch::Contains(meaning));
    CHECK_THAT(to_dot(touch_network(), mc1, options), !Catch::Contains(">condition<"));
    CHECK_NOTHROW(svg(skill_module));
  }
}

TEST_CASE("the ways out of an UNTIL are named TRUE and FALSE") {
  const std::string dot = to_dot(touch_network(), sm1);
  CHECK(all(dot, "label=\"  (TRUE)\"").size() == 1);
  CHECK(all(dot, "label=\"  (FALSE)\"").size() == 1);
}

TEST_CASE("the picture has each statement as text and as title") {
  const Network network = touch_network();
  for (const ModuleId module : {sm1, mc1}) {
    // Graphviz writes hyphens as entities.
    const std::string picture = std::regex_replace(svg(to_dot(network, module)), std::regex("&#45;"), "-");
    save(network.modules[module.index()].name + ".svg", picture);
    save(network.modules[module.index()].name + "_letters.svg", svg(to_dot(network, module, thesis)));
    for (const std::string& name : all(to_dot(network, module), "\n  \"([0-9]+ [^\"]+)\" \\[")) {
      CHECK_THAT(picture, Catch::Contains("<title>" + name + "</title>"));
    }
    CHECK_THAT(picture, Catch::Contains(">TXM( request "));
  }
}

TEST_CASE("the same module gives the same bytes") {
  CHECK(to_dot(touch_network(), sm1) == to_dot(touch_network(), sm1));
  const std::string dot = to_dot(touch_network(), sm1);
  CHECK(svg(dot) == svg(dot));
}

TEST_CASE("what is not DOT is refused with the reason") {
  CHECK_THROWS_WITH(svg("digraph {"), Catch::Contains("not DOT") && Catch::Contains("syntax error"));
  CHECK_THROWS_AS(svg(""), std::runtime_error);
}

TEST_CASE("quotes in names stay inside the quotes of DOT") {
  Network network = touch_network();
  network.activities[2].name = "say \"obey\"";
  CHECK_NOTHROW(svg(to_dot(network, mc1)));
}

// Graphviz has globals: drawings and layouts of two threads at once crashed.
TEST_CASE("two threads draw and lay out, one after the other") {
  const std::string dot = "digraph g { a -> b -> c -> d; a -> c; b -> d; e -> f; a -> f; }\n";
  std::size_t drawn = 0, laid_out = 0;
  std::thread other([&] {
    for (int i = 0; i < 200; ++i) drawn += svg(dot).find("<svg") != std::string::npos ? 1U : 0U;
  });
  for (int i = 0; i < 400; ++i) laid_out += lay_out(dot).size();
  other.join();
  CHECK(drawn == 200);
  CHECK(laid_out == 400 * 6);
}

}  // namespace
}  // namespace pal::pan
