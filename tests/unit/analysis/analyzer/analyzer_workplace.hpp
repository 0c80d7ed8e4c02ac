// Recordings for tests of the batch, in a folder that goes away.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "simulate/drillbench_clip.hpp"
#include "temporary_folder.hpp"

namespace rigsound::analysis {

/// One of its own for every run: several may test at the same time.
class Workplace {
 public:
  std::filesystem::path operator/(const std::string& name) const { return folder_.path / name; }

 private:
  test::TemporaryFolder folder_;
};

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A clip as a recording of full scale 1; clips 103 and 112 are among the easy ones.
inline void write_clip(const std::filesystem::path& path, int id, double seconds) {
  std::vector<double> clean = drillbench_clip(id, seconds).clean;
  for (double& v : clean) v *= 0.05;
  write_wave(path, clean, 48000);
}

/// Two recordings, one with two labelled parts, and one that cannot be read.
inline void write_recordings(const Workplace& at) {
  std::filesystem::create_directories(at / "in");
  write_clip(at / "in/whole.wav", 112, 2);
  write_clip(at / "in/two.wav", 103, 4.2);
  write_text(at / "in/two.txt",
             "0.0\t2.0\tnormal rods=2 rock=granite\n2.1\t4.1\toverfeed rods=2 rock=granite feed=150 "
             "percussion=170\n");
  write_text(at / "in/bad.wav", "this is no sound");
}

inline AnalyzerOptions options_for(const Workplace& at, const std::string& set) {
  AnalyzerOptions options;
  options.inputs = {at / "in"};
  options.sound_set = at / set;
  options.denoise = false;  // quicker, and all the same here
  options.tool_version = "test";
  return options;
}

}  // namespace rigsound::analysis
