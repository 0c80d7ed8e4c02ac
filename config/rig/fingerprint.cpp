#include "rigsound/config/fingerprint.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <vector>

#include "rigsound/dsp/random.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

class Print {
 public:
  void add(std::uint64_t word) { state_ = dsp::mix64(state_ ^ dsp::mix64(word + 0x9e3779b97f4a7c15ULL)); }
  void add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    add(bits);
  }
  void add(const std::string& text) {
    add(static_cast<std::uint64_t>(text.size()));
    add_words(text.data(), text.size());
  }
  /// Of eight bytes each; the last may have fewer.
  void add_words(const char* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + i, std::min<std::size_t>(8, size - i));
      add(word);
    }
  }
  std::string hex() const {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(state_));
    return text;
  }

 private:
  std::uint64_t state_ = 0;
};

/// Adds every field of a list: one that is new in it changes the fingerprint by itself.
class FieldPrint {
 public:
  explicit FieldPrint(Print& print) : print_(print) {}

  void operator()(const char*, const double& x, const Range&) { print_.add(x); }
  void operator()(const char*, const int& x, const Range&) { print_.add(static_cast<double>(x)); }
  void operator()(const char*, const std::string&, Label) {}
  template <class Item>
  void operator()(const char*, const std::vector<Item>& list) {
    for (const Item& item : list) visit(*this, item);
  }
  template <class Options>
  void operator()(const char*, const Options& options) {
    visit(*this, options);
  }

 private:
  Print& print_;
};

void add_options(const Rig& rig, Print& print) {
  FieldPrint archive(print);
  visit(archive, rig.engine);
  for (std::size_t b = 0; b < rig.engine.booms.size() && b < rig.boom_tools.size(); ++b)
    print.add(rig.boom_tools[b]);
}

/// As a text of its bytes, which are not in memory all at once.
void add_content(const fs::path& file, Print& print) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) throw InputError(file.string(), "cannot be read");
  print.add(static_cast<std::uint64_t>(in.tellg()));
  in.seekg(0);
  std::vector<char> piece(1 << 16);
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())) || in.gcount() > 0)
    print.add_words(piece.data(), static_cast<std::size_t>(in.gcount()));
}

/// Of a folder, or of one packed file.
void add_files(const fs::path& folder, Print& print) {
  if (fs::is_regular_file(folder)) return add_content(folder, print);
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    print.add(fs::relative(file, folder).string());
    add_content(file, print);
  }
}

}  // namespace

std::string fingerprint(const Rig& rig) {
  Print print;
  add_options(rig, print);
  if (!rig.sound_set.empty()) add_files(rig.sound_set, print);
  return print.hex();
}

}  // namespace rigsound::config
