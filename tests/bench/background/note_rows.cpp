// Sustained notes by the paper's own model.
#include <algorithm>
#include <vector>

#include "background/table.hpp"
#include "rigsound/analysis/note_model.hpp"
#include "rigsound/analysis/recording.hpp"

namespace rigsound::bench {

using namespace rigsound::analysis;
namespace fs = std::filesystem;

void note_rows(Table& table, const fs::path& data) {
  const fs::path folder = data / "notes";
  if (!fs::exists(folder)) return table.skip("notes", folder.string() + " is not there");
  std::vector<fs::path> notes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) notes.push_back(entry.path());
  std::sort(notes.begin(), notes.end());
  for (const fs::path& note : notes) {
    const std::string name = note.stem().string();
    const std::vector<float> mono = read_recording(note).mono;
    NoteSettings settings;
    const NoteModel noise = model_note(name, mono, settings);
    settings.one_over_f = true;
    const NoteModel law = model_note(name, mono, settings);
    settings.one_over_f = false;
    settings.keep_harmonics = true;
    const NoteModel kept = model_note(name, mono, settings);
    table.at_most(name + ": near harmonics, against one over f", law.near_db, noise.near_db, "dB");
    if (name == "trumpet_F4") {
      table.at_most(name + ": at harmonics", 0.8, noise.at_db, "dB");
      table.at_most(name + ": near harmonics", 1.3, noise.near_db, "dB");
      table.at_most(name + ": between harmonics", 0.8, noise.between_db, "dB");
      table.at_least(name + ": samples a parameter", 150, noise.ratio, "");
      table.at_most(name + ": at harmonics, coefficients kept", 0.1, kept.at_db, "dB");
    } else {
      table.note(name + ": at harmonics", noise.at_db, "dB");
      table.note(name + ": between harmonics", noise.between_db, "dB");
      table.note(name + ": samples a parameter", noise.ratio, "");
      table.note(name + ": at harmonics, coefficients kept", kept.at_db, "dB");
    }
  }
}

}  // namespace rigsound::bench
