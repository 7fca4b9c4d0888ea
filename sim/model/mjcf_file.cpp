#include "sim/model/mjcf_file.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <set>

#include "sim/model/embedded.hpp"
#include "sim/model/mjcf_kept.hpp"
#include "sim/model/mjcf_schema.hpp"

namespace pal::sim {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLElement;

constexpr const char* robot_file = "puma560.xml";
constexpr const char* easier = "a .scene file is easier to write, see docs/workcell/scenes.md";

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

// What is wrong with the XML itself.
std::string xml_problem(const tinyxml2::XMLDocument& document) {
  const std::string said = document.ErrorStr() == nullptr ? "" : document.ErrorStr();
  const std::size_t name = said.find("name=");
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file is empty";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return name == std::string::npos ? "an element is not closed"
                                       : "the element <" + said.substr(name + 5) + "> is not closed";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not written as name=\"value\"";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment does not end with -->";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply";
    default:
      return "this is not XML: a tag is not complete";
  }
}

// The machine's own files, which a scene includes by their names.
const std::string_view* machine_part(const std::string& name) {
  if (name == robot_file) return &embedded::puma560;
  if (name == "cell.xml") return &embedded::cell;
  return nullptr;
}

std::string escaped(std::string_view value) {
  std::string text;
  for (const char c : value) {
    if (c == '&')
      text += "&amp;";
    else if (c == '<')
      text += "&lt;";
    else if (c == '"')
      text += "&quot;";
    else
      text += c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
  }
  return text;
}

class Reader {
 public:
  explicit Reader(const Scene& scene) : folder_(scene.file.parent_path()) {
    std::error_code problem;
    directory_ = fs::absolute(folder_, problem);
    write("<mujoco>", scene.file.string());
    // Files of meshes and textures are named from the scene's folder.
    write(fmt::format("<compiler meshdir=\"{0}\" texturedir=\"{0}\"/>", escaped(directory_.string())),
          scene.file.string());
    read_file(scene.file, scene.file.string() + ":1");
    write("</mujoco>", scene.file.string());
    keeper_.finish();
  }

  MjcfFile take() { return std::move(result_); }

 private:
  struct Source {
    std::string file;
    bool machine = false;  // one of the machine's own
  };

  [[noreturn]] static void fail(const std::string& place, const std::string& cause, const std::string& hint) {
    throw SceneError(place, cause, hint);
  }
  static std::string place_of(const Source& source, const XMLElement& element) {
    return source.file + ":" + std::to_string(element.GetLineNum());
  }

  void write(const std::string& line, const std::string& place) {
    result_.text += line + "\n";
    result_.places.push_back(place);
  }

  void read_file(const fs::path& path, const std::string& asked_for_at) {
    const std::string name = path.filename().string();
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::string_view* const own = machine_part(name);
    if (own == nullptr && (!in || !fs::is_regular_file(path)))
      fail(result_.places.size() > 2 ? asked_for_at : path.string(),
           result_.places.size() > 2 ? "the file " + path.string() + " cannot be read"
                                     : "the file cannot be read",
           "check the path and its permissions");
    if (own != nullptr && in && text != *own)
      fail(asked_for_at, path.string() + " is not the machine's own",
           "take the file away: " + name + " is part of the workcell and needs no copy");
    if (!read_.insert(path.lexically_normal().string()).second)
      fail(asked_for_at, path.string() + " is included twice", "take one of them out");
    parse({own != nullptr ? name : path.string(), own != nullptr}, own != nullptr ? std::string(*own) : text);
  }

  void parse(const Source& source, const std::string& text) {
    tinyxml2::XMLDocument document;
    if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
      fail(source.file + ":" + std::to_string(std::max(document.ErrorLineNum(), 1)), xml_problem(document),
           easier);
    const XMLElement* const root = document.RootElement();
    if (root == nullptr || std::string_view(root->Name()) != "mujoco")
      fail(source.file + ":1", "a scene in MJCF is one element <mujoco>", easier);
    // The machine comes first, wherever it is included: what a scene says of its own classes and sizes
    // counts.
    for (const bool machine : {true, false})
      for (const XMLElement* child = root->FirstChildElement(); child != nullptr;
           child = child->NextSiblingElement())
        if (includes_machine(*child) == machine) read_element(source, *child, "mujoco", mjcf_schema());
  }

  static std::string file_of(const XMLElement& include) {
    return include.Attribute("file") == nullptr ? "" : include.Attribute("file");
  }
  static bool includes_machine(const XMLElement& element) {
    return std::string_view(element.Name()) == "include" && machine_part(file_of(element)) != nullptr;
  }

  void read_element(const Source& source, const XMLElement& element, const std::string& parent,
                    const MjcfElement& parent_kind) {
    const std::string name = element.Name();
    const std::string place = place_of(source, element);
    if (name == "include") {
      if (file_of(element).empty())
        fail(place, "an <include> does not say which file", "write <include file=\"puma560.xml\"/>");
      if (parent != "mujoco")
        fail(place, "a file is included within <" + parent + ">", "include it directly in <mujoco>");
      return read_file(folder_ / file_of(element), place);
    }
    const MjcfElement* const kind = parent_kind.child(name);
    if (kind == nullptr) {
      std::vector<std::string> names;
      for (const auto& [known, child] : parent_kind.children) names.push_back(known);
      if (!parent_kind.nested.empty()) names.push_back(parent_kind.nested);
      fail(place, "a <" + parent + "> has no <" + name + ">",
           names.empty() ? "it holds no elements" : "it can hold " + joined(names));
    }
    check_attributes(element, *kind, place);
    if (source.file == robot_file) keeper_.own(element);
    if (!source.machine) keeper_.look(element, place);
    check_name(element, parent, place);
    write_element(source, element, *kind, place);
  }

  static void check_attributes(const XMLElement& element, const MjcfElement& kind, const std::string& place) {
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next())
      if (std::find(kind.attributes.begin(), kind.attributes.end(), attribute->Name()) ==
          kind.attributes.end())
        fail(place, fmt::format("a <{}> has no attribute '{}'", element.Name(), attribute->Name()),
             kind.attributes.empty() ? "it has none" : "it has " + joined(kind.attributes));
  }

  // Names of one kind are all different.
  void check_name(const XMLElement& element, const std::string& parent, const std::string& place) {
    const char* const given = element.Attribute("name");
    if (given == nullptr) return;
    static const std::array<std::string_view, 4> sections{"actuator", "sensor", "equality", "tendon"};
    std::string kind = element.Name();
    if (kind == "freejoint") kind = "joint";
    if (std::find(sections.begin(), sections.end(), parent) != sections.end()) kind = parent;
    const auto [before, fresh] = names_.emplace(std::make_pair(kind, given), place);
    if (!fresh)
      fail(place, fmt::format("there is more than one {} named '{}'", kind, given),
           "give it another name; the other one is in " + before->second);
    if (parent == "custom") result_.custom[given] = place;
  }

  void write_element(const Source& source, const XMLElement& element, const MjcfElement& kind,
                     const std::string& place) {
    const std::string name = element.Name();
    std::string tag = "<" + name;
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next())
      tag += fmt::format(" {}=\"{}\"", attribute->Name(), escaped(attribute->Value()));
    if (element.FirstChildElement() == nullptr) return write(tag + "/>", place);
    write(tag + ">", place);
    std::set<std::string> had;
    for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const MjcfElement* const child_kind = kind.child(child->Name());
      if (child_kind != nullptr && child_kind->once && !had.insert(child->Name()).second)
        fail(place_of(source, *child), fmt::format("a <{}> has at most one <{}>", name, child->Name()),
             "take one of them out");
      read_element(source, *child, name, kind);
    }
    write("</" + name + ">", place);
  }

  fs::path folder_, directory_;
  std::set<std::string> read_;
  std::map<std::pair<std::string, std::string>, std::string> names_;  // kind and name: where it is
  MjcfKeeper keeper_;
  MjcfFile result_;
};

}  // namespace

MjcfFile read_mjcf(const Scene& scene) {
  return Reader(scene).take();
}

}  // namespace pal::sim
