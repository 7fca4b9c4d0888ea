#include <catch2/catch.hpp>
#include <fstream>

#include "pal/pan/dot.hpp"
#include "tests/unit/pan/touch_network.hpp"

namespace pal::pan {
namespace {

void save(const std::string& name, const std::string& text) {
  std::ofstream(std::string(PAL_BINARY_DIR) + "/" + name, std::ios::binary) << text;
}

TEST_CASE("examples") {
  const Network network = touch_network();
  for (std::size_t module : {0u, 1u}) {
    const std::string name = network.modules[module].name;
    const std::string full = to_dot(network, ModuleId(module));
    save(name + ".dot", full);
    save(name + ".svg", svg(full));
    const std::string letters =
        to_dot(network, ModuleId(module), {DotOptions::Direction::left_to_right, true});
    save(name + "_letters.dot", letters);
    save(name + "_letters.svg", svg(letters));
  }
}

}  // namespace
}  // namespace pal::pan
