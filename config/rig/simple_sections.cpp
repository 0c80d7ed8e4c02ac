// [audio] [[boom]] [scene] [mix] [control]: numbers with ranges, nothing that depends on other files.
#include <algorithm>

#include "rig/sections.hpp"
#include "rigsound/socket/host_port.hpp"
#include "sound_set/names.hpp"

namespace rigsound::config {
namespace {

constexpr Word<audio::SampleFormat> kFormats[] = {{"auto", audio::SampleFormat::kAuto},
                                                  {"float", audio::SampleFormat::kFloat},
                                                  {"s32", audio::SampleFormat::kS32},
                                                  {"s24_3", audio::SampleFormat::kS24_3},
                                                  {"s16", audio::SampleFormat::kS16}};

void require_order(const TomlTable& table, const char* key, double low, const char* high_key, double high) {
  if (low >= high) table.fail(key, std::string("is not below ") + high_key + ", expected it to be");
}

}  // namespace

audio::AudioOptions read_audio(TomlTable table) {
  audio::AudioOptions audio;
  audio.device = table.text("device", audio.device);
  audio.rate = table.integer("rate", static_cast<int>(audio.rate), static_cast<int>(kMinSampleRate),
                             static_cast<int>(kMaxSampleRate));
  audio.block = table.integer("block", audio.block, kChunk, kMaxBlock);
  if (audio.block % kChunk != 0)
    table.fail("block",
               std::to_string(audio.block) + " frames, expected a multiple of " + std::to_string(kChunk));
  audio.periods = table.integer("periods", audio.periods, 2, 32);
  audio.channels = table.integer("channels", audio.channels, 1, kMaxChannels);
  audio.format = table.word("format", audio.format, kFormats);
  audio.resample = table.flag("resample", audio.resample);
  table.refuse_unknown();
  return audio;
}

Booms read_booms(std::vector<TomlTable> tables) {
  Booms booms;
  for (TomlTable& table : tables) {
    if (booms.options.size() == kMaxBooms)
      table.fail("name", "is boom number " + std::to_string(kMaxBooms + 1) + ", expected at most " +
                             std::to_string(kMaxBooms));
    BoomOptions boom;
    boom.name = table.text("name", "boom" + std::to_string(booms.options.size() + 1));
    if (!is_name(boom.name) || signal_by_name(boom.name))
      table.fail("name", "\"" + boom.name + "\" is no boom name, " + std::string(kNameRule) +
                             ", and no signal's name");
    for (const BoomOptions& other : booms.options)
      if (other.name == boom.name)
        table.fail("name", "\"" + boom.name + "\" is the name of another boom too");
    boom.pan = table.number("pan", boom.pan, -1, 1);
    boom.gain_db = table.number("gain_db", boom.gain_db, -60, 24);
    booms.tools.push_back(table.text("tool", ""));
    booms.tool_lines.push_back(table.line_of("tool"));
    table.refuse_unknown();
    booms.options.push_back(boom);
  }
  if (booms.options.empty()) booms = {{BoomOptions{}}, {""}, {0}};
  return booms;
}

SceneOptions read_scene(TomlTable table) {
  SceneOptions scene;
  scene.contact_bar = table.number("contact_bar", scene.contact_bar, 0, 300);
  scene.underfeed_bar = table.number("underfeed_bar", scene.underfeed_bar, 0, 300);
  scene.overfeed_bar = table.number("overfeed_bar", scene.overfeed_bar, 0, 300);
  scene.hysteresis_bar = table.number("hysteresis_bar", scene.hysteresis_bar, 0, 100);
  scene.crossfade_s = table.number("crossfade_ms", scene.crossfade_s * 1000, 1, 10000) / 1000;
  scene.open_burst_s = table.number("open_burst_ms", scene.open_burst_s * 1000, 0, 10000) / 1000;
  scene.open_sustain_db = table.number("open_sustain_db", scene.open_sustain_db, -60, 0);
  scene.idle_rpm = table.number("idle_rpm", scene.idle_rpm, 100, 4000);
  require_order(table, "contact_bar", scene.contact_bar, "underfeed_bar", scene.underfeed_bar);
  require_order(table, "underfeed_bar", scene.underfeed_bar, "overfeed_bar", scene.overfeed_bar);
  table.refuse_unknown();
  return scene;
}

MixOptions read_mix(TomlTable table, double sample_rate) {
  const double highest_hz = std::min(20000.0, 0.45 * sample_rate);
  MixOptions mix;
  mix.drill_db = table.number("drill_db", mix.drill_db, -60, 24);
  mix.tool_db = table.number("tool_db", mix.tool_db, -60, 24);
  mix.diesel_db = table.number("background_db", mix.diesel_db, -60, 24);
  mix.ceiling_dbfs = table.number("ceiling_dbfs", mix.ceiling_dbfs, -60, 0);
  for (TomlTable& band : table.tables("equaliser")) {
    EqualiserBand b;
    b.frequency_hz = band.number("frequency_hz", b.frequency_hz, 20, highest_hz);
    b.gain_db = band.number("gain_db", b.gain_db, -24, 24);
    b.q = band.number("q", b.q, 0.1, 10);
    band.refuse_unknown();
    mix.equaliser.push_back(b);
  }
  table.refuse_unknown();
  return mix;
}

ControlOptions read_control(TomlTable table) {
  ControlOptions control;
  control.socket = table.text("socket", control.socket);
  control.metrics = table.text("metrics", control.metrics);
  const auto where = parse_host_port(control.metrics, 0);
  if (!control.metrics.empty() && (!where || where->port == 0))
    table.fail("metrics",
               "\"" + control.metrics + "\" is no address with a port, expected HOST:PORT or \"\"");
  table.refuse_unknown();
  return control;
}

}  // namespace rigsound::config
