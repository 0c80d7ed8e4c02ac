#include "rigsound/analysis/tool_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart/plot.hpp"
#include "chart/svg_canvas.hpp"

namespace rigsound::analysis {
namespace {

using chart::Plot, chart::Role;

constexpr double kPictureWidth = 900, kPictureHeight = 640, kPictureHead = 44, kMiddle = 330, kDot = 3.5;

struct Family {
  const char* name;
  Role role;
};
constexpr Family kFamilies[] = {{"transversal", Role::kFirst}, {"longitudinal", Role::kThird}};

Role role_of(const TunedMode& mode) {
  for (const Family& family : kFamilies)
    if (mode.family == family.name) return family.role;
  return Role::kInk;
}

chart::Axis frequency() {
  return chart::frequency_axis("frequency, Hz", 50, 20000,
                               {50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000});
}

/// A line per wanted mode, a dot where the loop has it.
void draw_tuning(chart::Canvas& canvas, const std::vector<TunedMode>& modes) {
  double worst = 0.1;
  for (const TunedMode& mode : modes) worst = std::max(worst, std::fabs(mode.error_cents));
  const double span = worst <= 1 ? 1 : std::ceil(worst);
  Plot plot(canvas, {0, kPictureHead, kPictureWidth, kMiddle}, "Error of each mode", frequency(),
            chart::linear_axis("cents", -span, span, 4));
  plot.horizontal(0, {Role::kGrey, 0.8});
  for (const TunedMode& mode : modes) plot.verticals({mode.target_hz}, {{role_of(mode), 0.4}});
  for (const TunedMode& mode : modes)
    plot.dot(mode.model_hz, mode.error_cents, kDot, role_of(mode),
             fmt::format("{} {}: wanted {:.2f} Hz, reached {:.2f} Hz, {:+.3f} cents", mode.family, mode.mode,
                         mode.target_hz, mode.model_hz, mode.error_cents));
  plot.legend("line: wanted, dot: reached", Role::kGrey);
  plot.finish();
}

/// Whole decades around what there is.
chart::Axis decay_axis(const std::vector<TunedMode>& modes, const std::vector<FittedBand>& recorded) {
  double shortest = 1e9, longest = 0;
  const auto hold = [&](double t60_s) {
    if (t60_s > 0 && std::isfinite(t60_s))
      shortest = std::min(shortest, t60_s), longest = std::max(longest, t60_s);
  };
  for (const TunedMode& mode : modes) hold(mode.t60_s);
  for (const FittedBand& band : recorded) hold(band.decay.low_s), hold(band.decay.high_s);
  const double low = std::floor(std::log10(shortest)),
               high = std::max(low + 1, std::ceil(std::log10(longest)));
  return chart::log_axis("T60, s", std::pow(10, low), std::pow(10, high));
}

/// A bar from bound to bound over each third octave; what has no upper bound fades out at the top.
void draw_bounds(Plot& plot, const std::vector<FittedBand>& recorded, double top_s) {
  constexpr double kHalfBand = 1.1225;  // a sixth of an octave
  bool open = false;
  for (const FittedBand& band : recorded) {
    if (band.decay.low_s <= 0) continue;
    open = open || !band.decay.told();
    const double high = band.decay.told() ? band.decay.high_s : top_s;
    plot.band({band.centre_hz / kHalfBand, band.centre_hz * kHalfBand}, {band.decay.low_s, band.decay.low_s},
              {high, high}, {Role::kOnset, band.decay.told() ? 0.45 : 0.15});
  }
  if (!recorded.empty()) plot.legend("■ recorded, 95 %", Role::kOnset);
  if (open) plot.legend("pale: at least", Role::kGrey);
}

void draw_decays(chart::Canvas& canvas, const std::vector<TunedMode>& modes,
                 const std::vector<FittedBand>& recorded) {
  const chart::Axis t60 = decay_axis(modes, recorded);
  Plot plot(canvas, {0, kMiddle + 10, kPictureWidth, kPictureHeight}, "T60 of the free tool", frequency(),
            t60);
  draw_bounds(plot, recorded, t60.high);
  for (const Family& family : kFamilies) {
    std::vector<double> hz, t60_s;
    for (const TunedMode& mode : modes)
      if (mode.family == family.name) hz.push_back(mode.model_hz), t60_s.push_back(mode.t60_s);
    plot.line(hz, t60_s, {family.role, 1.2});
  }
  for (const TunedMode& mode : modes)
    plot.dot(mode.model_hz, mode.t60_s, kDot, role_of(mode),
             fmt::format("{} {}: {:.4f} s at {:.1f} Hz", mode.family, mode.mode, mode.t60_s, mode.model_hz));
  plot.finish();
}

}  // namespace

std::string tool_plot_svg(std::string_view title, const std::vector<TunedMode>& modes,
                          const std::vector<FittedBand>& recorded) {
  constexpr double kTitleSize = 16, kLegendSize = 12, kLine = 28;
  chart::SvgCanvas canvas(kPictureWidth, kPictureHeight);
  canvas.text({54, kLine}, std::string(title),
              {Role::kInk, kTitleSize, chart::Lettering::Anchor::kStart, chart::Lettering::Weight::kBold});
  std::vector<chart::Word> legend;
  for (const Family& family : kFamilies) legend.push_back({std::string("● ") + family.name, family.role});
  canvas.words({kPictureWidth - 10, kLine}, legend, kLegendSize);
  draw_tuning(canvas, modes);
  draw_decays(canvas, modes, recorded);
  return canvas.document(std::string(title));
}

}  // namespace rigsound::analysis
