#include "language_server/repair.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "pal/check/read_sources.hpp"
#include "pal/check/rules/layers.hpp"
#include "pal/rewrite/placing.hpp"
#include "pal/support/edit.hpp"

namespace pal::language_server {

namespace {

/// One file with another text.
class Edited : public FileSystem {
 public:
  Edited(const FileSystem& files, std::map<std::string, std::string> texts)
      : files_(files), texts_(std::move(texts)) {}

  std::variant<std::string, FileError> read(const std::string& path, std::size_t most) const override {
    const auto found = texts_.find(path);
    return found == texts_.end() ? files_.read(path, most) : found->second;
  }
  std::string identity(const std::string& path) const override { return files_.identity(path); }

 private:
  const FileSystem& files_;
  std::map<std::string, std::string> texts_;
};

/// A statement with its neighbours.
struct Found {
  const syntax::ModuleUnit* module = nullptr;
  const syntax::Statements* list = nullptr;
  std::size_t index = 0;

  const syntax::Statement& statement() const { return (*list)[index]; }
};

std::optional<Found> statement_at(const std::vector<syntax::Tree>& trees, const SourceSpan& where) {
  std::optional<Found> found;
  for (const auto& tree : trees) {
    if (!where.valid() || tree.file != where.file) continue;
    rewrite::visit_lists(tree, [&](const syntax::ModuleUnit& module, const syntax::Statements& list) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i].where.begin <= where.begin && where.begin < list[i].where.end)
          found = Found{&module, &list, i};
      }
    });
  }
  return found;
}

const syntax::PartyName* party_of(const syntax::Statement& statement) {
  if (const auto* send = std::get_if<syntax::Send>(&statement.content)) return &send->to;
  if (const auto* wait = std::get_if<syntax::Wait>(&statement.content)) return &wait->source.from;
  return nullptr;
}

bool is_message(const syntax::Statement& statement) {
  return std::holds_alternative<syntax::Send>(statement.content) ||
         std::holds_alternative<syntax::Wait>(statement.content);
}

class Search {
 public:
  Search(const FileSystem& files, const Analysis& analysis, const Diagnostic& finding, double seconds)
      : files_(files),
        analysis_(analysis),
        finding_(finding),
        end_(std::chrono::steady_clock::now() +
             std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                 std::chrono::duration<double>(seconds))) {
    for (const auto& each : analysis.diagnostics.all()) before_.insert({each.code, each.message});
    // The same files in the same order as in the analysis, so the places are the same.
    SourceManager sources;
    Diagnostics again;
    trees_ = check::read_sources(files, sources, analysis.inputs, again);
  }

  std::vector<Repair> run() {
    const auto place = statement_at(trees_, finding_.where);
    if (!place || !before_.contains({finding_.code, finding_.message})) return {};
    std::vector<Found> places{*place};
    for (const auto& note : finding_.notes) {
      const auto other = statement_at(trees_, note.where);
      if (other && std::none_of(places.begin(), places.end(), [&](const Found& each) {
            return each.list == other->list && each.index == other->index;
          }))
        places.push_back(*other);
    }
    other_parties(*place);
    ask_first(*place);
    for (const auto& each : places) exchange(each);
    take_elsewhere(*place);
    send_elsewhere(*place);
    for (const auto& each : places) remove(each);
    return std::move(found_);
  }

 private:
  bool is_over() const { return std::chrono::steady_clock::now() > end_ || found_.size() >= 4; }

  rewrite::Placing placing(const Found& at) const {
    return rewrite::Placing(analysis_.sources.text(at.statement().where.file));
  }

  /// The statement says another module or device.
  void other_parties(const Found& at) {
    const auto* party = party_of(at.statement());
    if (party == nullptr) return;
    std::set<std::string> names;
    for (const auto& skill : analysis_.specification.skills) {
      for (const auto& module : skill.modules) {
        if (check::may_talk(check::layer_of(at.module->kind), check::layer_of(module.kind)))
          names.insert(module.name);
      }
      for (const auto& device : skill.devices) {
        if (check::may_talk(check::layer_of(at.module->kind), check::layer_of(std::nullopt)))
          names.insert(device.name);
      }
    }
    names.erase(party->name.text);
    names.erase(at.module->name.text);
    for (const auto& name : names)
      attempt("replace '" + std::string(analysis_.sources.text(party->where)) + "' by '" + name + "'",
              {{party->where, name}});
  }

  /// A wait asks before it waits; or what is sent elsewhere in the module to the same party is sent again.
  void ask_first(const Found& at) {
    const auto* wait = std::get_if<syntax::Wait>(&at.statement().content);
    if (wait == nullptr) return;
    const auto put = placing(at);
    std::set<std::string> sent;
    if (!wait->source.message.request)
      sent.insert("TXM( request " + wait->source.message.name.text + " from " + wait->source.from.name.text +
                  " )");
    rewrite::visit_lists(at.module->body, [&](const syntax::Statements& list) {
      for (const auto& each : list) {
        const auto* send = std::get_if<syntax::Send>(&each.content);
        if (send != nullptr && send->to.name.text == wait->source.from.name.text)
          sent.insert(put.words(each));
      }
    });
    for (const auto& words : sent)
      attempt("insert " + words + " before " + put.words(at.statement()),
              {put.before(at.statement(), words)});
  }

  /// The statement changes places with its neighbours.
  void exchange(const Found& at) {
    const auto put = placing(at);
    const auto swap = [&](std::size_t first) {
      if (first + 1 >= at.list->size()) return;
      const auto& a = (*at.list)[first];
      const auto& b = (*at.list)[first + 1];
      if (a.end.valid() || b.end.valid() || !(is_message(a) || is_message(b))) return;
      attempt(put.words(b) + " before " + put.words(a),
              {put.instead(a, put.words(b)), put.instead(b, put.words(a))});
    };
    if (at.index > 0) swap(at.index - 1);
    swap(at.index);
  }

  /// What is sent and never taken is taken: somewhere in the module that it goes to.
  void take_elsewhere(const Found& at) {
    const auto* send = std::get_if<syntax::Send>(&at.statement().content);
    if (send == nullptr) return;
    const std::string words = std::string("WTM( ") + (send->message.request ? "request " : "") +
                              send->message.name.text + " from " + at.module->name.text + " )";
    insert_in(send->to.name.text, words);
  }

  /// What is waited for and never sent is sent: somewhere in the module that it is to come from.
  void send_elsewhere(const Found& at) {
    const auto* wait = std::get_if<syntax::Wait>(&at.statement().content);
    if (wait == nullptr) return;
    const bool request = wait->source.message.request;
    const std::string words = std::string("TXM( ") + (request ? "request " : "") +
                              wait->source.message.name.text + (request ? " from " : " to ") +
                              at.module->name.text + " )";
    insert_in(wait->source.from.name.text, words);
  }

  /// Before each statement of a module but the wait for its start.
  void insert_in(const std::string& name, const std::string& words) {
    for (const auto& tree : trees_) {
      const rewrite::Placing put(analysis_.sources.text(tree.file));
      rewrite::visit_lists(tree, [&](const syntax::ModuleUnit& module, const syntax::Statements& list) {
        for (std::size_t i = 0; module.name.text == name && i < list.size(); ++i) {
          if (!std::holds_alternative<syntax::WaitForStart>(list[i].content))
            attempt("in " + name + ": insert " + words + " before " + put.words(list[i]),
                    {put.before(list[i], words)});
        }
      });
    }
  }

  void remove(const Found& at) {
    if (at.statement().end.valid() || at.list->size() < 2) return;
    attempt("remove " + placing(at).words(at.statement()), {placing(at).without(at.statement())});
  }

  /// Keeps the change if the finding is gone with it, and nothing else has come.
  void attempt(std::string title, std::vector<Edit> edits) {
    if (is_over()) return;
    const FileId file = edits.front().where.file;
    const auto& path = analysis_.sources.name(file);
    const Edited files(files_, {{path, apply(edits, file, analysis_.sources.text(file))}});
    SourceManager sources;
    Diagnostics diagnostics;
    const auto trees = check::read_sources(files, sources, analysis_.inputs, diagnostics);
    check::check(trees, diagnostics, [this] { return std::chrono::steady_clock::now() > end_; });
    if (std::chrono::steady_clock::now() > end_) return;  // not all was checked
    bool gone = true;
    for (const auto& each : diagnostics.all()) {
      const bool same = each.code == finding_.code && each.message == finding_.message;
      if (same || !before_.contains({each.code, each.message})) gone = false;
    }
    if (gone) found_.push_back({std::move(title), std::move(edits)});
  }

  const FileSystem& files_;
  const Analysis& analysis_;
  const Diagnostic& finding_;
  const std::chrono::steady_clock::time_point end_;
  std::set<std::pair<Code, std::string>> before_;
  std::vector<syntax::Tree> trees_;
  std::vector<Repair> found_;
};

}  // namespace

std::vector<Repair> repairs(const FileSystem& files, const Analysis& analysis, const Diagnostic& finding,
                            double seconds) {
  return Search(files, analysis, finding, seconds).run();
}

}  // namespace pal::language_server
