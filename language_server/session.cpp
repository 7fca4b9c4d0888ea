// The life of a session, and its texts.
#include "language_server/session.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "language_server/semantic_legend.hpp"
#include "language_server/uri.hpp"

namespace pal::language_server {

namespace {

bool can(const Json& capabilities, std::initializer_list<const char*> names) {
  const Json* at = &capabilities;
  for (const char* each : names) at = &member(*at, each);
  return at->is_boolean() && at->get<bool>();
}

Json capabilities() {
  return {
      {"positionEncoding", "utf-16"},
      {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}}},
      {"workspace", {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}}}},
      {"hoverProvider", true},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"documentSymbolProvider", true},
      {"workspaceSymbolProvider", true},
      {"foldingRangeProvider", true},
      {"documentLinkProvider", {{"resolveProvider", false}}},
      {"codeActionProvider", {{"codeActionKinds", {"quickfix", "source.fixAll.pal"}}}},
      {"completionProvider", {{"triggerCharacters", {"(", " ", "\""}}, {"resolveProvider", false}}},
      {"documentFormattingProvider", true},
      {"documentRangeFormattingProvider", true},
      {"documentOnTypeFormattingProvider", {{"firstTriggerCharacter", "\n"}}},
      {"signatureHelpProvider", {{"triggerCharacters", {"(", " "}}}},
      {"callHierarchyProvider", true},
      {"selectionRangeProvider", true},
      {"inlayHintProvider", true},
      {"codeLensProvider", {{"resolveProvider", false}}},
      {"semanticTokensProvider",
       {{"legend", {{"tokenTypes", token_types()}, {"tokenModifiers", token_modifiers()}}}, {"full", true}}},
  };
}

}  // namespace

const std::map<std::string, Session::Handler>& Session::requests() {
  static const std::map<std::string, Handler> table{
      {"initialize", &Session::initialize},
      {"shutdown", &Session::shutdown},
      {"textDocument/codeAction", &Session::code_action},
      {"textDocument/definition", &Session::definition},
      {"textDocument/references", &Session::references},
      {"textDocument/documentHighlight", &Session::document_highlight},
      {"textDocument/prepareRename", &Session::prepare_rename},
      {"textDocument/rename", &Session::rename},
      {"textDocument/documentSymbol", &Session::document_symbol},
      {"workspace/symbol", &Session::workspace_symbol},
      {"textDocument/foldingRange", &Session::folding_range},
      {"textDocument/documentLink", &Session::document_link},
      {"textDocument/semanticTokens/full", &Session::semantic_tokens},
      {"textDocument/hover", &Session::hover},
      {"textDocument/completion", &Session::completion},
      {"textDocument/formatting", &Session::formatting},
      {"textDocument/rangeFormatting", &Session::range_formatting},
      {"textDocument/onTypeFormatting", &Session::on_type_formatting},
      {"textDocument/signatureHelp", &Session::signature_help},
      {"textDocument/prepareCallHierarchy", &Session::prepare_call_hierarchy},
      {"callHierarchy/incomingCalls", &Session::incoming_calls},
      {"callHierarchy/outgoingCalls", &Session::outgoing_calls},
      {"textDocument/selectionRange", &Session::selection_range},
      {"textDocument/inlayHint", &Session::inlay_hint},
      {"textDocument/codeLens", &Session::code_lens},
      {"pal/requirements", &Session::requirements},
      {"pal/picture", &Session::picture},
  };
  return table;
}

const std::map<std::string, void (Session::*)(const Json&)>& Session::notifications() {
  static const std::map<std::string, void (Session::*)(const Json&)> table{
      {"initialized", &Session::initialized},
      {"exit", &Session::exit},
      {"textDocument/didOpen", &Session::did_open},
      {"textDocument/didChange", &Session::did_change},
      {"textDocument/didClose", &Session::did_close},
      {"textDocument/didSave", &Session::did_save},
      {"workspace/didChangeWatchedFiles", &Session::did_change_watched},
      {"workspace/didChangeConfiguration", &Session::did_change_configuration},
      {"workspace/didChangeWorkspaceFolders", &Session::did_change_folders},
      {"$/cancelRequest", &Session::ignore},  // the reader has seen to it
      {"$/setTrace", &Session::ignore},
      {"window/workDoneProgress/cancel", &Session::ignore},  // the next text ends it
  };
  return table;
}

void Session::receive(const Json& message, bool cancelled) {
  const Json& id = member(message, "id");
  const Json& method = member(message, "method");
  const auto refuse = [&](int code, const std::string& text) {
    send_({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", text}}}});
  };
  const bool is_answer = !member(message, "result").is_null() || !member(message, "error").is_null();
  if (!method.is_string()) {
    if (!is_answer && !(message.is_object() && message.contains("result")))
      refuse(invalid_request, "a message needs a method");
    return;
  }
  const auto name = method.get<std::string>();
  const Json& params = member(message, "params");
  if (id.is_null()) {
    const auto handler = notifications().find(name);
    if (handler == notifications().end() || (!initialized_ && name != "exit")) return;
    try {
      (this->*handler->second)(params);
    } catch (const Refusal&) {  // a notification gets no answer
    } catch (const Json::exception&) {
    }
    return;
  }
  if (cancelled) return refuse(request_cancelled, "the client cancelled this");
  if (!initialized_ && name != "initialize")
    return refuse(server_not_initialized, "the first request must be initialize");
  if (shut_down_ || (initialized_ && name == "initialize"))
    return refuse(invalid_request, shut_down_ ? "the server is shut down" : "initialize comes once");
  const std::string document = string_of(member(params, "textDocument"), "uri");
  static const std::set<std::string> of_operations{"textDocument/hover", "textDocument/completion",
                                                   "textDocument/codeAction"};
  if (is_operation(document) && requests().contains(name) && !of_operations.contains(name))
    return send_({{"jsonrpc", "2.0"}, {"id", id}, {"result", nullptr}});  // it is no text of PAL
  const auto handler = requests().find(name);
  if (handler == requests().end()) return refuse(method_not_found, "there is no request '" + name + "'");
  try {
    Json result = (this->*handler->second)(params);
    send_({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
  } catch (const Refusal& refusal) {
    refuse(refusal.code, refusal.message);
  } catch (const Json::exception& error) {
    refuse(invalid_params, error.what());
  } catch (const std::exception& error) {
    refuse(internal_error, error.what());
  }
}

Json Session::initialize(const Json& params) {
  const Json& client = member(params, "capabilities");
  progress_ = can(client, {"window", "workDoneProgress"});
  watches_ = can(client, {"workspace", "didChangeWatchedFiles", "dynamicRegistration"});
  refreshes_hints_ = can(client, {"workspace", "inlayHint", "refreshSupport"});
  refreshes_lenses_ = can(client, {"workspace", "codeLens", "refreshSupport"});
  snippets_ = can(client, {"textDocument", "completion", "completionItem", "snippetSupport"});
  std::vector<std::string> folders;
  const auto add = [&](const Json& uri) {
    if (!uri.is_string()) return;
    if (auto path = path_of(uri.get<std::string>())) folders.push_back(std::move(*path));
  };
  for (const Json& folder : member(params, "workspaceFolders")) add(member(folder, "uri"));
  if (folders.empty()) add(member(params, "rootUri"));
  workspace_.set_folders(std::move(folders));
  configure(member(params, "initializationOptions"));
  initialized_ = true;
  return {{"capabilities", capabilities()}, {"serverInfo", {{"name", "pal"}, {"version", options_.version}}}};
}

void Session::configure(const Json& settings) {
  if (!settings.is_object()) return;
  if (const Json& files = member(settings, "environments"); files.is_array()) {
    environments_.clear();
    for (auto& [root, known] : known_) known.inputs_of = 0;
    const std::string top = workspace_.folders().empty() ? std::string("/") : workspace_.folders().front();
    for (const Json& file : files) {
      if (file.is_string()) environments_.push_back(resolve_path(top + "/x", file.get<std::string>()));
    }
  }
  if (const Json& seconds = member(settings, "proofTimeSeconds"); seconds.is_number())
    proof_seconds_ = std::clamp(seconds.get<double>(), 0.0, 3600.0);
  hints_ = flag_of(settings, "inlayHints", hints_);
  pictures_ = flag_of(settings, "pictures", pictures_);
  if (const Json& commands = member(settings, "commands"); commands.is_array()) {
    commands_.clear();
    for (const Json& command : commands) {
      if (command.is_string()) commands_.insert(command.get<std::string>());
    }
  }
}

void Session::ask_client(const char* method, Json params) {
  send_({{"jsonrpc", "2.0"},
         {"id", "pal-" + std::to_string(++asked_)},
         {"method", method},
         {"params", std::move(params)}});
}

void Session::initialized(const Json&) {
  if (!watches_) return;
  ask_client("client/registerCapability",
             {{"registrations",
               {{{"id", "watch"},
                 {"method", "workspace/didChangeWatchedFiles"},
                 {"registerOptions",
                  {{"watchers", {{{"globPattern", "**/*.pal"}}, {{"globPattern", "**/*.op.json"}}}}}}}}}});
}

Json Session::shutdown(const Json&) {
  shut_down_ = true;
  return nullptr;
}

void Session::exit(const Json&) {
  over_ = true;
}

std::string Session::path_in(const Json& params) const {
  const auto path = path_of(string_of(member(params, "textDocument"), "uri"));
  if (!path) throw Refusal{invalid_params, "textDocument.uri must be a file: URI"};
  return *path;
}

Session::Place Session::place_in(const Json& params) const {
  Place place{path_in(params), nullptr, 0};
  place.text = workspace_.text(place.path);
  if (place.text == nullptr) throw Refusal{request_failed, "the file cannot be read: " + place.path};
  place.offset = place.text->offset(position_of(member(params, "position")));
  return place;
}

Json Session::location(const SourceSpan& where) const {
  const auto& path = index_.path(where.file);
  const auto text = workspace_.text(path);
  return {{"uri", workspace_.uri(path)},
          {"range", range_of(text != nullptr ? *text : Text(), where.begin, where.end)}};
}

void Session::did_open(const Json& params) {
  const Json& document = member(params, "textDocument");
  const Json& version = member(document, "version");
  workspace_.open(path_in(params),
                  {string_of(document, "uri"), version.is_number() ? version.get<std::int64_t>() : 0,
                   std::make_shared<const Text>(string_of(document, "text"))});
  to_check_.insert(path_in(params));
}

void Session::did_change(const Json& params) {
  const auto path = path_in(params);
  const auto* document = workspace_.find(path);
  if (document == nullptr) return;
  Text text = *document->text;
  for (const Json& change : member(params, "contentChanges")) {
    const Json& range = member(change, "range");
    if (range.is_null()) {
      text = Text(string_of(change, "text"));
    } else {
      text.replace(position_of(member(range, "start")), position_of(member(range, "end")),
                   string_of(change, "text"));
    }
  }
  const Json& version = member(member(params, "textDocument"), "version");
  workspace_.change(path, version.is_number() ? version.get<std::int64_t>() : document->version + 1,
                    std::make_shared<const Text>(std::move(text)));
  for (const auto& [open, each] : workspace_.documents()) to_check_.insert(open);
}

void Session::did_close(const Json& params) {
  const auto path = path_in(params);
  workspace_.close(path);
  to_check_.erase(path);
  for (const auto& [open, each] : workspace_.documents()) to_check_.insert(open);
  if (to_check_.empty()) to_check_.insert({});  // what was shown goes
}

void Session::did_save(const Json& params) {
  workspace_.reload(path_in(params));
  for (const auto& [open, each] : workspace_.documents()) to_check_.insert(open);
}

void Session::did_change_watched(const Json& params) {
  for (const Json& change : member(params, "changes")) {
    const auto path = path_of(string_of(change, "uri"));
    if (path && workspace_.find(*path) == nullptr) workspace_.reload(*path);
  }
  for (const auto& [open, each] : workspace_.documents()) to_check_.insert(open);
}

void Session::did_change_configuration(const Json& params) {
  const Json& settings = member(params, "settings");
  configure(member(settings, "pal").is_object() ? member(settings, "pal") : settings);
  for (auto& [root, each] : known_) each.proved = nullptr;
  for (const auto& [open, each] : workspace_.documents()) to_check_.insert(open);
}

void Session::did_change_folders(const Json& params) {
  auto folders = workspace_.folders();
  const Json& event = member(params, "event");
  for (const Json& removed : member(event, "removed"))
    std::erase(folders, path_of(string_of(removed, "uri")).value_or(""));
  for (const Json& added : member(event, "added")) {
    if (auto path = path_of(string_of(added, "uri"))) folders.push_back(std::move(*path));
  }
  workspace_.set_folders(std::move(folders));
  for (const auto& [open, each] : workspace_.documents()) to_check_.insert(open);
}

}  // namespace pal::language_server
