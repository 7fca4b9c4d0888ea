#include "sim/model/load.hpp"

#include <array>
#include <fstream>
#include <regex>

namespace pal::sim {
namespace {

// MuJoCo reports through global hooks, writes a log into the working directory and ends the program on errors that it
// cannot return. These hooks make exceptions of errors; warnings are read from the state's counters instead.
void install_hooks() {
  mju_user_error = [](const char* text) { throw std::runtime_error(std::string("MuJoCo: ") + text); };
  mju_user_warning = [](const char*) {};
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

SceneError load_error(const Scene& scene, const std::string& text) {
  std::string place = scene.file.string();
  std::string cause = one_line(text);
  std::smatch found;
  // "XML Error: Schema violation: unrecognized element Element 'gem', line 12, column 5"
  static const std::regex where(R"((?:XML )?Error:? *(.*?)[,\s]*(?:\(?line (\d+)(?:, column (-?\d+))?\)?)\s*$)");
  if (std::regex_search(cause, found, where)) {
    place += ":" + found[2].str();
    if (found[3].matched && found[3].str() != "-1") place += ":" + found[3].str();
    cause = found[1].str();
  }
  return {place, "MuJoCo does not load the scene: " + cause, "a scene is MJCF of MuJoCo 2.2.2; see docs/workcell.md"};
}

}  // namespace

mjModel* load_model(const Scene& scene) {
  install_hooks();
  if (!std::ifstream(scene.file))
    throw SceneError(scene.file.string(), "the file cannot be read", "check the path and its permissions");
  std::array<char, 1000> error{};
  mjModel* model = nullptr;
  try {
    model = mj_loadXML(scene.file.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
  } catch (const std::runtime_error& problem) {
    throw load_error(scene, problem.what());
  }
  if (model == nullptr) throw load_error(scene, error.data());
  return model;
}

Start read_start(const mjModel& model, const Scene& scene) {
  const std::string hint = "add <numeric name=\"start\" data=\"x y z turn\"/> to <custom>: metres from the shoulder, degrees";
  const int number = mj_name2id(&model, mjOBJ_NUMERIC, "start");
  if (number < 0) throw SceneError(scene.file.string(), "the scene does not say where the tool starts", hint);
  if (model.numeric_size[number] != 4)
    throw SceneError(scene.file.string(),
                     "the tool's start has " + std::to_string(model.numeric_size[number]) + " figures instead of 4", hint);
  const mjtNum* figures = model.numeric_data + model.numeric_adr[number];

  Start start;
  start.tool = Eigen::Translation3d(figures[0], figures[1], figures[2]) *
               Eigen::AngleAxisd(radians(figures[3]), Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(radians(180), Eigen::Vector3d::UnitX());

  const int text = mj_name2id(&model, mjOBJ_TEXT, "configuration");
  const std::string words = text < 0 ? "righty above flip" : model.text_data + model.text_adr[text];
  const auto configuration = parse_configuration(words);
  if (!configuration)
    throw SceneError(scene.file.string(), "'" + words + "' is not a configuration of the arm",
                     "write righty or lefty, above or below, flip or noflip");
  start.configuration = *configuration;
  return start;
}

std::string read_description(const mjModel& model) {
  const int text = mj_name2id(&model, mjOBJ_TEXT, "description");
  return text < 0 ? std::string() : std::string(model.text_data + model.text_adr[text]);
}

}  // namespace pal::sim
