// pal doc: the template of a skill as a document.
#include <filesystem>
#include <ostream>

#include "pal/doc/document.hpp"
#include "pal/pan/dot.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {
namespace {

/// The drawings that the Markdown form names, beside it.
void add_drawings(const doc::Document& document, const std::string& beside, std::vector<OutputFile>& files) {
  const auto folder = std::filesystem::path(beside).parent_path();
  for (const doc::Part& part : document.parts) {
    for (const doc::Section& section : part.sections) {
      for (const doc::Block& block : section.blocks) {
        const auto* picture = std::get_if<doc::Picture>(&block);
        if (picture != nullptr) files.push_back({(folder / picture->file).string(), pan::svg(picture->dot)});
      }
    }
  }
}

bool is_html(const DocOptions& options) {
  if (!options.format.empty()) return options.format == "html";
  return options.output.ends_with(".html") || options.output.ends_with(".htm");
}

}  // namespace

ExitStatus write_doc(const DocOptions& options, const Console& console) {
  Session session;
  const bool chosen = read(options.selection, console, session);
  show_findings(session, console);
  if (!chosen) return ExitStatus::usage;
  if (session.diagnostics.has_errors()) return status_of_findings(session);
  std::vector<doc::Document> documents;
  for (const pan::Network& network : session.specification.skills) {
    documents.push_back(doc::document(network, session.sources));
  }
  if (documents.empty()) {
    console.err << "pal: there is no skill to describe\n";
    return ExitStatus::usage;
  }

  const bool html = is_html(options);
  std::string text = html ? doc::html(documents) : std::string();
  std::vector<OutputFile> files;
  for (const doc::Document& document : documents) {
    if (html) break;
    text += (text.empty() ? "" : "\n") + doc::markdown(document);
    if (!options.output.empty()) add_drawings(document, options.output, files);
  }
  if (options.output.empty()) {
    console.out << text;
    return ExitStatus::all_hold;
  }
  files.push_back({options.output, text});
  return write_and_list(files, inputs_of(session), console);
}

}  // namespace pal::program
