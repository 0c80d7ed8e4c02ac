#include "studio.hpp"

#include "pages.hpp"
#include "rigsound/machine/input_error.hpp"
#include "routes.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

void require_folder(const fs::path& folder, const char* kind) {
  std::error_code none;
  if (!fs::is_directory(folder, none))
    throw InputError(folder.string(), std::string("is no folder, expected one of ") + kind);
}

void check(const StudioOptions& options) {
  std::error_code none;
  if (fs::exists(options.sound_set, none) ||
      !fs::is_directory(fs::absolute(options.sound_set).parent_path(), none))
    require_folder(options.sound_set, "a sound set");
  if (!options.recordings.empty()) require_folder(options.recordings, "recordings");
}

}  // namespace

struct Studio::Parts {
  explicit Parts(const StudioOptions& options)
      : pages(find_pages(options.pages)),
        access(new_token()),
        place(options),
        server(options.port, access, [this](const Request& request) { return answer(request); }) {
    add_state_routes(router, place);
    add_recording_routes(router, place);
    add_label_routes(router, place);
    add_job_routes(router, place);
    add_sound_set_routes(router, place);
    add_bank_routes(router, place);
    add_live_routes(router, place);
    add_log_routes(router, place);
    add_diesel_routes(router, place);
    add_steel_routes(router, place);
    add_listening_routes(router, place);
    add_trial_routes(router, place);
  }

  Answer answer(const Request& request) {
    if (request.path.compare(0, 5, "/api/") == 0) return router.answer(request);
    try {
      return pages.answer(request);
    } catch (const ApiError& error) {
      return error_answer(error);
    } catch (const std::exception& error) {
      return error_answer({503, error.what()});
    }
  }

  Pages pages;
  Access access;
  Workplace place;
  Router router;
  HttpServer server;  // last: it calls the others
};

Studio::Studio(const StudioOptions& options) {
  check(options);
  parts_ = std::make_unique<Parts>(options);
}

Studio::~Studio() = default;

std::string Studio::address() const {
  return "http://127.0.0.1:" + std::to_string(parts_->server.port()) + "/#" + parts_->access.token();
}

void Studio::serve() { parts_->server.serve(); }

}  // namespace rigsound::studio
