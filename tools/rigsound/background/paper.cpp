#include "background/paper.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "endings.hpp"
#include "read_recording.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "standard_output.hpp"

namespace rigsound::tools {

void add_paper_options(cli::Verb& verb, PaperOptions& o) {
  const char* group = "With --model paper";
  verb.option("--energies", o.energies, "independent: one a subband; one-over-f: two numbers a channel")
      .one_of({"independent", "one-over-f"})
      .group(group);
  verb.option("--scales", o.note.N, "wavelet scales (default: 4, with --keep-harmonics 3)")
      .range(1, 6)
      .group(group);
  verb.flag("--keep-harmonics", o.note.keep_harmonics, "harmonics keep their coefficients").group(group);
  verb.flag("--colour", o.note.colour, "AR filters of order 10, 8, 6, ... from the second subband on")
      .group(group);
  verb.flag("--time-varying", o.note.time_varying, "energies in windows of 20 coefficients").group(group);
  verb.option("--waveforms", o.note.waveforms, "elementary waveforms in the first subband")
      .range(12, 1000)
      .group(group);
}

void model_note(const std::vector<std::string>& inputs, const std::string& resynth, unsigned seed, bool json,
                const PaperOptions& o) {
  if (inputs.size() != 1) throw cli::UsageError("IN", "--model paper takes one note");
  analysis::NoteSettings settings = o.note;
  settings.one_over_f = o.energies == "one-over-f";
  settings.seed = seed;
  const analysis::NoteModel m =
      analysis::model_note(inputs.front(), read_whole(inputs.front(), "note").mono, settings);
  if (!resynth.empty())
    tell_clipped(resynth, analysis::write_wave(resynth, m.sound, static_cast<int>(analysis::kAnalysisRate)));
  std::FILE* const to = figures_beside({resynth});
  if (json) {
    const nlohmann::ordered_json figures = {{"f0_hz", m.f0},
                                            {"channels", m.P},
                                            {"steady_from_s", m.steady_from_s},
                                            {"steady_to_s", m.steady_to_s},
                                            {"periods", m.periods},
                                            {"parameters", m.parameters},
                                            {"ratio", m.ratio},
                                            {"whole_ratio", m.whole_ratio},
                                            {"at_harmonics_db", m.at_db},
                                            {"near_harmonics_db", m.near_db},
                                            {"between_harmonics_db", m.between_db}};
    std::fprintf(to, "%s\n", figures.dump().c_str());
    return;
  }
  std::fprintf(
      to,
      "f0=%.2f steady=%.2f..%.2f periods=%d parameters=%zu ratio=%.0f whole_ratio=%.1f at=%.2f near=%.2f "
      "between=%.2f\n",
      m.f0, m.steady_from_s, m.steady_to_s, m.periods, m.parameters, m.ratio, m.whole_ratio, m.at_db,
      m.near_db, m.between_db);
}

}  // namespace rigsound::tools
