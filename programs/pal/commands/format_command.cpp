// pal fmt: the canonical layout.
#include <ostream>
#include <set>

#include "pal/support/line_difference.hpp"
#include "pal/support/output.hpp"
#include "pal/support/render.hpp"
#include "pal/support/text_check.hpp"
#include "pal/syntax/format.hpp"
#include "programs/pal/commands/commands.hpp"

namespace pal::program {
namespace {

const std::string standard_input = "-";

class FormatCommand {
 public:
  FormatCommand(const FormatOptions& options, const Console& console)
      : options_(options), console_(console) {}

  ExitStatus run() {
    for (const std::string& path : options_.paths) add(path);
    render_text(diagnostics_.sorted(), sources_, console_.err,
                {options_.max_errors, diagnostics_.not_kept()});
    if (const auto problem = write_files(changed_)) {
      console_.err << "pal: " << *problem << "\n";
      return ExitStatus::usage;
    }
    for (const OutputFile& file : changed_) console_.out << file.path << "\n";
    if (unreadable_) return ExitStatus::usage;
    return diagnostics_.has_errors() || differs_ ? ExitStatus::wrong_specification : ExitStatus::all_hold;
  }

 private:
  void add(const std::string& path) {
    if (path != standard_input) {
      if (const auto below = console_.files.list(path, ".pal")) {
        for (const std::string& file : *below) format_file(file);
        return;
      }
    }
    format_file(path);
  }

  void format_file(const std::string& path) {
    if (!seen_.insert(console_.files.identity(path)).second) return;
    const bool input = path == standard_input;
    auto read = console_.files.read(input ? "/dev/stdin" : path);
    if (const auto* error = std::get_if<FileError>(&read)) {
      console_.err << "pal: cannot read '" << path << "': " << error->reason << "\n";
      unreadable_ = true;
      return;
    }
    const FileId file =
        sources_.add(input ? "<standard input>" : path, std::get<std::string>(std::move(read)));
    if (!report_unless_text(sources_, file, diagnostics_)) return;
    const auto text = syntax::format(sources_, file, diagnostics_);
    if (!text) return;
    if (options_.check) {
      compare(file, *text);
    } else if (input) {
      console_.out << *text;
    } else if (*text != sources_.text(file)) {
      changed_.push_back({path, *text});
    }
  }

  void compare(FileId file, const std::string& text) {
    if (text == sources_.text(file)) return;
    differs_ = true;
    const std::string& name = sources_.name(file);
    console_.out << (options_.diff ? line_difference(name, sources_.text(file), name + " (formatted)", text)
                                   : name + "\n");
  }

  const FormatOptions& options_;
  const Console& console_;
  SourceManager sources_;
  Diagnostics diagnostics_;
  std::set<std::string> seen_;
  std::vector<OutputFile> changed_;
  bool unreadable_ = false;
  bool differs_ = false;
};

}  // namespace

ExitStatus format(const FormatOptions& options, const Console& console) {
  return FormatCommand(options, console).run();
}

}  // namespace pal::program
