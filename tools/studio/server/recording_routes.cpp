#include <cmath>

#include "rigsound/analysis/sound_reader.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/number_of.hpp"
#include "routes.hpp"

namespace rigsound::studio {
namespace {

constexpr double kMostSoundSeconds = 60;
constexpr std::string_view kPng = ".png";

long whole_number(const std::string& text, const char* name) {
  const auto value = number_of<long>(text);
  if (!value) throw ApiError(404, std::string(name) + ": expected a whole number");
  return *value;
}

analysis::TilePlace place_of(const std::string& level, const std::string& tile) {
  return {static_cast<int>(std::min(whole_number(level, "level"), 1000L)), whole_number(tile, "tile")};
}

/// A tile of a recording that is named with its hash never changes.
Answer tile_answer(const Request& request, const RecordingFile& recording, Tile tile, const char* type) {
  Answer answer = bytes_answer(std::move(tile.bytes), type);
  answer.headers["X-Rigsound-Exact"] = tile.exact ? "1" : "0";
  const auto asked = request.query.find("v");
  if (tile.exact && asked != request.query.end() && asked->second == recording.hash)
    answer.headers["Cache-Control"] = "private, max-age=31536000, immutable";
  return answer;
}

Answer peaks(Workplace& place, const Request& r) {
  const RecordingFile recording = place.recordings.recording(r.words[0]);
  return tile_answer(r, recording, place.tiles.peaks(recording, place_of(r.words[1], r.words[2])),
                     "application/octet-stream");
}

Answer spectrogram(Workplace& place, const Request& r) {
  std::string tile = r.words[2];
  if (tile.size() <= kPng.size() || tile.substr(tile.size() - kPng.size()) != kPng)
    throw ApiError(404, "tile: expected NUMBER.png");
  tile.resize(tile.size() - kPng.size());
  const RecordingFile recording = place.recordings.recording(r.words[0]);
  return tile_answer(r, recording, place.tiles.spectrogram(recording, place_of(r.words[1], tile)),
                     "image/png");
}

Answer audio(Workplace& place, const Request& r) {
  const RecordingFile recording = place.recordings.recording(r.words[0]);
  analysis::SoundReader sound(recording.file);
  const double length = sound.shape().seconds(), from = r.number("from", 0),
               to = std::min(length, r.number("to", std::min(length, from + kMostSoundSeconds)));
  if (from < 0 || from >= to) throw ApiError(400, "from, to: expected a stretch within the recording");
  if (to - from > kMostSoundSeconds + 1e-6) throw ApiError(400, "to: expected at most 60 s after from");
  const long first = std::lround(from * sound.shape().rate), end = std::lround(to * sound.shape().rate);
  return wave_answer(
      analysis::wave_bytes(sound.read(first, static_cast<std::size_t>(end - first)), sound.shape().rate));
}

}  // namespace

void add_recording_routes(Router& router, Workplace& place) {
  router.add("GET", "/recordings/{}/peaks/{}/{}", [&place](const Request& r) { return peaks(place, r); });
  router.add("GET", "/recordings/{}/spectrogram/{}/{}",
             [&place](const Request& r) { return spectrogram(place, r); });
  router.add("GET", "/recordings/{}/audio", [&place](const Request& r) { return audio(place, r); });
}

}  // namespace rigsound::studio
