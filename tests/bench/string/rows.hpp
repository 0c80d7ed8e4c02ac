// The groups of rows that string_bench prints.
#pragma once

namespace rigsound::bench {

/// Modes of strings and rods against physics, and the energy that the bit sends back.
void print_string_tuning();

/// Energy, residues and distances in rendered sound.
void print_string_sound();

/// Instructions a block of 64 frames, counted by callgrind; `program` is this program.
void print_string_cost(const char* program);

/// What callgrind counts: `chunks` chunks of each stage of the workload of that name. Returns false when
/// there is none.
bool run_string_workload(const char* name, int chunks);

}  // namespace rigsound::bench
