#include "rigsound/analysis/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "chart/outline.hpp"
#include "chart/plot.hpp"
#include "chart/png_canvas.hpp"
#include "chart/situation_colours.hpp"
#include "chart/spectrum_palette.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/read_files.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/session/state_table.hpp"
#include "timeline/activity.hpp"
#include "timeline/level_picture.hpp"
#include "timeline/sound_file.hpp"

namespace rigsound::analysis {
namespace {

using chart::Box, chart::Colour, chart::Lettering, chart::Plot, chart::PngCanvas, chart::Role;
using Anchor = Lettering::Anchor;
using Weight = Lettering::Weight;

struct ActivityLook {
  const char* name;
  Colour colour;
};

/// In the order of Activity.
constexpr std::array<ActivityLook, kActivityCount> kLooks = {{
    {"normal", chart::kSituationColours[0]},
    {"underfeed", chart::kSituationColours[1]},
    {"overfeed", chart::kSituationColours[2]},
    {"closed rattling", chart::kSituationColours[3]},
    {"open rattling", chart::kSituationColours[4]},
    {"idle", {188, 200, 214}},
    {"off", {222, 222, 226}},
}};

enum class LaneKind : std::uint8_t {
  kActivity,  ///< spans of each boom, coloured and named
  kValues,    ///< a strip of values, when the states hold the signal
  kFeed,      ///< a curve with the thresholds of the feed pressure
  kCurve,
};

struct Lane {
  LaneKind kind;
  const char* title;
  Signal signal;
  double height;
};

/// What is drawn of the machine, from top to bottom. Lanes of signals that the states do not hold are left
/// out.
constexpr Lane kLanesDrawn[] = {
    {LaneKind::kActivity, "Situation", Signal::kRattling, 28},
    {LaneKind::kValues, "Rods", Signal::kRodCount, 17},
    {LaneKind::kValues, "Rock", Signal::kRock, 17},
    {LaneKind::kFeed, "Feed pressure", Signal::kFeedPressureBar, 128},
    {LaneKind::kCurve, "Diesel", Signal::kEngineRpm, 92},
};

// Lengths of the drawing, which is kWide wide; pixels come from the scale.
constexpr double kWide = 1280, kLeft = 66, kRight = 84, kHead = 62, kGap = 3, kTitleRoom = 23, kFoot = 40;
constexpr double kWaveHeight = 138, kSmall = 10, kText = 11;
constexpr double kTint = 0.17;

class Drawing {
 public:
  Drawing(const SoundFile& sound, const session::StateTable& states, const TimelineOptions& options)
      : sound_(sound),
        states_(states),
        options_(options),
        canvas_(options.width, options.height, options.width / kWide,
                options.theme == TimelineTheme::kDark ? chart::Theme::kDark : chart::Theme::kLight),
        tall_(kWide * options.height / options.width),
        end_s_(sound.seconds()),
        time_(chart::time_axis("", 0, end_s_, 18)) {
    for (std::size_t boom = 0; boom < states.booms.size(); ++boom)
      spans_.push_back(activity_spans(states, static_cast<int>(boom), options.scene, end_s_));
  }

  void draw(const std::string& title) {
    draw_head(title);
    for (const Lane& lane : kLanesDrawn) draw_lane(lane);
    draw_wave();
    draw_spectrogram();
  }

  void write(const std::filesystem::path& file) const { canvas_.write(file); }

 private:
  void draw_head(const std::string& title);
  void draw_lane(const Lane& lane);
  void draw_activity(const Lane& lane, std::size_t boom);
  void draw_name(const ActivityLook& drawn, const Box& area);
  void draw_values(const Lane& lane, int boom);
  void draw_curve(const Lane& lane);
  void draw_threshold(Plot& plot, double bar, const char* name, Activity beyond);
  void draw_wave();
  void draw_spectrogram();

  struct Series {
    std::vector<double> time_s, value;
  };
  Series series(Signal signal, int boom) const;
  double x_of(double time_s) const { return kLeft + (kWide - kRight - kLeft) * time_.place(time_s); }
  /// The next free piece of the page from edge to edge.
  Box take(double height) {
    const Box box{0, top_, kWide, top_ + height};
    top_ += height + kGap;
    return box;
  }
  chart::Margins margins() const { return {kLeft, kTitleRoom, kRight, 0}; }
  void tint(const Plot& plot);
  void lane_name(const Box& box, const std::string& name);

  const SoundFile& sound_;
  const session::StateTable& states_;
  const TimelineOptions& options_;
  PngCanvas canvas_;
  double tall_, end_s_, top_ = kHead;
  chart::Axis time_;
  std::vector<std::vector<ActivitySpan>> spans_;  // of each boom
};

const ActivityLook& look(Activity activity) { return kLooks[static_cast<std::size_t>(activity)]; }

/// Dark letters on a light colour, light ones on a dark one.
chart::Paint letters_on(Colour c) {
  constexpr Colour kDarkLetters{27, 27, 31}, kLightLetters{255, 255, 255};
  return 0.299 * c.red + 0.587 * c.green + 0.114 * c.blue > 135 ? kDarkLetters : kLightLetters;
}

double decibels(double amplitude) { return 20 * std::log10(std::max(amplitude, 1e-10)); }

Drawing::Series Drawing::series(Signal signal, int boom) const {
  Series found{{0}, {info(signal).absent}};
  for (const session::StateChange& change : states_.changes)
    if (change.signal.signal == signal && change.signal.boom == boom && change.time_s <= end_s_)
      found.time_s.push_back(std::max(change.time_s, 0.0)), found.value.push_back(change.value);
  return found;
}

void Drawing::draw_head(const std::string& title) {
  constexpr double kTitleSize = 17, kTitleLine = 26, kNoteLine = 44, kSwatch = 9;
  canvas_.text({kLeft, kTitleLine}, title, {Role::kInk, kTitleSize, Anchor::kStart, Weight::kBold});
  double square = 0;
  for (const float x : sound_.mono) square += static_cast<double>(x) * static_cast<double>(x);
  canvas_.text({kLeft, kNoteLine},
               fmt::format("{:.1f} s · {:g} kHz · {} · peak {:.1f} dB, mean {:.1f} dB re full scale", end_s_,
                           sound_.rate / 1000.0,
                           sound_.channels == 1   ? "mono"
                           : sound_.channels == 2 ? "stereo"
                                                  : fmt::format("{} channels", sound_.channels),
                           decibels(sound_.peak),
                           decibels(std::sqrt(square / static_cast<double>(sound_.mono.size())))),
               {Role::kGrey, kText});
  double x = kWide - kRight;
  for (std::size_t i = kLooks.size(); i-- > 0;) {
    const bool shown = std::any_of(spans_.begin(), spans_.end(), [&](const auto& spans) {
      return std::any_of(spans.begin(), spans.end(),
                         [&](const ActivitySpan& span) { return span.activity == static_cast<Activity>(i); });
    });
    if (!shown) continue;
    const Lettering lettering{Role::kGrey, kText, Anchor::kEnd};
    canvas_.text({x, kNoteLine}, kLooks[i].name, lettering);
    x -= canvas_.text_width(kLooks[i].name, lettering) + 5 + kSwatch;
    canvas_.fill({chart::rectangle({x, kNoteLine - kSwatch, x + kSwatch, kNoteLine})}, kLooks[i].colour);
    x -= 14;
  }
}

void Drawing::lane_name(const Box& box, const std::string& name) {
  canvas_.text({kLeft - 8, 0.5 * (box.top + box.bottom) + 4}, name, {Role::kGrey, kText, Anchor::kEnd});
}

void Drawing::draw_lane(const Lane& lane) {
  for (std::size_t boom = 0; boom < states_.booms.size(); ++boom) {
    const bool held = states_.holds({lane.signal, static_cast<std::uint8_t>(boom)});
    if (lane.kind == LaneKind::kActivity) draw_activity(lane, boom);
    if (lane.kind == LaneKind::kValues && held) draw_values(lane, static_cast<int>(boom));
  }
  if (lane.kind == LaneKind::kFeed || lane.kind == LaneKind::kCurve) draw_curve(lane);
}

void Drawing::draw_activity(const Lane& lane, std::size_t boom) {
  const Box box = take(lane.height);
  lane_name(box, states_.booms[boom].empty() ? lane.title : states_.booms[boom]);
  for (const ActivitySpan& span : spans_[boom]) {
    const ActivityLook& drawn = look(span.activity);
    const Box area{x_of(span.from_s), box.top, x_of(span.to_s), box.bottom};
    canvas_.fill({chart::rectangle(area)}, drawn.colour);
    draw_name(drawn, area);
  }
}

/// On one line, else on two smaller ones, else not at all: the legend says it too.
void Drawing::draw_name(const ActivityLook& drawn, const Box& area) {
  constexpr double kTwoLines = 9.5;
  const double middle = 0.5 * (area.left + area.right), baseline = 0.5 * (area.top + area.bottom) + 4;
  const std::string name = drawn.name;
  Lettering lettering{letters_on(drawn.colour), kText, Anchor::kMiddle, Weight::kBold};
  const auto fits = [&](const std::string& text) {
    return canvas_.text_width(text, lettering) + 6 < area.width();
  };
  if (fits(name)) return canvas_.text({middle, baseline}, name, lettering);
  const std::size_t space = name.find(' ');
  if (space == std::string::npos) return;
  lettering.size = kTwoLines;
  const std::string above = name.substr(0, space), below = name.substr(space + 1);
  if (!fits(above) || !fits(below)) return;
  canvas_.text({middle, baseline - 5.5}, above, lettering);
  canvas_.text({middle, baseline + 5.5}, below, lettering);
}

void Drawing::draw_values(const Lane& lane, int boom) {
  const Box box = take(lane.height);
  lane_name(box, states_.booms[boom].empty() ? lane.title : states_.booms[boom] + " " + lane.title);
  const Series values = series(lane.signal, boom);
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    const Box area{x_of(values.time_s[i]), box.top,
                   i + 1 < values.value.size() ? x_of(values.time_s[i + 1]) : kWide - kRight, box.bottom};
    const std::string_view word = value_word(lane.signal, values.value[i]);
    const std::string text = word.empty() ? fmt::format("{:g}", values.value[i]) : std::string(word);
    canvas_.fill({chart::rectangle({area.left + 0.5, area.top, area.right - 0.5, area.bottom})},
                 {Role::kFaint, 0.6});
    const Lettering lettering{Role::kInk, kSmall, Anchor::kMiddle};
    if (canvas_.text_width(text, lettering) + 4 < area.width())
      canvas_.text({0.5 * (area.left + area.right), box.bottom - 5}, text, lettering);
  }
}

void Drawing::tint(const Plot& plot) {
  for (const ActivitySpan& span : spans_.front())
    canvas_.fill(
        {chart::rectangle({plot.px(span.from_s), plot.plane().top, plot.px(span.to_s), plot.plane().bottom})},
        {look(span.activity).colour, kTint});
}

void Drawing::draw_threshold(Plot& plot, double bar, const char* name, Activity beyond) {
  plot.horizontal(bar, {look(beyond).colour, 1.3, 5});
  const double y = plot.py(bar);
  canvas_.text({kWide - kRight + 6, y + (beyond == Activity::kOverfeed ? -2 : 4)}, name,
               {look(beyond).colour, kSmall, Anchor::kStart, Weight::kBold});
  canvas_.text({kWide - kRight + 6, y + (beyond == Activity::kOverfeed ? 10 : 16)},
               fmt::format("{} {:g} bar", beyond == Activity::kOverfeed ? "over" : "under", bar),
               {Role::kGrey, kSmall});
}

void Drawing::draw_curve(const Lane& lane) {
  const SignalInfo& signal = info(lane.signal);
  std::vector<Series> curves;
  std::vector<std::string> names;
  double highest = lane.kind == LaneKind::kFeed ? options_.scene.overfeed_bar : 0;
  for (std::size_t boom = 0; boom < states_.booms.size(); ++boom) {
    if (!states_.holds({lane.signal, static_cast<std::uint8_t>(boom)})) continue;
    curves.push_back(series(lane.signal, static_cast<int>(boom)));
    names.push_back(states_.booms[boom].empty() ? "first boom" : states_.booms[boom]);
    highest = std::max(highest, *std::max_element(curves.back().value.begin(), curves.back().value.end()));
  }
  if (curves.empty()) return;
  Plot plot(canvas_, take(lane.height), lane.title,
            chart::Axis{"", 0, end_s_, chart::Axis::Scale::kLinear, {}},
            chart::linear_axis(std::string(signal.unit), 0, highest > 0 ? 1.15 * highest : 1, 4), margins());
  tint(plot);
  if (lane.kind == LaneKind::kFeed) {
    draw_threshold(plot, options_.scene.overfeed_bar, "overfeed", Activity::kOverfeed);
    draw_threshold(plot, options_.scene.underfeed_bar, "underfeed", Activity::kUnderfeed);
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const chart::Paint ink{Role::kInk, i == 0 ? 0.9 : 0.45};
    plot.steps(curves[i].time_s, curves[i].value, {ink, 1.3});
    if (curves.size() > 1) plot.legend(names[i], ink);
  }
  plot.finish();
}

void Drawing::draw_wave() {
  const double range = std::max(0.01, std::min(1.0, 0.05 * std::ceil(20 * sound_.peak)));
  Plot plot(canvas_, take(kWaveHeight), "Waveform",
            chart::Axis{"", 0, end_s_, chart::Axis::Scale::kLinear, {}},
            chart::linear_axis("of full scale", -range, range, 4), margins());
  tint(plot);
  const auto columns = static_cast<std::size_t>(canvas_.pixels_across(plot.plane()));
  const std::vector<float>& x = sound_.mono;
  const chart::Outline drawn = chart::outline(x.data(), x.size(), columns, 0, 1.0 / sound_.rate);
  std::vector<double> mean, below;
  for (std::size_t c = 0; c < drawn.x.size(); ++c) {
    const std::size_t from = x.size() * c / drawn.x.size(), to = x.size() * (c + 1) / drawn.x.size();
    double square = 0;
    for (std::size_t n = from; n < to; ++n) square += static_cast<double>(x[n]) * static_cast<double>(x[n]);
    mean.push_back(std::sqrt(square / static_cast<double>(to - from)));
    below.push_back(-mean.back());
  }
  plot.band(drawn.x, drawn.low, drawn.high, {Role::kFirst, 0.55});
  plot.band(drawn.x, below, mean, Role::kFirst);
  plot.legend("peak", Colour{121, 164, 208});
  plot.legend("rms", Role::kFirst);
  plot.finish();
}

void Drawing::draw_spectrogram() {
  const Box box{0, top_, kWide, tall_ - kFoot + 34};
  const chart::Margins room{kLeft, kTitleRoom, kRight, 34};
  const Box plane{kLeft, box.top + room.top, kWide - kRight, box.bottom - room.bottom};
  const LevelPicture levels = level_picture(sound_, canvas_.pixels_across(plane), canvas_.pixels_down(plane));
  chart::Axis time = time_;
  time.label = end_s_ < 120 ? "time, s" : "time, min:s";
  std::vector<double> ticks;
  for (const double hz : {50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0, 20000.0})
    if (hz <= levels.highest_hz) ticks.push_back(hz);
  Plot plot(canvas_, box, "Spectrogram", std::move(time),
            chart::frequency_axis("frequency, Hz", kLowestLevel_hz, levels.highest_hz, ticks), room);
  plot.image(levels.picture);
  plot.colour_bar(
      levels.picture.palette,
      chart::linear_axis("dB re a sine of full scale", levels.top_db - kLevelRange_db, levels.top_db, 5));
  plot.finish();
}

}  // namespace

void write_timeline(const std::filesystem::path& picture, const std::filesystem::path& sound,
                    const std::filesystem::path& states, const TimelineOptions& options,
                    const Progress& progress) {
  constexpr double kRead = 0.5;  // of the time, roughly; drawing is the rest
  require_apart({picture}, {sound, states});
  const session::StateTable table = session::read_states(states);
  const SoundFile heard = read_sound(sound, part_of(progress, 0, kRead));
  const Progress drawn = part_of(progress, kRead, 1);
  Drawing drawing(heard, table, options);
  if (drawn) drawn(0);
  drawing.draw(options.title.empty() ? sound.filename().string() : options.title);
  if (drawn) drawn(0.5);
  AtomicFile file(picture);
  drawing.write(file.temporary());
  file.commit();
}

}  // namespace rigsound::analysis
