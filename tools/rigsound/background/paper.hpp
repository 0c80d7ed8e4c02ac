// The `--model paper` half of `rigsound background`.
#pragma once

#include <string>
#include <vector>

#include "cli/verb.hpp"
#include "rigsound/analysis/note_model.hpp"

namespace rigsound::tools {

struct PaperOptions {
  analysis::NoteSettings note;
  std::string energies = "independent";
};

void add_paper_options(cli::Verb& verb, PaperOptions& o);

/// Models one note, writes it when `resynth` names a file, prints one line or JSON.
void model_note(const std::vector<std::string>& inputs, const std::string& resynth, unsigned seed, bool json,
                const PaperOptions& o);

}  // namespace rigsound::tools
