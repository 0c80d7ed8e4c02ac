#include "engine/hostile/hostile_input.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "engine_check.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/tool_player.hpp"

namespace rigsound::tests {
namespace {

constexpr int kTries = 300;

/// The first of many draws that `check` does not refuse.
template <class Value, class Draw, class Check>
Value accepted(const Value& otherwise, Draw draw, Check check) {
  for (int i = 0; i < kTries; ++i) {
    Value value = draw();
    try {
      check(value);
      return value;
    } catch (const std::invalid_argument&) {
    }
  }
  return otherwise;
}

}  // namespace

/// Sets the numbers of a list: a third stay, a third go to an end of their range, a third anywhere in it.
class HostileInput::AtTheEdges {
 public:
  explicit AtTheEdges(HostileInput& from) : from_(from) {}

  void operator()(const char*, double& x, const Range& range) { x = drawn(x, range); }
  void operator()(const char*, int& x, const Range& range) { x = static_cast<int>(drawn(x, range)); }
  void operator()(const char*, bool& x) { x = from_.below(2) == 0; }
  void operator()(const char*, std::vector<float>& list, const PowersInDb&) {
    const float factor = from_.below(2) == 0 ? 1 : std::pow(10.0F, static_cast<float>(from_.below(10)) - 5);
    for (float& x : list) x = std::min(1e6F, x * factor);
  }
  template <class Item>
  void operator()(const char*, std::vector<Item>& list) {
    for (Item& item : list) fields(*this, item);
  }
  template <class Options, class... Ranges>
  void operator()(const char*, Options& options, const Ranges&...) {
    if constexpr (std::is_class_v<Options> && sizeof...(Ranges) == 0 && !std::is_same_v<Options, std::string>)
      fields(*this, options);
  }
  template <class E, std::size_t N>
  void operator()(const char*, E& word, const Word<E> (&words)[N]) {
    word = words[from_.below(N)].second;
  }
  void operator()(const char*, const char*, std::vector<std::complex<float>>&, const Range&, const Range&) {}
  void operator()(const char*, std::vector<float>&, const Range&) {}
  void operator()(const char*, Allpass&, const Range&) {}

 private:
  double drawn(double x, const Range& range) {
    const int what = from_.below(6);
    if (what < 2) return x;
    if (what == 2) return range.zero ? 0 : range.min;
    if (what == 3) return range.max;
    const double any = range.min + from_.uniform() * (range.max - range.min);
    return range.step > 0 ? range.step * std::floor(any / range.step) : any;
  }

  HostileInput& from_;
};

float HostileInput::number() {
  constexpr float kWorst[] = {std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::max(),
                              std::numeric_limits<float>::lowest(),
                              std::numeric_limits<float>::denorm_min(),
                              -std::numeric_limits<float>::denorm_min(),
                              0,
                              -0.0F,
                              1,
                              -1,
                              1e-6F,
                              300,
                              4000};
  constexpr int kCount = sizeof kWorst / sizeof *kWorst;
  const int what = below(kCount + 8);
  if (what < kCount) return kWorst[what];
  if (what < kCount + 5) return static_cast<float>(uniform() * 200);  // what might be meant
  const auto bits = static_cast<std::uint32_t>(random_.bits(drawn_++, 0));
  float x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

MachineState HostileInput::state() {
  MachineState state;
  for_each_field(state, [&](auto& field) {
    using Field = std::decay_t<decltype(field)>;
    const std::uint64_t bits = random_.bits(drawn_++, 0) >> (below(2) == 0 ? 0 : 62);  // any, or a small one
    if constexpr (std::is_same_v<Field, float>)
      field = number();
    else
      std::memcpy(&field, &bits, sizeof field);
  });
  if (below(4) > 0) state.simulation = Simulation::kRun;  // else it would mostly stand still
  if (below(2) == 0) state.output_gain = 1, state.master_gain_db = 0;
  return state;
}

EngineOptions HostileInput::options() {
  constexpr double kRates[] = {32000, 44100, 48000, 96000, 192000};
  const auto draw = [&] {
    EngineOptions o;
    AtTheEdges edges(*this);
    o.mix.equaliser.resize(static_cast<std::size_t>(below(4)));
    fields(edges, o.scene);
    fields(edges, o.mix);
    o.sample_rate = kRates[below(5)];
    o.block = kChunk * (1 + below(4));
    o.channels = 1 + below(kMaxChannels);
    o.seed = random_.bits(drawn_++, 0);
    o.booms.resize(static_cast<std::size_t>(1 + below(kMaxBooms)));
    for (BoomOptions& boom : o.booms) {
      fields(edges, boom);
      const int rings = below(3);
      boom.tool = rings == 0 ? 0 : -1, boom.drill_string = rings == 1 ? 0 : -1;
    }
    return o;
  };
  return accepted(EngineOptions{}, draw, [](const EngineOptions& o) { require_valid(o); });
}

std::vector<float> HostileInput::click() {
  std::vector<float> x(static_cast<std::size_t>(1 + below(3000)));
  const int kind = below(5);
  const auto level = static_cast<float>(below(2) == 0 ? 1 / std::sqrt(static_cast<double>(x.size())) : 1000);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double noise = 2 * uniform() - 1;
    if (kind == 0) x[n] = level * static_cast<float>(noise);
    if (kind == 1) x[n] = n % 2 == 0 ? level : -level;
    if (kind == 2) x[n] = n % 4 < 2 ? level : -level;  // a quarter of the rate, between its own peaks
    if (kind == 3) x[n] = n == 0 ? level : 1e-42F;
    if (kind == 4) x[n] = level;
  }
  return x;
}

ClickBank HostileInput::bank(double sample_rate) {
  const auto draw = [&] {
    ClickBank b;
    b.mean_gap_samples = sample_rate / 30;
    AtTheEdges edges(*this);
    fields(edges, b);
    b.sample_rate = sample_rate;
    if (below(2) == 0) b.mean_gap_samples = sample_rate / (1 + below(200));
    b.gap_deviation_samples = std::min(b.gap_deviation_samples, 2 * b.mean_gap_samples);
    b.amplitude_deviation = std::min(b.amplitude_deviation, 4 * b.mean_amplitude);
    b.double_share = std::min(b.double_share, 1 - b.miss_share);
    if (below(2) == 0) b.attack_samples = below(100);
    if (below(2) == 0 && b.attack_samples > 0) b.attack_bend = -100 / b.attack_samples;
    b.clicks.clear();
    return b;
  };
  const auto check = [&](ClickBank& b) {
    for (int i = 1 + below(6); i > 0; --i) b.clicks.push_back(click());
    require_valid(b);
  };
  ClickBank plain;
  plain.sample_rate = sample_rate, plain.mean_gap_samples = sample_rate / 30, plain.clicks = {click()};
  return accepted(plain, draw, check);
}

ToolModel HostileInput::tool(double sample_rate) {
  const auto draw = [&] {
    ToolModel model;
    model.voicing.equaliser.resize(static_cast<std::size_t>(below(3)));
    model.rods.resize(static_cast<std::size_t>(below(2)));
    AtTheEdges edges(*this);
    fields(edges, model);
    return model;
  };
  return accepted(ToolModel{}, draw, [&](const ToolModel& model) {
    require_valid(model, sample_rate);
    ToolPlayer(model, sample_rate, 1);  // designs every steel of it
  });
}

StringModel HostileInput::string() {
  const auto draw = [&] {
    StringModel model;
    AtTheEdges edges(*this);
    fields(edges, model);
    return model;
  };
  return accepted(StringModel{}, draw, [](const StringModel& model) { require_valid(model); });
}

DieselModel HostileInput::diesel() {
  const auto draw = [&] {
    DieselModel model = default_diesel();
    const DieselModel shape = model;
    AtTheEdges edges(*this);
    fields(edges, model);
    model.angle_samples = shape.angle_samples, model.slots = shape.slots;
    model.low_channels = shape.low_channels, model.low_scales = shape.low_scales;
    model.sample_rate = shape.sample_rate;
    if (below(2) == 0) model.start.assign(4000, 1000), model.stop.assign(3000, -1000);
    return model;
  };
  return accepted(default_diesel(), draw, [](const DieselModel& model) { require_valid(model); });
}

SoundSet HostileInput::sounds(double sample_rate) {
  SoundSet set;
  const int banks = kSituationCount + below(4);
  for (int b = 0; b < banks; ++b) {
    set.banks.push_back(bank(sample_rate));
    BankUse use;
    use.situation = static_cast<Situation>(b % kSituationCount);
    use.bank = b;
    if (b >= kSituationCount) {
      use.rods = below(21), use.rock = below(2) - 1;
      use.feed_bar = 300 * uniform(), use.percussion_bar = 300 * uniform();
    }
    set.uses.push_back(use);
  }
  set.rocks = {{"soft", 1e6}, {"hard", 1e10}};
  const auto slope = [&] { return 0.2 * (uniform() - 0.5); };
  if (below(2) == 0) set.laws = {{0, -1, slope(), slope(), slope(), slope(), slope(), slope()}};
  set.tools = {tool(sample_rate)};
  set.strings = {string()};
  if (below(4) > 0) set.diesels = {diesel()};
  return set;
}

}  // namespace rigsound::tests
