// The groups of rows.
#pragma once

namespace rigsound::bench {

/// Modes of known bars, and the poles, orders and decays of 500 random ones.
void print_tuning();

/// What is measured in rendered sound: modes, sameness across rates, energy, residues of live changes.
void print_sound();

/// Nanoseconds a sample, and the ratio to Faust.
void print_cost();

}  // namespace rigsound::bench
