// What is told of an operation's text that need not be loaded: findings, times, ways; a layout; differences.
#pragma once

#include <map>
#include <string>

#include "operations/check.hpp"
#include "pal/support/file_system.hpp"
#include "server/json_values.hpp"

namespace pal::server {

/// As the schema's result of operation.check. `ways`: at most so many. `stop` ends it, and not all is told.
Json checked(const FileSystem& files, const std::string& main, const operations::Cell& cell,
             const Facts& facts, std::size_t ways, const operations::Stop& stop);

/// The canonical text; throws Problem with its findings if it cannot be read.
std::string formatted(const std::string& name, const std::string& text);

struct TidyOptions {
  std::string operation;                                   // only this one; empty: all of the main file
  std::map<std::string, std::pair<double, double>> sizes;  // of icons, by kind: width and height
  double ranks_apart = 64, apart = 32;
};
/// As the schema's result of operation.tidy. Throws Problem.
Json tidied(const FileSystem& files, const std::string& main, const TidyOptions& options,
            const operations::Stop& stop);

/// As the schema's result of operation.storyboard. Throws Problem.
Json told_as_story(const FileSystem& files, const std::string& main, const operations::Skills& skills,
                   const operations::Stop& stop);

/// As the schema's result of operation.difference. Throws Problem.
Json difference(const std::string& before, const std::string& after);

}  // namespace pal::server
