#include "rigsound/diesel_player.hpp"

#include "diesel/diesel_layer.hpp"

namespace rigsound {
namespace {

constexpr double kAlwaysRunning_rpm = 2;  // of idle: no speed is under half of it

}  // namespace

struct DieselPlayer::Parts {
  diesel::DieselLayer layer;
};

DieselPlayer::DieselPlayer(const DieselModel& model, double sample_rate, std::uint64_t seed)
    : parts_(new Parts{diesel::DieselLayer({model}, sample_rate, seed, kAlwaysRunning_rpm)}) {}
DieselPlayer::~DieselPlayer() = default;
DieselPlayer::DieselPlayer(DieselPlayer&&) noexcept = default;
DieselPlayer& DieselPlayer::operator=(DieselPlayer&&) noexcept = default;

void DieselPlayer::process(const DieselInput& input, double* out) noexcept {
  parts_->layer.process(input, out);
}

}  // namespace rigsound
