#include "osc_output.hpp"

#include <fmt/format.h>

#include "rigsound/config/json.hpp"
#include "rigsound/osc/address_space.hpp"
#include "snapshot_json.hpp"

namespace rigsound::daemon {
namespace {

constexpr std::size_t kMostOfBundle = 40;  // of some 40 bytes: fits a packet of most networks, nearly

/// Every number, word and truth of `part` at `name` and the names below; lists are left out.
void add(std::vector<osc::Value>& values, const std::string& name, const Json& part) {
  if (part.is_object())
    for (const auto& [key, value] : part.items()) add(values, fmt::format("{}.{}", name, key), value);
  else if (part.is_boolean())
    values.push_back({osc::path_of(name), part.get<bool>() ? 1 : 0});
  else if (part.is_number())
    values.push_back({osc::path_of(name), part.get<float>()});
  else if (part.is_string())
    values.push_back({osc::path_of(name), part.get<std::string>()});
}

}  // namespace

std::vector<std::vector<osc::Value>> osc_bundles(const Snapshot& snapshot) {
  const Json status = status_json(snapshot);
  std::vector<osc::Value> values;
  for (const char* name : {"muted", "paused", "meters"}) add(values, name, status[name]);
  for (const Json& signal : status["signals"])
    if (!signal["age_s"].is_null() || signal["validity"] == "manual")
      add(values, signal["name"], signal["value"]);
  for (Json boom : status["booms"]) {
    const std::string name = boom["name"];
    boom.erase("name");
    add(values, name, boom);
  }
  std::vector<std::vector<osc::Value>> bundles;
  for (osc::Value& value : values) {
    if (bundles.empty() || bundles.back().size() == kMostOfBundle) bundles.emplace_back();
    bundles.back().push_back(std::move(value));
  }
  return bundles;
}

OscOutput::OscOutput(const osc::OscOptions& options) : every_s_(options.every_s) {
  for (const std::string& target : options.targets) targets_.emplace_back(target);
}

void OscOutput::send(const Snapshot& snapshot, double now_s) {
  next_s_ = now_s + every_s_;
  for (const std::vector<osc::Value>& values : osc_bundles(snapshot)) {
    const std::string bytes = osc::write_bundle(values);
    for (const udp::UdpSender& target : targets_) target.send(bytes);
  }
}

}  // namespace rigsound::daemon
