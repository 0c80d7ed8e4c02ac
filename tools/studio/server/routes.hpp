// One function a group of paths (API.md): adds them to the router. `place` outlives it. Thread: OFF.
#pragma once

#include "router.hpp"
#include "workplace.hpp"

namespace rigsound::studio {

void add_state_routes(Router& router, Workplace& place);
void add_recording_routes(Router& router, Workplace& place);
void add_label_routes(Router& router, Workplace& place);
void add_job_routes(Router& router, Workplace& place);
void add_sound_set_routes(Router& router, Workplace& place);
void add_bank_routes(Router& router, Workplace& place);
void add_live_routes(Router& router, Workplace& place);
void add_log_routes(Router& router, Workplace& place);
void add_diesel_routes(Router& router, Workplace& place);
void add_steel_routes(Router& router, Workplace& place);
void add_listening_routes(Router& router, Workplace& place);
void add_trial_routes(Router& router, Workplace& place);

}  // namespace rigsound::studio
