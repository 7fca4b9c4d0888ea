// The commands of `pal` as its command line has them: each adds one, whose options are stored in what is
// given.
#pragma once

#include <CLI/CLI.hpp>

#include "programs/pal/commands/commands.hpp"

namespace pal::program {

void add_check(CLI::App& app, CheckOptions& options);
void add_sweep(CLI::App& app, SweepOptions& options);
void add_replay(CLI::App& app, ReplayOptions& options);
void add_simulate(CLI::App& app, SimulateOptions& options);
void add_what_if(CLI::App& app, WhatIfOptions& options);

void add_pan(CLI::App& app, PanOptions& options);
void add_atc(CLI::App& app, AtcOptions& options);
void add_sequence(CLI::App& app, SequenceOptions& options);

void add_generate(CLI::App& app, GenerateOptions& options);
void add_fmt(CLI::App& app, FormatOptions& options);
void add_resources(CLI::App& app, ResourcesOptions& options);
void add_doc(CLI::App& app, DocOptions& options);
void add_explain(CLI::App& app, ExplainOptions& options);
void add_language_server(CLI::App& app, LanguageServerOptions& options);

/// `operation` with its own commands: check, storyboard and format.
void add_operation(CLI::App& app, OperationOptions& check, OperationOptions& tell, OperationOptions& skeleton,
                   OperationOptions& format);

}  // namespace pal::program
