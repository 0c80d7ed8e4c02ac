#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart/plot.hpp"
#include "chart/svg_canvas.hpp"
#include "rigsound/analysis/string_figures.hpp"

namespace rigsound::analysis {
namespace {

using chart::Box, chart::Canvas, chart::Lettering, chart::Plot, chart::Role;

constexpr double kPageWidth = 900, kPageHeight = 900, kPageHead = 72, kPictureGap = 10;
constexpr Box kErrors{0, kPageHead, kPageWidth, 330}, kDecays{0, 330 + kPictureGap, kPageWidth, 610},
    kReflection{0, 610 + kPictureGap, kPageWidth, kPageHeight};

struct ModeFamily {
  const char* name;
  std::vector<StringMode> StringFigures::*modes;
  Role role;
  double dot;  ///< radius
};
constexpr ModeFamily kModeFamilies[] = {
    {"bending", &StringFigures::bending, Role::kFirst, 3.2},
    {"string", &StringFigures::string, Role::kThird, 2.6},
    {"rods without joints", &StringFigures::rods, Role::kOnset, 2},
};

chart::Axis frequency(std::string label) {
  return chart::frequency_axis(std::move(label), 4, 13000,
                               {5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000});
}

double worst_cents(const StringFigures& figures) {
  double worst = 0.1;
  for (const ModeFamily& family : kModeFamilies)
    for (const StringMode& mode : figures.*family.modes) worst = std::max(worst, std::fabs(mode.error_cents));
  return worst;
}

/// A line per wanted mode, a dot where the string has it.
void draw_errors(Canvas& canvas, const StringFigures& figures) {
  const double worst = worst_cents(figures), span = worst <= 1 ? 1 : std::ceil(worst);
  Plot plot(canvas, kErrors, "Error of each mode", frequency(""),
            chart::linear_axis("cents", -span, span, 4));
  for (const ModeFamily& family : kModeFamilies)
    for (const StringMode& mode : figures.*family.modes)
      plot.verticals({mode.target_hz}, {{family.role, 0.25}, 0.8});
  plot.horizontal(0, {Role::kGrey, 0.8});
  for (const ModeFamily& family : kModeFamilies)
    for (const StringMode& mode : figures.*family.modes)
      plot.dot(mode.model_hz, mode.error_cents, family.dot, family.role,
               fmt::format("{} {}: wanted {:.2f} Hz, reached {:.2f} Hz, {:+.3f} cents", family.name,
                           mode.mode, mode.target_hz, mode.model_hz, mode.error_cents));
  plot.legend("line: wanted, dot: reached", Role::kGrey);
  plot.finish();
}

/// Modes that are faded out towards the highest frequency fall through the bottom.
chart::Axis decay_axis(const StringFigures& figures) {
  constexpr double kShown = 0.25;  // of the shortest decay below the fade
  constexpr double kFadeFrom_hz = 9000;
  double shortest = 1e9, longest = 0;
  for (const auto* modes : {&figures.string, &figures.bending})
    for (const StringMode& mode : *modes)
      if (mode.model_hz < kFadeFrom_hz)
        shortest = std::min(shortest, mode.t60_pressed_s), longest = std::max(longest, mode.t60_s);
  return chart::log_axis("T60, s", kShown * shortest, 1.3 * longest);
}

void draw_decays(Canvas& canvas, const StringFigures& figures) {
  Plot plot(canvas, kDecays, "T60", frequency("frequency, Hz"), decay_axis(figures));
  for (const ModeFamily& family : {kModeFamilies[1], kModeFamilies[0]}) {
    std::vector<double> hz, free_s, pressed_s;
    for (const StringMode& mode : figures.*family.modes) {
      hz.push_back(mode.model_hz);
      free_s.push_back(mode.t60_s), pressed_s.push_back(mode.t60_pressed_s);
    }
    plot.band(hz, pressed_s, free_s, {family.role, 0.1});
    plot.line(hz, free_s, {family.role, 1.6});
    plot.line(hz, pressed_s, {family.role, 1.4, 4});
  }
  plot.legend("— free, as without feed", Role::kGrey);
  plot.legend("- - pressed on by full feed", Role::kGrey);
  plot.finish();
}

void draw_reflection(Canvas& canvas, std::string_view rock, const StringFigures& figures) {
  Plot plot(canvas, kReflection, fmt::format("Energy that the bit sends back, {}", rock),
            chart::log_axis("x = length of the pulse over the loading time of the rock, " +
                                fmt::format("{:.3g} ms", 1e3 * figures.loading_s),
                            0.05, 10),
            chart::linear_axis("share", 0, 1, 5));
  std::vector<double> x, r;
  for (double at = 0.05; at < 10; at *= 1.02) x.push_back(at), r.push_back(reflected_energy(at));
  plot.line(x, r, {Role::kFirst, 1.6});
  for (const ReflectionRow& row : figures.reflection)
    plot.dot(
        row.x, row.reached.energy, 2.6, Role::kFirst,
        fmt::format("pulse of {:.3f} ms, x = {:.2f}: wanted {:.4f}, reached {:.4f}; largest force {:.2f} "
                    "times the pulse's",
                    1e3 * row.pulse_s, row.x, row.target, row.reached.energy, row.reached.force));
  const double px = plot.px(figures.blow_x), py = plot.py(figures.blow.energy);
  canvas.stroke({{{px, plot.plane().bottom}, {px, py}, {plot.plane().left, py}}}, {Role::kThird, 1, 3});
  plot.dot(figures.blow_x, figures.blow.energy, 5, Role::kThird, "this string's blow");
  const bool has_room =
      px > plot.plane().left + plot.plane().width() / 3;  // under the curve, left of the blow
  canvas.text({has_room ? px - 9 : px + 9, has_room ? py + 18 : py - 10},
              fmt::format("this string's blow: {:.0f} % back, force × {:.2f}", 100 * figures.blow.energy,
                          figures.blow.force),
              {Role::kThird, 11, has_room ? Lettering::Anchor::kEnd : Lettering::Anchor::kStart,
               Lettering::Weight::kBold});
  plot.legend("line: closed form, dots: as played", Role::kGrey);
  plot.finish();
}

/// What the shape of the curve means at the rig.
void draw_reading(Canvas& canvas) {
  const double y = kReflection.bottom - 46;
  canvas.text({66, y}, "← bit in the air: all comes back, the string rings", {Role::kGrey});
  canvas.text({kPageWidth - 18, y}, "rigid wall: the hammer rebounds →",
              {Role::kGrey, 11, Lettering::Anchor::kEnd});
}

}  // namespace

std::string string_plot_svg(std::string_view title, std::string_view rock, const StringFigures& figures) {
  constexpr double kTitleSize = 16, kLegendSize = 12, kLine = 28, kLegendLine = 52;
  chart::SvgCanvas canvas(kPageWidth, kPageHeight);
  canvas.text({54, kLine}, std::string(title),
              {Role::kInk, kTitleSize, Lettering::Anchor::kStart, Lettering::Weight::kBold});
  std::vector<chart::Word> legend;
  for (const ModeFamily& family : kModeFamilies)
    legend.push_back({fmt::format("● {}: {}", family.name, (figures.*family.modes).size()), family.role});
  canvas.words({kPageWidth - 10, kLegendLine}, legend, kLegendSize);
  draw_errors(canvas, figures);
  draw_decays(canvas, figures);
  draw_reflection(canvas, rock, figures);
  draw_reading(canvas);
  return canvas.document(std::string(title));
}

}  // namespace rigsound::analysis
