// A proof as it is kept in a file: the verdicts of one skill in one environment, without their runs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/verdict/verdict.hpp"

namespace pal::study {

struct KeptProof {
  /// Not empty: there is no proof, because the environment cannot be. Then there are no verdicts.
  std::string refused;
  /// In the order of the skill's requirements. Each has what reports give as figures. A witness has no more
  /// than the value that it attains; explanations, stories and places are left out.
  std::vector<analyzer::Verdict> verdicts;
  /// A hash of the texts as they were, lines and comments included. Addends name lines: they are of use only
  /// for the same texts. Empty: the addends were not looked for.
  std::string addends_of;
};

/// `key` is part of the checksum: a file under another name is as wrong as one that was cut off.
std::string file_text(const KeptProof& proof, const std::string& key);

/// Nothing if a byte is not as file_text wrote it.
std::optional<KeptProof> kept_proof(std::string_view text, const std::string& key);

}  // namespace pal::study
