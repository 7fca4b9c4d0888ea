#include "sim/model/private/load.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <regex>
#include <stdexcept>

#include "sim/model/private/mjcf.hpp"
#include "sim/model/private/scene_description.hpp"

namespace pal::sim {
namespace {

// MuJoCo reports through global hooks, writes a log into the working directory and ends the program on errors
// that it cannot return. These hooks make exceptions of errors; warnings are read from the state's counters
// instead.
void install_hooks() {
  mju_user_error = [](const char* text) { throw std::runtime_error(std::string("MuJoCo: ") + text); };
  mju_user_warning = [](const char*) {};
}

std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool space = c == '\n' || c == '\r' || c == ' ';
    if (!space) line += c;
    if (space && !line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line;
}

// MuJoCo says where in several ways: "Element 'gem', line 3", "line = 2, column = -1", "Line number=2: …"; 0
// is no place.
SceneError load_error(const Scene& scene, const std::string& text) {
  static const std::regex where(R"([,\s(]*[Ll]ine(?: number)? ?=? ?(\d+)(?:, column = -?\d+)?\)?)");
  const std::string whole = one_line(text);
  std::string place = scene.file.string();
  std::string line;
  for (std::sregex_iterator found(whole.begin(), whole.end(), where), end; found != end; ++found)
    if ((*found)[1] != "0") line = (*found)[1];
  if (!line.empty()) place += ":" + line;
  std::string cause = std::regex_replace(whole, where, "");
  cause = std::regex_replace(cause, std::regex("^(XML )?Error:? *"), "");
  return {place, "MuJoCo does not load the scene: " + cause,
          "the line may be one of an included file; this is MJCF of MuJoCo 2.2.2, a .scene file is easier to "
          "write, see docs/workcell/scenes.md"};
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

Start read_start(const mjModel& model, const Scene& scene) {
  const std::string hint =
      "add <numeric name=\"start\" data=\"x y z turn\"/> to <custom>: metres from the shoulder, degrees";
  const int number = mj_name2id(&model, mjOBJ_NUMERIC, "start");
  if (number < 0) throw SceneError(scene.file.string(), "the scene does not say where the tool starts", hint);
  if (model.numeric_size[number] != 4)
    throw SceneError(
        scene.file.string(),
        "the tool's start has " + std::to_string(model.numeric_size[number]) + " figures instead of 4", hint);
  const mjtNum* figures = model.numeric_data + model.numeric_adr[number];
  const int text = mj_name2id(&model, mjOBJ_TEXT, "configuration");
  const std::string words = text < 0 ? "righty above flip" : model.text_data + model.text_adr[text];
  const auto configuration = parse_configuration(words);
  if (!configuration)
    throw SceneError(scene.file.string(), "'" + words + "' is not a configuration of the arm",
                     "write righty or lefty, above or below, flip or noflip");
  return {pointing_down({figures[0], figures[1], figures[2], figures[3]}), *configuration};
}

// Everything that is measured or proved of a run rests on these.
void check_options(const mjModel& model, const Scene& scene) {
  const auto refuse = [&](const std::string& cause, const std::string& attribute) {
    throw SceneError(scene.file.string(), "the scene changes " + cause,
                     "take " + attribute + " out of the scene's <option>");
  };
  if (model.opt.timestep != 0.001) refuse("the time step, which is 1 ms", "the timestep");
  if (model.opt.integrator != mjINT_IMPLICIT)
    refuse("the integrator, which is the implicit one", "the integrator");
  const mjtNum* gravity = model.opt.gravity;
  if (gravity[0] != 0 || gravity[1] != 0 || gravity[2] != -9.81)
    refuse("gravity, which is 9.81 m/s^2 downwards", "gravity");
  if (model.opt.disableflags != 0) refuse("which parts of the physics are on", "<flag>");
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

LoadedScene load_mjcf(const Scene& scene) {
  if (!std::ifstream(scene.file))
    throw SceneError(scene.file.string(), "the file cannot be read", "check the path and its permissions");
  std::array<char, 1000> error{};
  LoadedScene loaded;
  try {
    loaded.model.reset(mj_loadXML(scene.file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  } catch (const std::runtime_error& problem) {
    throw load_error(scene, problem.what());
  }
  if (!loaded.model) throw load_error(scene, error.data());
  return loaded;
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

ModelPointer build(const SceneDescription& description, const std::string& file) {
  constexpr const char* name = "scene.xml";
  const Mjcf mjcf = to_mjcf(description, file);
  Memory memory;
  memory.add(name, mjcf.text);
  std::array<char, 1000> error{};
  ModelPointer model(mj_loadXML(name, memory.files(), error.data(), static_cast<int>(error.size())));
  if (!model)
    throw std::logic_error("the model made of " + file + " does not load: " + one_line(error.data()));
  for (const Heights& heights : mjcf.heights) fill_in(*model, heights);
  return model;
}

}  // namespace

LoadedScene load_scene(const Scene& scene) {
  install_hooks();
  LoadedScene loaded;
  if (scene.file.extension() == ".scene") {
    const SceneDescription description = read_description(scene);
    loaded.model = build(description, scene.file.string());
    loaded.start = {pointing_down(in_metres(*description.start)), description.configuration};
    for (const DescribedLocation& location : description.locations)
      loaded.locations[location.name] = pointing_down(in_metres(location.tip));
    loaded.tool = description.tool;
    loaded.machine = description.machine;
  } else {
    loaded = load_mjcf(scene);
    if (mj_name2id(loaded.model.get(), mjOBJ_JOINT, "joint1") < 0)
      throw SceneError(scene.file.string(), "the scene has no joint 'joint1'",
                       "include puma560.xml, which has it");
    check_options(*loaded.model, scene);
    loaded.start = read_start(*loaded.model, scene);
  }
  loaded.locations.emplace("HOME", loaded.start.tool);
  let_loose_bodies_touch(*loaded.model);
  return loaded;
}

std::string describe_scene(const Scene& scene) {
  if (scene.file.extension() == ".scene") return read_description(scene).about;
  install_hooks();
  const LoadedScene loaded = load_mjcf(scene);
  const mjModel& model = *loaded.model;
  const int text = mj_name2id(&model, mjOBJ_TEXT, "description");
  return text < 0 ? "" : model.text_data + model.text_adr[text];
}

}  // namespace pal::sim
