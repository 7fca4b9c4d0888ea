#include "sim/model/private/load.hpp"

#include <array>
#include <fstream>
#include <memory>
#include <regex>

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
          "the line may be one of an included file; a scene is MJCF of MuJoCo 2.2.2, see docs/workcell.md"};
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
  const std::string hint =
      "add <numeric name=\"start\" data=\"x y z turn\"/> to <custom>: metres from the shoulder, degrees";
  const int number = mj_name2id(&model, mjOBJ_NUMERIC, "start");
  if (number < 0) throw SceneError(scene.file.string(), "the scene does not say where the tool starts", hint);
  if (model.numeric_size[number] != 4)
    throw SceneError(
        scene.file.string(),
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

std::string describe_scene(const Scene& scene) {
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(load_model(scene), mj_deleteModel);
  const int text = mj_name2id(model.get(), mjOBJ_TEXT, "description");
  return text < 0 ? std::string() : std::string(model->text_data + model->text_adr[text]);
}

}  // namespace pal::sim
