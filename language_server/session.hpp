// One client's session, message by message, on one thread. Private to language_server: shows nlohmann's JSON.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "language_server/analysis.hpp"
#include "language_server/index.hpp"
#include "language_server/json.hpp"
#include "language_server/server.hpp"
#include "language_server/workspace.hpp"
#include "operations/check.hpp"

namespace pal::language_server {

/// The proofs of one file's skills, to be made on another thread.
struct ProofJob {
  std::shared_ptr<const Analysis> analysis;
  std::uint64_t revision = 0;  // of the workspace, when it was asked for
  double seconds = 0;
};

/// What is known of a file with skills.
struct Known {
  std::shared_ptr<const Analysis> analysis;  // of the present text
  std::shared_ptr<const Analysis> sound;     // the last one without errors
  std::shared_ptr<const Analysis> proved;    // the one that `proofs` are of
  std::shared_ptr<const Proofs> proofs;
  std::shared_ptr<const Proofs> under_way;  // of `analysis`, while its proof goes on; else nullptr
  std::shared_ptr<const AllAdvice> advice;  // of `proved`; nullptr: not yet

  /// What is known of the requirements of the present text: nullptr if nothing is.
  const Proofs* current() const {
    return proved == analysis && proofs != nullptr ? proofs.get() : under_way.get();
  }
  std::vector<std::string> inputs;  // the files that an analysis begins with
  std::uint64_t inputs_of = 0;      // the structure of the workspace that they are of
};

/// Whether the name is that of a file of operations.
bool is_operation(const std::string& path);

class Session {
 public:
  using Send = std::function<void(const Json& message)>;

  Session(const FileSystem& disk, const Options& options, Send send)
      : workspace_(disk), index_(workspace_), options_(options), send_(std::move(send)) {}

  /// Handles one message: answers a request, or takes a notification. `cancelled`: the client wants no
  /// answer.
  void receive(const Json& message, bool cancelled = false);

  /// Checks what has changed and publishes its findings. Once `newer` says that a message waits, the rest is
  /// left for the next call. Whether all is done.
  bool check(const std::function<bool()>& newer);
  /// Whether check() has something to do.
  bool has_to_check() const { return !to_check_.empty(); }

  /// The proofs to be made for what was checked; earlier ones are of no use any more.
  std::vector<ProofJob> take_jobs();
  void proved(const ProofJob& job, Proofs proofs);
  /// What is known while the proof goes on.
  void told(const ProofJob& job, Proofs proofs);
  void advised(const ProofJob& job, AllAdvice advice);
  /// The client is told that a proof goes on, and that it has ended.
  void show_progress(const ProofJob& job);
  void hide_progress();

  /// After the notification `exit`.
  bool is_over() const { return over_; }
  bool was_shut_down() const { return shut_down_; }

 private:
  using Handler = Json (Session::*)(const Json& params);
  static const std::map<std::string, Handler>& requests();
  static const std::map<std::string, void (Session::*)(const Json& params)>& notifications();

  // session.cpp
  Json initialize(const Json& params);
  Json shutdown(const Json& params);
  void initialized(const Json& params);
  void exit(const Json& params);
  void did_open(const Json& params);
  void did_change(const Json& params);
  void did_close(const Json& params);
  void did_save(const Json& params);
  void did_change_watched(const Json& params);
  void did_change_configuration(const Json& params);
  void did_change_folders(const Json& params);
  void ignore(const Json&) {}
  void configure(const Json& settings);
  void notify(const char* method, Json params) {
    send_({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
  }
  void ask_client(const char* method, Json params);
  /// The path of a document; refuses what is no file.
  std::string path_in(const Json& params) const;
  /// … that can be read, and the byte at its position.
  struct Place {
    std::string path;
    std::shared_ptr<const Text> text;
    std::uint32_t offset = 0;
  };
  Place place_in(const Json& params) const;
  Json location(const SourceSpan& where) const;  // of the index

  // findings.cpp
  std::vector<std::string> roots_of(const std::string& path);
  /// The same of all open texts of PAL at once.
  std::map<std::string, std::vector<std::string>> roots_of_open();
  /// Up to date, also if it was not checked yet.
  const Known& known(const std::string& root);
  void publish();
  std::vector<Diagnostic> findings(const Known& known, const std::string& path) const;
  std::vector<Diagnostic> causes(const Known& known, const std::string& path) const;
  Json code_action(const Json& params);
  void tell_changed(const char* what);

  // navigation.cpp
  Json definition(const Json& params);
  Json references(const Json& params);
  Json document_highlight(const Json& params);
  Json prepare_rename(const Json& params);
  Json rename(const Json& params);
  std::vector<std::size_t> symbols_at(const Place& place, std::shared_ptr<const Family>& family);
  std::vector<SourceSpan> uses_of(const Place& place, bool declarations);

  // operation_file.cpp
  /// The templates of all skills of the workspace.
  const operations::Skills& skills();
  /// `sources` gets the texts that the places are of.
  std::vector<Diagnostic> operation_findings(const std::string& path, SourceManager& sources);
  Json operation_diagnostic(const Diagnostic& finding, const SourceManager& sources) const;  // findings.cpp
  Json operation_actions(const std::string& path, const Text& text, std::uint32_t begin, std::uint32_t end);
  Json operation_completion(const Place& place);
  Json operation_hover(const Place& place);

  // message_flow.cpp
  Json signature_help(const Json& params);
  Json prepare_call_hierarchy(const Json& params);
  Json incoming_calls(const Json& params);
  Json outgoing_calls(const Json& params);

  // selection.cpp
  Json selection_range(const Json& params);
  Json on_type_formatting(const Json& params);

  // outline.cpp
  Json document_symbol(const Json& params);
  Json workspace_symbol(const Json& params);
  Json folding_range(const Json& params);
  Json document_link(const Json& params);
  Json semantic_tokens(const Json& params);

  // hover.cpp
  Json hover(const Json& params);
  std::string about(const check::Symbol& symbol, const Family& family);
  std::string pages_at(const Place& place);

  // completion.cpp
  Json completion(const Json& params);

  // layout.cpp
  Json formatting(const Json& params);
  Json range_formatting(const Json& params);

  // proof_view.cpp
  Json inlay_hint(const Json& params);
  void add_bounds(const Known& known, const std::string& path, const Text& text, Json& hints);
  void add_slacks(const Known& known, const std::string& path, Json& hints) const;
  void add_shares(const Known& known, const std::string& path, Json& hints) const;
  Json code_lens(const Json& params);
  Json requirements(const Json& params);
  Json picture(const Json& params);
  Json pan_picture(const Json& params);
  Json atc_picture(const Json& params);

  Workspace workspace_;
  Index index_;
  Options options_;
  Send send_;
  bool initialized_ = false;
  bool shut_down_ = false;
  bool over_ = false;

  // The client: what it can, and its settings.
  bool progress_ = false, watches_ = false, refreshes_hints_ = false, refreshes_lenses_ = false,
       snippets_ = false;
  std::vector<std::string> environments_;
  double proof_seconds_ = 2;
  bool hints_ = true, pictures_ = false;
  std::set<std::string> commands_;
  int asked_ = 0;

  std::map<std::string, Known> known_;  // by root
  /// What the client shows: by path the version, and what the findings are from.
  struct Published {
    std::int64_t version = -1;
    std::vector<std::shared_ptr<const void>> from;
    friend bool operator==(const Published&, const Published&) = default;
  };
  std::map<std::string, Published> published_;
  std::set<std::string> to_check_;  // open files
  std::vector<ProofJob> jobs_;
  operations::Skills templates_;
  std::uint64_t templates_of_ = 0;  // the revision of the workspace that they are of
  std::map<std::string, std::pair<std::uint64_t, std::vector<pan::Template>>> templates_by_file_;
  std::string progress_shown_;  // its token; empty: none
};

}  // namespace pal::language_server
