// pal sequence: runs into deadlocks as message sequence charts.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <ostream>

#include "analyzer/chart/sequence.hpp"
#include "pal/check/deadlock/stories.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {
namespace {

using check::deadlock::Action;
using check::deadlock::Story;

/// From the run of a story to its chart.
class Converter {
 public:
  Converter(const Story& story, const pan::Network& network, const SourceManager& sources)
      : story_(story), network_(network), sources_(sources) {}

  analyzer::chart::SequenceChart convert() {
    heading();
    lanes();
    for (const auto& line : story_.run) add(line);
    for (const auto& stuck : story_.stuck) {
      chart_.stops.push_back({lane(story_.lanes[stuck.lane]), stuck.text, place(stuck.where)});
    }
    return std::move(chart_);
  }

 private:
  void heading() {
    const auto& name = network_.skill.name;
    if (story_.undelivered) {
      const auto& channel = network_.channels[story_.undelivered->index()];
      chart_.title =
          fmt::format("{}: complete before {} has taken {}", name, party_name(network_, channel.receiver),
                      network_.messages[channel.message.index()].name);
    } else {
      chart_.title = name + (story_.total ? ": no module goes on" : ": the skill never ends");
    }
    chart_.subtitle = fmt::format("a shortest run, {} steps{}", story_.run.size(),
                                  story_.timely ? "; only if times are unlucky" : "");
  }

  /// Those that the run is about, in the order of the skill; devices last.
  void lanes() {
    std::vector<bool> used(story_.lanes.size(), false);
    std::vector<std::string> devices;
    const auto use = [&](const std::string& name) {
      for (std::size_t i = 0; i < used.size(); ++i) used[i] = used[i] || story_.lanes[i] == name;
    };
    for (const auto& stuck : story_.stuck) used[stuck.lane] = true;
    for (const auto& line : story_.run) {
      used[line.lane] = true;
      if (!line.channel) continue;
      const auto& channel = network_.channels[line.channel->index()];
      for (const auto& party : {channel.sender, channel.receiver}) {
        const auto& name = party_name(network_, party);
        if (!is_outside(party)) {
          use(name);
        } else if (std::find(devices.begin(), devices.end(), name) == devices.end()) {
          devices.push_back(name);
        }
      }
    }
    // The blocks of a module beside it.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < used.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return root(a) < root(b); });
    for (const auto i : order) {
      if (!used[i]) continue;
      chart_.lanes.push_back(
          {story_.lanes[i], kind_text(network_.modules[story_.modules[i].index()].kind), false});
    }
    for (const auto& name : devices) chart_.lanes.push_back({name, "device", true});
  }

  /// The first thread of the same module.
  std::size_t root(std::size_t thread) const {
    std::size_t first = 0;
    while (story_.modules[first] != story_.modules[thread]) ++first;
    return first;
  }

  bool is_outside(const pan::Party& party) const {
    const auto* module = std::get_if<pan::ModuleId>(&party);
    return module == nullptr || network_.modules[module->index()].body.empty();
  }

  std::size_t lane(const std::string& name) const {
    const auto found =
        std::find_if(chart_.lanes.begin(), chart_.lanes.end(), [&](const auto& l) { return l.name == name; });
    return static_cast<std::size_t>(found - chart_.lanes.begin());
  }

  std::string place(SourceSpan where) const {
    if (!where.valid()) return {};
    const auto& path = sources_.name(where.file);
    const auto slash = path.find_last_of('/');
    return fmt::format("{}:{}", slash == std::string::npos ? path : path.substr(slash + 1),
                       sources_.line_column(where.file, where.begin).line);
  }

  void add(const check::deadlock::Line& line) {
    const auto row = chart_.places.size();
    chart_.places.push_back(place(line.where));
    const auto self = lane(line.thread);
    if (!line.channel || line.kind == Action::Kind::discards) {
      chart_.notes.push_back({self, row, line.text});
      return;
    }
    const auto& channel = network_.channels[line.channel->index()];
    const auto& label = network_.messages[channel.message.index()].name;
    if (line.kind == Action::Kind::sends) {
      const auto to = lane(party_name(network_, channel.receiver));
      chart_.messages.push_back({self, row, to, std::nullopt, label});
      if (is_outside(channel.receiver)) {
        chart_.messages.back().to_row = row;
      } else {
        on_its_way_[*line.channel].push_back(chart_.messages.size() - 1);
      }
    } else if (is_outside(channel.sender)) {
      chart_.messages.push_back({lane(party_name(network_, channel.sender)), row, self, row, label});
    } else if (auto& sent = on_its_way_[*line.channel]; !sent.empty()) {
      // One that was withdrawn before is not the one that is taken.
      auto& message = chart_.messages[sent.back()];
      sent.clear();
      message.to_row = row;
      message.to_lane = self;
    }
  }

  const Story& story_;
  const pan::Network& network_;
  const SourceManager& sources_;
  analyzer::chart::SequenceChart chart_;
  std::map<pan::ChannelId, std::deque<std::size_t>> on_its_way_;
};

/// No errors but those that the charts show.
bool sound(const Session& session) {
  const auto& all = session.diagnostics.all();
  if (session.diagnostics.not_kept().errors != 0) return false;
  return std::none_of(all.begin(), all.end(), [](const Diagnostic& finding) {
    return finding.severity == Severity::error && finding.code != Code::PAL0521 &&
           finding.code != Code::PAL0522;
  });
}

}  // namespace

ExitStatus draw_sequences(const SequenceOptions& options, const Console& console) {
  Session session;
  const bool chosen = read(options.selection, console, session);
  show_findings(session, console);
  if (!chosen) return ExitStatus::usage;
  if (!sound(session)) return status_of_findings(session);
  std::vector<OutputFile> files;
  for (const pan::Network& skill : session.specification.skills) {
    const auto stories = check::deadlock::stories(skill);
    for (std::size_t i = 0; i < stories.size(); ++i) {
      files.push_back(
          {fmt::format("{}/{}.{}.sequence.svg", options.output, skill.skill.name, i + 1),
           analyzer::chart::sequence_svg(Converter(stories[i], skill, session.sources).convert())});
    }
  }
  if (files.empty()) {
    console.out << "no run stands still, or leaves a command undelivered\n";
    return ExitStatus::all_hold;
  }
  return write_and_list(files, inputs_of(session), console);
}

}  // namespace pal::program
