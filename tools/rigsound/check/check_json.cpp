#include "check/check_json.hpp"

namespace rigsound::tools {
namespace {

Json signal_json(const config::Rig& rig, const config::SignalSource& source) {
  const SafetyRule& rule = rig.safety.rule[static_cast<std::size_t>(source.signal.signal)];
  FigureRow row;
  row.add("signal", config::signal_label(rig, source.signal))
      .add("bus", source.section + " " + source.address)
      .add("from", source.from);
  if (rule.stale_after_s > 0)
    row.add("stale_after_ms", rule.stale_after_s * 1000)
        .add("when_stale", std::string(kStaleActions[static_cast<std::size_t>(rule.action)]));
  return row.json();
}

Json signals_json(const config::Rig& rig) {
  Json list = Json::array();
  for (const config::SignalSource& source : config::sources_of(rig)) list.push_back(signal_json(rig, source));
  return list;
}

Json feed_json(const CheckedRig& checked) {
  Json list = Json::array();
  for (const scene::FeedReach& reach : checked.reach) {
    FigureRow row;
    row.add_count("rods", static_cast<std::size_t>(reach.rods));
    if (reach.rock >= 0) row.add("rock", checked.rocks[static_cast<std::size_t>(reach.rock)]);
    row.add_count("banks", static_cast<std::size_t>(reach.banks))
        .add("lowest_bar", reach.lowest_bar)
        .add("highest_bar", reach.highest_bar);
    Json series = row.json();
    series["flattens"] = Json::array();
    for (const scene::TrendLimit& limit : reach.limits) {
      FigureRow flat;
      flat.add("parameter", std::string(limit.parameter)).add("feed_bar", limit.feed_bar);
      series["flattens"].push_back(flat.json());
    }
    list.push_back(std::move(series));
  }
  return list;
}

}  // namespace

Json check_json(const CheckedRig& checked) {
  const audio::AudioOptions& a = checked.rig.audio;
  FigureRow audio, sounds;
  audio.add("device", a.device)
      .add("rate_hz", a.rate)
      .add_count("channels", static_cast<std::size_t>(a.channels))
      .add_count("block_frames", static_cast<std::size_t>(a.block))
      .add("block_ms", 1000 * a.block / a.rate)
      .add_count("periods", static_cast<std::size_t>(a.periods));
  sounds.add("path", checked.rig.sound_set.string())
      .add_count("banks", checked.sounds.banks)
      .add_count("clicks", checked.sounds.clicks)
      .add_count("rocks", checked.sounds.rocks)
      .add_count("tools", checked.sounds.tools)
      .add("background", checked.sounds.background);
  Json json{{"ok", true}, {"audio", audio.json()}, {"sound_set", sounds.json()}, {"booms", Json::array()}};
  for (const BoomOptions& boom : checked.rig.engine.booms) json["booms"].push_back(boom.name);
  json["feed"] = feed_json(checked);
  json["signals"] = signals_json(checked.rig);
  json["doubts"] = checked.rig.doubts;
  json["not_delivered"] = checked.missing;
  return json;
}

}  // namespace rigsound::tools
