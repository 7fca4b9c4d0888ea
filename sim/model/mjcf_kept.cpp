#include "sim/model/mjcf_kept.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "sim/scene.hpp"

namespace pal::sim {
namespace {

using tinyxml2::XMLElement;

// Sections whose elements act on the parts that they name.
constexpr std::array<std::string_view, 4> acting{"actuator", "equality", "tendon", "contact"};
constexpr std::array<std::string_view, 6> kept_classes{"arm", "dark", "steel", "cell", "drive", "main"};
// Bodies of tools that a scene in MJCF does not have. The workcell knows parts of the arm by their names.
constexpr std::array<std::string_view, 3> tool_bodies{"finger left", "finger right", "range finder"};

template <class Names>
bool is_in(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string_view parent_of(const XMLElement& element) {
  const auto* const around = element.Parent() == nullptr ? nullptr : element.Parent()->ToElement();
  return around == nullptr ? std::string_view{} : around->Name();
}

// The element directly in <mujoco> that this one is, or stands in.
std::string_view section_of(const XMLElement& element) {
  const XMLElement* section = &element;
  while (parent_of(*section) != "mujoco" && section->Parent() != nullptr &&
         section->Parent()->ToElement() != nullptr)
    section = section->Parent()->ToElement();
  return section->Name();
}

// The kind of part that an attribute names: "joint1" and "jointinparent" a joint, "cranksite" a site.
std::string kind_named_by(std::string_view attribute) {
  if (attribute == "name" || attribute == "class") return {};
  for (const std::string_view kind : {"joint", "body", "geom", "site", "tendon"}) {
    if (attribute.starts_with(kind) || attribute.ends_with(kind)) return std::string(kind);
  }
  return {};
}

void check_physics(const XMLElement& element, const std::string& place) {
  const std::string_view name = element.Name();
  const auto* const first = element.FirstAttribute();
  if (name == "option" || (name == "flag" && parent_of(element) == "option"))
    throw SceneError(place,
                     first == nullptr ? "the scene changes the physics"
                                      : fmt::format("the scene changes the physics: {}", first->Name()),
                     "take <option> out; the workcell's physics is described in docs/workcell/README.md");
  if (name == "statistic" && element.Attribute("meaninertia") != nullptr)
    throw SceneError(place, "the scene changes the physics: meaninertia",
                     "take it out; the solver's tolerance counts in it");
  if (name == "compiler" && first != nullptr)
    throw SceneError(place, fmt::format("the scene changes how the arm is read: {}", first->Name()),
                     "take <compiler> out; angles are radians, files are named from the scene's folder");
}

void check_defaults(const XMLElement& element, const std::string& place) {
  const std::string_view name = element.Name();
  if (name == "default") {
    const char* const own = element.Attribute("class");
    if (own != nullptr && is_in(kept_classes, own))
      throw SceneError(place, fmt::format("the scene changes the machine's class '{}'", own),
                       "choose another name for the class");
    if (own != nullptr && parent_of(element) == "mujoco")
      throw SceneError(place, fmt::format("the class '{}' stands in no <default>", own),
                       "write <default><default class=\"mine\">…</default></default>");
  }
  if (parent_of(element) == "default" && name != "default" &&
      element.Parent()->ToElement()->Attribute("class") == nullptr)
    throw SceneError(place, fmt::format("the scene changes the arm: its default of <{}>", name),
                     "put it into a class of its own: <default class=\"mine\"> within <default>");
}

}  // namespace

void MjcfKeeper::own(const XMLElement& element) {
  const char* const name = element.Attribute("name");
  if (name != nullptr) own_.emplace(element.Name(), name);
}

void MjcfKeeper::look(const XMLElement& element, const std::string& place) {
  check_physics(element, place);
  check_defaults(element, place);
  const char* const name = element.Attribute("name");
  if (std::string_view(element.Name()) == "body" && name != nullptr && is_in(tool_bodies, name))
    throw SceneError(place, fmt::format("'{}' is the name of a part of a tool", name),
                     "give the body another name");
  if (!is_in(acting, section_of(element))) return;
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
       attribute = attribute->Next()) {
    const std::string kind = kind_named_by(attribute->Name());
    if (!kind.empty()) uses_.push_back({{kind, attribute->Value()}, element.Name(), place});
  }
}

void MjcfKeeper::finish() const {
  for (const Use& use : uses_) {
    const auto& [kind, name] = use.part;
    if (!own_.contains(use.part)) continue;
    throw SceneError(
        use.place,
        fmt::format("the scene changes the arm: <{}> acts on its {} '{}'", use.element, kind, name),
        "let it name only what the scene itself adds");
  }
}

}  // namespace pal::sim
