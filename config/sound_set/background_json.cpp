#include "sound_set/background_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "json/json_file.hpp"

namespace rigsound::config {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFloor_db = -240;  // stands for nothing
constexpr double kMaxLevel_db = 60, kMaxCoefficient = 1e6;

double rounded(double x, double step) { return std::round(x / step) * step; }

/// To the fewest digits that stay within `digits` decimals.
double decimals(double x, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::round(x * scale) / scale;
}

Json power_db(const std::vector<float>& v) {
  Json list = Json::array();
  for (const float x : v)
    list.push_back(
        decimals(x > 0 ? std::max(kFloor_db, 10 * std::log10(static_cast<double>(x))) : kFloor_db, 2));
  return list;
}

std::vector<float> from_power_db(const std::vector<float>& db) {
  std::vector<float> v;
  for (const float x : db)
    v.push_back(x <= static_cast<float>(kFloor_db)
                    ? 0.0F
                    : static_cast<float>(std::pow(10.0, static_cast<double>(x) / 10)));
  return v;
}

Json plain(const std::vector<float>& v, int digits) {
  Json list = Json::array();
  for (const float x : v) list.push_back(decimals(static_cast<double>(x), digits));
  return list;
}

Json point_json(const DieselPoint& p) {
  Json level = Json::array(), phase = Json::array();
  for (const std::complex<float> c : p.orders) {
    const double magnitude = static_cast<double>(std::abs(c));
    level.push_back(decimals(magnitude > 0 ? std::max(kFloor_db, 20 * std::log10(magnitude)) : kFloor_db, 2));
    phase.push_back(decimals(static_cast<double>(std::arg(c)), 3));
  }
  return {{"source", p.source},
          {"rpm", rounded(p.rpm, 1e-3)},
          {"load", decimals(p.load, 3)},
          {"order_level_db", level},
          {"order_phase", phase},
          {"v_lo_db", power_db(p.low_variance)},
          {"v_hi_db", power_db(p.slot_variance)},
          {"s2", plain(p.slot_log_variance, 3)},
          {"rho", decimals(p.slot_correlation, 3)}};
}

DieselPoint read_point(const JsonFile& json) {
  DieselPoint p;
  p.source = json.text("source");
  p.rpm = json.number("rpm", 300, 4000);
  p.load = json.number("load", 0, 1);
  const std::vector<float> level = json.floats("order_level_db", kFloor_db, kMaxLevel_db);
  const std::vector<float> phase = json.floats("order_phase", -4, 4);
  if (level.size() != phase.size()) json.fail("order_phase", "has another length than order_level_db");
  for (std::size_t k = 0; k < level.size(); ++k)
    p.orders.push_back(std::polar(
        level[k] <= static_cast<float>(kFloor_db) ? 0.0F : std::pow(10.0F, level[k] / 20), phase[k]));
  p.low_variance = from_power_db(json.floats("v_lo_db", kFloor_db, kMaxLevel_db));
  p.slot_variance = from_power_db(json.floats("v_hi_db", kFloor_db, kMaxLevel_db));
  p.slot_log_variance = json.floats("s2", 0, 2);
  p.slot_correlation = json.number("rho", 0, 0.95);
  return p;
}

Json hydraulic_json(const HydraulicPart& h) {
  return {{"pump_order", h.pump_order},
          {"pump", plain(h.pump, 6)},
          {"flow", decimals(h.flow, 6)},
          {"flow_A", plain(h.flow_filter, 8)},
          {"exponent", h.exponent}};
}

HydraulicPart read_hydraulic(const JsonFile& json) {
  HydraulicPart h;
  h.pump_order = json.number("pump_order", 0.01, 1000);
  h.pump = json.floats("pump", 0, 1);
  h.flow = json.number("flow", 0, 1);
  h.flow_filter = json.floats("flow_A", -kMaxCoefficient, kMaxCoefficient);
  h.exponent = json.number("exponent", 0, 4);
  return h;
}

DieselOscillator read_oscillator(const JsonFile& json) {
  const nlohmann::json& locked = json.value("order_locked");
  if (!locked.is_boolean()) json.fail("order_locked", "is no truth value, expected true or false");
  return {json.number("frequency", 0, 24000), locked.get<bool>(), json.number("amplitude", 0, 10),
          json.number("linewidth_hz", 0, 100)};
}

/// Objects over several lines, lists on one: a spectrum is one line.
void write(const Json& json, int depth, std::string& text) {
  const bool nested = json.is_array() && !json.empty() && json.front().is_object();
  if (!json.is_object() && !nested) {
    text += json.dump();
    return;
  }
  const std::string indent(static_cast<std::size_t>(2 * depth + 2), ' ');
  text += nested ? "[\n" : "{\n";
  std::size_t left = json.size();
  for (const auto& [key, value] : json.items()) {
    text += indent;
    if (!nested) text += Json(key).dump() + ": ";
    write(value, depth + 1, text);
    text += --left ? ",\n" : "\n";
  }
  text += std::string(static_cast<std::size_t>(2 * depth), ' ') + (nested ? "]" : "}");
}

}  // namespace

std::string background_json(const DieselModel& m) {
  Json points = Json::array(), oscillators = Json::array();
  for (const DieselPoint& p : m.points) points.push_back(point_json(p));
  for (const DieselOscillator& o : m.oscillators)
    oscillators.push_back({{"frequency", o.frequency},
                           {"order_locked", o.order_locked},
                           {"amplitude", decimals(o.amplitude, 7)},
                           {"linewidth_hz", decimals(o.linewidth_hz, 4)}});
  const Json json = {
      {"format", kBackgroundFormat},
      {"sample_rate", m.sample_rate},
      {"N_theta", m.angle_samples},
      {"L", m.slots},
      {"P_lo", m.low_channels},
      {"N", m.low_scales},
      {"f_x", m.crossover_hz},
      {"load_slope_db", m.load_slope_db},
      {"A", plain(m.body_filter, 8)},
      {"E", Json{{"f_min", m.body.f_min}, {"per_octave", m.body.per_octave}, {"db", plain(m.body.db, 2)}}},
      {"hydraulic", hydraulic_json(m.hydraulic)},
      {"oscillators", oscillators},
      {"points", points}};
  std::string text;
  write(json, 0, text);
  return text + "\n";
}

DieselModel read_background_json(const std::filesystem::path& file) {
  const JsonFile json(file);
  json.require_format(kBackgroundFormat);
  DieselModel m;
  m.sample_rate = json.number("sample_rate", 8000, 192000);
  m.angle_samples = json.integer("N_theta", 1024, kMaxCrankAngle);
  m.slots = json.integer("L", 16, 256);
  m.low_channels = json.integer("P_lo", 64, 1024);
  m.low_scales = json.integer("N", 0, 4);
  m.crossover_hz = json.number("f_x", 200, 800);
  m.load_slope_db = json.number("load_slope_db", -24, 24);
  m.body_filter = json.floats("A", -kMaxCoefficient, kMaxCoefficient);
  const JsonFile E = json.object("E");
  m.body.f_min = E.number("f_min", 1, 1000);
  m.body.per_octave = E.integer("per_octave", 1, 96);
  m.body.db = E.floats("db", -120, 120);
  m.hydraulic = read_hydraulic(json.object("hydraulic"));
  for (const JsonFile& o : json.objects("oscillators")) m.oscillators.push_back(read_oscillator(o));
  for (const JsonFile& p : json.objects("points")) m.points.push_back(read_point(p));
  return m;
}

}  // namespace rigsound::config
