// Proofs as an editor shows them, with the words of all other reports.
#pragma once

#include "language_server/proofs.hpp"
#include "programs/pal/reports/kept_proofs.hpp"

namespace pal::program {

class EditorProver : public language_server::Prover {
 public:
  language_server::SkillProof prove(
      const pan::Network& skill, const pan::Environment& environment, const SourceManager& sources,
      language_server::Depth depth, double seconds, const std::function<bool()>& stop,
      const std::function<void(language_server::SkillProof)>& told) const override;
  // editor_advice.cpp
  language_server::Advice advise(const pan::Network& skill, const pan::Environment& environment,
                                 const SourceManager& sources, double seconds,
                                 const std::function<bool()>& stop) const override;

 private:
  mutable KeptProofs kept_;  // has a lock of its own
};

}  // namespace pal::program
