#include "sim/model/load.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <variant>

#include "sim/model/mjcf.hpp"
#include "sim/model/mjcf_file.hpp"
#include "sim/model/scene_description.hpp"

namespace pal::sim {
namespace {

// MuJoCo reports through global hooks, writes a log into the working directory and ends the program on errors
// that it cannot return. These hooks make exceptions of errors; warnings are read from the state's counters
// instead.
void install_hooks() {
  mju_user_error = [](const char* text) { throw std::runtime_error(std::string("MuJoCo: ") + text); };
  mju_user_warning = [](const char*) {};
}

// A tool that points straight down; m and degrees.
Pose pointing_down(const std::array<double, 4>& figures) {
  return Eigen::Translation3d(figures[0], figures[1], figures[2]) *
         Eigen::AngleAxisd(radians(figures[3]), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(radians(180), Eigen::Vector3d::UnitX());
}

std::array<double, 4> in_metres(const std::array<double, 4>& tip) {
  return {tip[0] / 1e3, tip[1] / 1e3, tip[2] / 1e3, tip[3]};
}

/// Where the scene says a field of <custom>, or the scene's file.
std::string place_of(const MjcfFile& file, const std::string& field, const Scene& scene) {
  const auto found = file.custom.find(field);
  return found == file.custom.end() ? scene.file.string() : found->second;
}

Start read_start(const mjModel& model, const MjcfFile& file, const Scene& scene) {
  const std::string hint =
      "add <numeric name=\"start\" data=\"x y z turn\"/> to <custom>: metres from the shoulder, degrees";
  const std::string place = place_of(file, "start", scene);
  const int number = mj_name2id(&model, mjOBJ_NUMERIC, "start");
  if (number < 0) throw SceneError(place, "the scene does not say where the tool starts", hint);
  if (model.numeric_size[number] != 4)
    throw SceneError(
        place, "the tool's start has " + std::to_string(model.numeric_size[number]) + " figures instead of 4",
        hint);
  const mjtNum* figures = model.numeric_data + model.numeric_adr[number];
  const int text = mj_name2id(&model, mjOBJ_TEXT, "configuration");
  const std::string words = text < 0 ? "righty above flip" : model.text_data + model.text_adr[text];
  const auto configuration = parse_configuration(words);
  if (!configuration)
    throw SceneError(place_of(file, "configuration", scene),
                     "'" + words + "' is not a configuration of the arm",
                     "write righty or lefty, above or below, flip or noflip");
  return {pointing_down({figures[0], figures[1], figures[2], figures[3]}), *configuration, place};
}

// A scene's loose bodies meet the arm, what stands in the cell, and one another.
void let_loose_bodies_touch(mjModel& model) {
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const int joint = model.body_jntadr[model.body_rootid[model.geom_bodyid[geom]]];
    const bool loose = joint >= 0 && model.jnt_type[joint] == mjJNT_FREE;
    const bool touches = model.geom_contype[geom] != 0 || model.geom_conaffinity[geom] != 0;
    if (!loose || !touches) continue;
    model.geom_contype[geom] |= 3;
    model.geom_conaffinity[geom] |= 3;
  }
}

// Files in memory, for MuJoCo's reader.
class Memory {
 public:
  Memory() { mj_defaultVFS(files_.get()); }
  ~Memory() { mj_deleteVFS(files_.get()); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  void add(const char* name, const std::string& text) {
    if (mj_makeEmptyFileVFS(files_.get(), name, static_cast<int>(text.size())) != 0)
      throw std::runtime_error("there is no memory for the scene");
    std::memcpy(files_->filedata[mj_findFileVFS(files_.get(), name)], text.data(), text.size());
  }
  const mjVFS* files() const { return files_.get(); }

 private:
  std::unique_ptr<mjVFS> files_ = std::make_unique<mjVFS>();
};

void fill_in(mjModel& model, const Heights& heights) {
  const int field = mj_name2id(&model, mjOBJ_HFIELD, heights.name.c_str());
  std::copy(heights.values.begin(), heights.values.end(), model.hfield_data + model.hfield_adr[field]);
}

/// A model, or what MuJoCo says against it.
std::variant<ModelPointer, std::string> compiled(const std::string& text) {
  constexpr const char* name = "scene.xml";
  Memory memory;
  memory.add(name, text);
  std::array<char, 1000> error{};
  try {
    ModelPointer model(mj_loadXML(name, memory.files(), error.data(), static_cast<int>(error.size())));
    if (model) return model;
  } catch (const std::runtime_error& problem) {
    return problem.what();
  }
  return error.data();
}

ModelPointer build(const SceneDescription& description, const std::string& file) {
  const Mjcf mjcf = to_mjcf(description, file);
  auto model = compiled(mjcf.text);
  if (const auto* problem = std::get_if<std::string>(&model))
    throw std::logic_error("the model made of " + file + " does not load: " + *problem);
  for (const Heights& heights : mjcf.heights) fill_in(*std::get<0>(model), heights);
  return std::get<0>(std::move(model));
}

ModelPointer build(const MjcfFile& file, const Scene& scene) {
  auto model = compiled(file.text);
  if (const auto* problem = std::get_if<std::string>(&model)) throw refusal_of(file, scene, *problem);
  return std::get<0>(std::move(model));
}

}  // namespace

LoadedScene load_scene(const Scene& scene) {
  install_hooks();
  LoadedScene loaded;
  if (scene.file.extension() == ".scene") {
    const SceneDescription description = read_description(scene);
    loaded.model = build(description, scene.file.string());
    loaded.start = {pointing_down(in_metres(*description.start)), description.configuration,
                    scene.file.string() + ":" + std::to_string(description.start_line)};
    for (const Thing& thing : description.things) loaded.lines[thing.name] = thing.line;
    for (const DescribedLocation& location : description.locations)
      loaded.locations[location.name] = pointing_down(in_metres(location.tip));
    for (const DescribedSensor& sensor : description.sensors)
      loaded.sensors[sensor.name] = Eigen::Vector3d(sensor.at[0], sensor.at[1], sensor.at[2]) / 1000;
    loaded.tool = description.tool;
    loaded.machine = description.machine;
  } else {
    const MjcfFile file = read_mjcf(scene);
    loaded.model = build(file, scene);
    if (mj_name2id(loaded.model.get(), mjOBJ_JOINT, "joint1") < 0)
      throw SceneError(scene.file.string(), "the scene has no joint 'joint1'",
                       "include puma560.xml, which has it");
    loaded.start = read_start(*loaded.model, file, scene);
  }
  loaded.locations.emplace("HOME", loaded.start.tool);
  let_loose_bodies_touch(*loaded.model);
  return loaded;
}

ToolKind tool_of(const Scene& scene) {
  // A scene in MJCF has no say in it.
  return scene.file.extension() == ".scene" ? read_description(scene).tool : ToolKind::pad;
}

std::string describe_scene(const Scene& scene) {
  if (scene.file.extension() == ".scene") return read_description(scene).about;
  install_hooks();
  const ModelPointer model = build(read_mjcf(scene), scene);
  const int text = mj_name2id(model.get(), mjOBJ_TEXT, "description");
  return text < 0 ? "" : model->text_data + model->text_adr[text];
}

}  // namespace pal::sim
