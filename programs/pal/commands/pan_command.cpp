// pal pan: modules as graphs.
#include <fmt/format.h>

#include <ostream>
#include <stdexcept>

#include "pal/check/to_unit.hpp"
#include "pal/pan/dot.hpp"
#include "pal/syntax/parse.hpp"
#include "pal/syntax/print.hpp"
#include "pal/syntax/written_conditions.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {
namespace {

/// Conditions as all files of PAL that were read have them. A drawing has them in a spelling of its own.
syntax::WrittenConditions written_conditions(const SourceManager& sources) {
  syntax::WrittenConditions written;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const FileId file(i);
    const std::string& name = sources.name(file);
    if (name.ends_with(".dot") || name.ends_with(".gv")) continue;
    Diagnostics known;  // the command has told them
    syntax::add_written_conditions(syntax::parse(sources, file, known), sources, written);
  }
  return written;
}

/// The pictures of one network's modules. Modules that stand in several skills are drawn once: their bodies
/// are the same.
void add_pictures(const pan::Network& network, const PanOptions& options,
                  const syntax::WrittenConditions& written, std::vector<OutputFile>& files) {
  pan::DotOptions dot_options;
  dot_options.letters = options.letters;
  if (options.letters) dot_options.direction = pan::DotOptions::Direction::left_to_right;
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const pan::Module& module = network.modules[i];
    if (module.body.empty() || (!options.module.empty() && module.name != options.module)) continue;
    dot_options.written = [&](pan::NodeId node, std::size_t arm) -> std::string {
      const SourceSpan where = module.body[node].where;
      const auto found = written.find({where.file, where.begin});
      return found == written.end() || arm >= found->second.size() ? std::string() : found->second[arm];
    };
    const std::string dot = pan::to_dot(network, pan::ModuleId(i), dot_options);
    const std::string skill = network.skill.name.empty() ? "" : network.skill.name + ".";
    const std::string stem = options.output + "/" + skill + module.name + ".pan";
    files.push_back(options.dot ? OutputFile{stem + ".dot", dot} : OutputFile{stem + ".svg", pan::svg(dot)});
  }
}

/// The modules of one network as PAL.
void add_units(const pan::Network& network, const PanOptions& options, syntax::Tree& tree) {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const pan::Module& module = network.modules[i];
    if (module.body.empty() || (!options.module.empty() && module.name != options.module)) continue;
    tree.units.emplace_back(check::to_unit(network, pan::ModuleId(i)));
  }
}

/// Whether the output is called like a picture, not like a folder.
bool names_a_file(const std::string& output) {
  for (const char* ending : {".svg", ".dot", ".gv", ".png", ".pdf", ".jpg", ".html", ".eps"})
    if (output.ends_with(ending)) return true;
  return false;
}

ExitStatus no_module(const PanOptions& options, const Console& console) {
  console.err << (options.module.empty()
                      ? "pal: there is no module with a body to draw\n"
                      : fmt::format("pal: no module with a body is called '{}'\n", options.module));
  return ExitStatus::usage;
}

ExitStatus print_pal(const check::Specification& specification, const PanOptions& options,
                     const Console& console) {
  syntax::Tree tree;
  for (const pan::Network& network : specification.skills) add_units(network, options, tree);
  for (const pan::Network& network : specification.sketches) add_units(network, options, tree);
  if (tree.units.empty()) return no_module(options, console);
  syntax::print(tree, console.out);
  return ExitStatus::all_hold;
}

}  // namespace

ExitStatus draw_pan(const PanOptions& options, const Console& console) {
  Session session;
  const bool chosen = read(options.selection, console, session);
  show_findings(session, console);
  if (!chosen) return ExitStatus::usage;
  if (session.diagnostics.has_errors()) return status_of_findings(session);

  if (options.pal) return print_pal(session.specification, options, console);

  std::vector<OutputFile> files;
  const syntax::WrittenConditions written = written_conditions(session.sources);
  for (const auto* networks : {&session.specification.skills, &session.specification.sketches}) {
    for (const pan::Network& network : *networks) add_pictures(network, options, written, files);
  }
  if (files.empty()) return no_module(options, console);
  if (names_a_file(options.output)) {
    const std::string wanted = options.dot ? ".dot" : ".svg";
    if (!options.output.ends_with(wanted) || files.size() != 1) {
      console.err << fmt::format(
          "pal: cannot write {}: {}\nhint: -o takes a folder for the drawings of all modules, or with "
          "--module "
          "NAME a file that ends in {}\n",
          options.output,
          files.size() != 1 ? fmt::format("there are {} modules to draw", files.size())
                            : "the drawing is " + std::string(options.dot ? "DOT" : "SVG"),
          wanted);
      return ExitStatus::usage;
    }
    files.front().path = options.output;
  }
  return write_and_list(files, inputs_of(session), console);
}

}  // namespace pal::program
