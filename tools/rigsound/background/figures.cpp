#include "background/figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/config/json.hpp"

namespace rigsound::tools {
namespace {

Json figures_of(const analysis::LearnedDiesel& learned, const std::string& sound_set) {
  const DieselModel& m = learned.model;
  Json points = Json::array();
  double samples = 0;
  for (const analysis::LearnedPoint& p : learned.points) {
    samples += p.seconds * analysis::kAnalysisRate;
    points.push_back({{"source", p.source},
                      {"rpm", p.rpm},
                      {"load", p.load},
                      {"cycles", p.cycles},
                      {"correlation", p.correlation},
                      {"synchronous", p.synchronous}});
  }
  const auto parameters = static_cast<double>(analysis::parameter_count(m));
  return {{"background", m.name},
          {"points", points},
          {"body_known", !m.body.db.empty()},
          {"oscillators", m.oscillators.size()},
          {"grains", m.points.front().grains.size()},
          {"bytes", 4 * parameters},
          {"samples_per_parameter", samples / parameters},
          {"sound_set", sound_set}};
}

}  // namespace

std::string figures_json(const analysis::LearnedDiesel& learned, const std::string& sound_set) {
  return config::json_line(figures_of(learned, sound_set));
}

std::string figures_line(const analysis::LearnedDiesel& learned) {
  const Json r = figures_of(learned, {});
  double low = 1e9, high = 0, cycles = 0, correlation = 1;
  for (const auto& p : r["points"]) {
    low = std::min(low, p["rpm"].get<double>()), high = std::max(high, p["rpm"].get<double>());
    cycles += p["cycles"].get<double>();
    correlation = std::min(correlation, p["correlation"].get<double>());
  }
  const std::string speed =
      high - low < 1 ? fmt::format("{:.0f}", low) : fmt::format("{:.0f}..{:.0f}", low, high);
  return fmt::format(
      "{} points={} rpm={} cycles={:.0f} correlation={:.2f} body={} grains={} kB={:.1f} ratio={:.0f}",
      r["background"].get<std::string>(), r["points"].size(), speed, cycles, correlation,
      r["body_known"].get<bool>() ? "known" : "unknown", r["grains"].get<int>(),
      r["bytes"].get<double>() / 1000, r["samples_per_parameter"].get<double>());
}

}  // namespace rigsound::tools
