// The caption of a chart: what is shown, and with which figures.
#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/legend.hpp"
#include "analyzer/chart/panel.hpp"

namespace pal::analyzer::chart {

namespace {

constexpr Length left_edge = 40;

std::string subject(const Layer& layer) {
  std::string text = layer.timeline->skill;
  if (!layer.timeline->environment.empty()) text += " in " + layer.timeline->environment;
  return text;
}

std::string run_of(const Layer& layer) {
  if (layer.timeline->origin == "predicted") return "a predicted run";
  if (layer.timeline->origin == "simulated") return "a simulated run";
  if (layer.timeline->origin == "measured") return "a measured run";
  return "a run";
}

std::string both(const Layer& proved, const Layer& measured) {
  std::string text;
  const auto length = [](const Highlight& it) { return it.to_ns - it.from_ns; };
  if (!proved.options->caption.proved.empty()) {
    text = "proved " + proved.options->caption.proved;
  } else if (proved.options->highlight) {
    text = "proved " + duration_text(length(*proved.options->highlight));
  }
  if (measured.options->highlight) {
    text += (text.empty() ? "" : ", ") +
            ("measured " + rounded_duration_text(length(*measured.options->highlight)));
  }
  if (!proved.options->caption.limit.empty()) text += ", limit " + proved.options->caption.limit;
  return text;
}

}  // namespace

std::vector<std::string> caption_lines(const std::vector<Layer>& layers) {
  const Layer& first = layers.front();
  const Caption& caption = first.options->caption;
  const bool overlay = layers.size() > 1;
  std::vector<std::string> lines;
  std::string title = subject(first);
  if (!caption.requirement.empty()) title += ": " + caption.requirement;
  if (!caption.verdict.empty()) title += " " + caption.verdict;
  lines.push_back(title);
  std::string second = overlay ? "a measured run over the proved one" : run_of(first);
  if (!caption.measure.empty()) second = caption.measure + "; " + second;
  lines.push_back(second);
  const std::string third = overlay ? both(first, layers.back()) : caption.figures;
  if (!third.empty()) lines.push_back(third);
  return lines;
}

Length draw_caption(const std::vector<Layer>& layers, Length top, SvgWriter& out) {
  const std::vector<std::string> lines = caption_lines(layers);
  Length y = top + 190;
  const std::string& verdict = layers.front().options->caption.verdict;
  const Length width = panel_right(layers) - left_edge;
  for (const std::string& line : wrapped(lines.front(), 165, width, true)) {
    if (y > top + 190) y += 30;
    out.text({left_edge, y}, Anchor::start, verdict == "fails" ? "title fails" : "title", line);
    y += 150;
  }
  y -= 150;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    for (const std::string& line : wrapped(lines[i], 115, width, i == 2)) {
      y += 150;
      out.text({left_edge, y}, Anchor::start, i == 2 ? "subtitle strong" : "subtitle", line);
    }
  }
  return y + 60;
}

Length draw_panel_heading(const std::string& text, Length top, SvgWriter& out) {
  out.text({left_edge, top + 150}, Anchor::start, "heading", text);
  return top + 120;
}

}  // namespace pal::analyzer::chart
