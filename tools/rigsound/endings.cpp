#include "endings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "cli/verb.hpp"
#include "rigsound/audio/sound_writer.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::tools {
namespace {

bool ends_in(std::string name, std::string_view ending) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

/// ".wav, .flac or .ogg"
std::string choice_of(const std::vector<std::string_view>& endings) {
  std::string text;
  for (std::size_t i = 0; i < endings.size(); ++i)
    text.append(i == 0 ? "" : i + 1 == endings.size() ? " or " : ", ").append(endings[i]);
  return text;
}

}  // namespace

void require_ending(const std::string& option, const std::string& file,
                    const std::vector<std::string_view>& endings) {
  std::error_code error;
  if (file.empty() || is_standard_output(file)) return;
  if (std::filesystem::exists(file, error) && std::filesystem::is_other(file, error)) return;
  const std::string name = std::filesystem::path(file).filename().string();
  if (std::any_of(endings.begin(), endings.end(), [&](std::string_view e) { return ends_in(name, e); }))
    return;
  throw cli::UsageError(option,
                        "'" + file + "' names no format, expected a name that ends in " + choice_of(endings));
}

void require_sound_ending(const std::string& option, const std::string& file) {
  require_ending(option, file, {audio::kSoundEndings.begin(), audio::kSoundEndings.end()});
}

void tell_clipped(const std::string& file, unsigned long long samples) {
  if (samples > 0)
    fmt::print(stderr, "{}: {} samples over full scale are clipped; a file that ends in .wav keeps them\n",
               file, samples);
}

}  // namespace rigsound::tools
