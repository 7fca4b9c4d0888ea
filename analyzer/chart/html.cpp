#include "analyzer/chart/html.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "analyzer/chart/viewer.hpp"
#include "pal/support/xml.hpp"

namespace pal::analyzer::chart {

namespace {

using Json = nlohmann::ordered_json;

const char* name(BarKind kind) {
  switch (kind) {
    case BarKind::computation:
      return "computation";
    case BarKind::message:
      return "message";
    case BarKind::condition:
      return "condition";
    case BarKind::serving:
      return "serving";
  }
  return "";
}

const char* name(Fate fate) {
  switch (fate) {
    case Fate::taken:
      return "taken";
    case Fate::dropped:
      return "dropped";
    case Fate::undelivered:
      return "undelivered";
  }
  return "";
}

const char* name(MarkKind kind) {
  switch (kind) {
    case MarkKind::event:
      return "event";
    case MarkKind::overrun:
      return "overrun";
    case MarkKind::gave_up:
      return "gave-up";
    case MarkKind::cancelled:
      return "cancelled";
    case MarkKind::completion:
      return "completion";
    case MarkKind::fault:
      return "fault";
    case MarkKind::broken:
      return "broken";
  }
  return "";
}

/// The statements of a run, each once.
class Texts {
 public:
  std::size_t number(const Bar& bar) {
    const std::string place = bar.line > 0 ? bar.file + ":" + std::to_string(bar.line) : "";
    const auto [found, is_new] = numbers_.try_emplace({bar.text, place}, numbers_.size());
    if (is_new) rows_.push_back({{"text", bar.text}, {"place", place}});
    return found->second;
  }
  Json rows() const { return rows_; }

 private:
  std::map<std::pair<std::string, std::string>, std::size_t> numbers_;
  Json rows_ = Json::array();
};

Json lane_json(const Lane& lane, Texts& texts) {
  Json bars = Json::array();
  for (const Bar& bar : lane.bars) {
    const int flags = (bar.resumed ? 1 : 0) + (bar.finished ? 0 : 2);
    bars.push_back({bar.from_ns, bar.to_ns, name(bar.kind), texts.number(bar), flags});
  }
  Json gaps = Json::array();
  for (const Gap& gap : lane.gaps) {
    const char* kind = gap.kind == GapKind::ready ? "ready" : "waiting";
    gaps.push_back({gap.from_ns, gap.to_ns, kind, gap.text, gap.gave_up});
  }
  return {{"name", lane.name},         {"device", lane.device}, {"processor", lane.processor},
          {"priority", lane.priority}, {"bars", bars},          {"gaps", gaps}};
}

Json samples_json(const std::vector<Sample>& samples) {
  Json rows = Json::array();
  for (const Sample& it : samples) rows.push_back({it.at_ns, it.value, it.lane});
  return rows;
}

Json run_json(const Timeline& run) {
  Texts texts;
  Json lanes = Json::array();
  for (const Lane& lane : run.lanes) lanes.push_back(lane_json(lane, texts));
  Json arrows = Json::array();
  for (const Arrow& it : run.arrows)
    arrows.push_back(
        {it.from_lane, it.from_ns, it.to_lane, it.to_ns, it.taken_ns, it.message, name(it.fate)});
  Json waves = Json::array();
  for (const Waveform& it : run.waveforms)
    waves.push_back({{"name", it.name}, {"sets", samples_json(it.sets)}, {"reads", samples_json(it.reads)}});
  Json marks = Json::array();
  for (const Mark& it : run.marks) marks.push_back({it.at_ns, name(it.kind), it.lane, it.text});
  return {{"end", run.end_ns}, {"texts", texts.rows()}, {"lanes", lanes},
          {"arrows", arrows},  {"waves", waves},        {"marks", marks}};
}

Json part_json(const Part& part) {
  Json inside = Json::array();
  for (const Part& each : part.inside) inside.push_back(part_json(each));
  const Segment& it = part.segment;
  return {{"from", it.from_ns}, {"to", it.to_ns},    {"text", it.text},
          {"actor", it.actor},  {"place", it.place}, {"inside", inside}};
}

Json view_json(const View& view) {
  Json highlight;
  if (view.highlight) {
    const Highlight& it = *view.highlight;
    highlight = {{"from", it.from_ns},
                 {"to", it.to_ns},
                 {"label", it.label},
                 {"fails", it.fails},
                 {"limit", it.limit_ns}};
  }
  Json losses = Json::array();
  for (const Loss& it : view.losses)
    losses.push_back({{"lane", it.lane}, {"from", it.from_ns}, {"to", it.to_ns}, {"text", it.text}});
  Json why = Json::array();
  for (const Part& part : view.why) why.push_back(part_json(part));
  Json window;
  if (view.window) window = Json::array({view.window->from_ns, view.window->to_ns});
  return {{"name", view.name}, {"run", view.run}, {"highlight", highlight},
          {"losses", losses},  {"why", why},      {"window", window}};
}

Json subject_json(const Subject& subject) {
  Json views = Json::array();
  for (const View& view : subject.views) views.push_back(view_json(view));
  const Caption& it = subject.caption;
  return {{"skill", subject.skill}, {"environment", subject.environment},
          {"name", it.requirement}, {"verdict", it.verdict},
          {"measure", it.measure},  {"figures", it.figures},
          {"brief", subject.brief}, {"views", views}};
}

std::string data(const Book& book) {
  Json document{{"first", book.first}, {"requirements", Json::array()}, {"runs", Json::array()}};
  for (const Subject& subject : book.subjects) document["requirements"].push_back(subject_json(subject));
  for (const Timeline& run : book.runs) document["runs"].push_back(run_json(run));
  const std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  // No text of the program may end the script: in JSON, "<" stands in strings only. Nor does a page hold
  // U+FFFE and U+FFFF.
  std::string safe;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '<') {
      safe += "\\u003c";
    } else if (text.compare(at, 3, "\xEF\xBF\xBE") == 0 || text.compare(at, 3, "\xEF\xBF\xBF") == 0) {
      safe += text[at + 2] == '\xBE' ? "\\ufffe" : "\\uffff";
      at += 2;
    } else {
      safe += text[at];
    }
  }
  return safe;
}

}  // namespace

std::string html(const Book& book) {
  std::string page;
  std::string_view rest = viewer::page;
  for (std::size_t at = rest.find('@'); at != std::string_view::npos; at = rest.find('@')) {
    const std::size_t end = rest.find('@', at + 1);
    const std::string_view name = rest.substr(at + 1, end - at - 1);
    page += rest.substr(0, at);
    if (name == "TITLE") page += xml_escaped(book.title);
    if (name == "STYLE") page += viewer::style;
    if (name == "SCRIPT") page += viewer::script;
    if (name == "DATA") page += data(book);
    rest.remove_prefix(end + 1);
  }
  return page += rest;
}

}  // namespace pal::analyzer::chart
