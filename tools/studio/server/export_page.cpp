#include <array>

#include "packed_rig.hpp"
#include "page_text.hpp"
#include "pages.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "studio.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostPieceBytes = 64 << 20;

std::string content(const fs::path& file, const char* kind) {
  std::error_code none;
  if (!fs::exists(file, none))
    throw InputError(file.string(), std::string("is not there, expected ") + kind +
                                        " (cmake --build build/release --target studio_web)");
  return InputFile(file, kind, kMostPieceBytes).content();
}

/// A script's text must not end the script.
std::string in_script(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
  return json;
}

}  // namespace

void export_page(const StudioOptions& options, const fs::path& file) {
  const Workplace place(options);
  const fs::path pages = find_pages(options.pages);
  std::string page = content(pages / "export.html", "the page to export");
  const std::array<std::pair<std::string, std::string>, 3> marks = {{
      {"RIGSOUND_RIG_JSON", in_script(config::json_line(rig_description(place)))},
      {"RIGSOUND_RIGSET", page_text(deflated(byte_planes(packed_sound_set(place, PackRig::kEmbedded))))},
      {"RIGSOUND_ENGINE", page_text(deflated(content(pages / "engine.wasm", "the engine for a page")))},
  }};
  for (const auto& [mark, text] : marks) {
    const std::size_t at = page.find(mark);
    if (at == std::string::npos) throw InputError((pages / "export.html").string(), "has no mark " + mark);
    page.replace(at, mark.size(), text);
  }
  write_file(file, page);
}

}  // namespace rigsound::studio
