#include "background/paper.hpp"

#include <cstdio>

#include "endings.hpp"
#include "figure_row.hpp"
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
  FigureRow figures;
  figures.add("f0_hz", m.f0, "{:.2f}")
      .add_count("channels", static_cast<std::size_t>(m.P))
      .add("steady_from_s", m.steady_from_s, "{:.2f}")
      .add("steady_to_s", m.steady_to_s, "{:.2f}")
      .add_count("periods", static_cast<std::size_t>(m.periods))
      .add_count("parameters", m.parameters)
      .add("ratio", m.ratio, "{:.0f}")
      .add("whole_ratio", m.whole_ratio, "{:.1f}")
      .add("at_harmonics_db", m.at_db, "{:.2f}")
      .add("near_harmonics_db", m.near_db, "{:.2f}")
      .add("between_harmonics_db", m.between_db, "{:.2f}");
  if (json)
    print_document(figures.json(), to);
  else
    std::fprintf(to, "%s\n", figures.words().c_str());
}

}  // namespace rigsound::tools
