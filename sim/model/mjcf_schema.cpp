#include "sim/model/mjcf_schema.hpp"

#include <mujoco/mujoco.h>

#include <sstream>
#include <stdexcept>

namespace pal::sim {
namespace {

// MuJoCo prints its table with a line for each element: three blanks a level, the name, and in brackets what
// it may be. From column 30 on come the attributes. They go on in lines that are blank before that column.
constexpr std::size_t indent = 3;
constexpr std::size_t name_columns = 30;

std::string printed_schema() {
  std::string text(1U << 16U, '\0');
  const int length = mj_printSchema(nullptr, text.data(), static_cast<int>(text.size()), 0, 0);
  if (length <= 0) throw std::logic_error("MuJoCo does not print its schema");
  text.resize(static_cast<std::size_t>(length));
  return text;
}

MjcfElement parsed_schema() {
  std::istringstream lines(printed_schema());
  MjcfElement root;
  std::vector<MjcfElement*> path;  // the element of each level that was read last
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) continue;
    std::istringstream words(line);
    if (begin < name_columns) {
      std::string name, kind;
      words >> name >> kind;
      // <worldbody> and <body> hold the same, <body> among it.
      const bool world = name == "(world)body";
      if (world) name = "worldbody";
      path.resize(begin / indent);
      path.push_back(path.empty() ? &root : &path.back()->children[name]);
      path.back()->once = kind == "(?)";
      if (kind == "(R)") path.back()->nested = world ? "body" : name;
    }
    if (path.empty()) throw std::logic_error("MuJoCo's schema begins without an element");
    for (std::string attribute; words >> attribute;) path.back()->attributes.push_back(attribute);
  }
  return root;
}

}  // namespace

const MjcfElement* MjcfElement::child(std::string_view name) const {
  if (const auto found = children.find(name); found != children.end()) return &found->second;
  return !nested.empty() && nested == name ? this : nullptr;
}

const MjcfElement& mjcf_schema() {
  static const MjcfElement schema = parsed_schema();
  return schema;
}

}  // namespace pal::sim
