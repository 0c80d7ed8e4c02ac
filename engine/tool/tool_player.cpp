#include "rigsound/tool_player.hpp"

#include "tool/tool_layer.hpp"

namespace rigsound {

struct ToolPlayer::Parts {
  tool::ToolLayer layer;
};

ToolPlayer::ToolPlayer(const ToolModel& model, double sample_rate, std::uint64_t seed)
    : parts_(new Parts{tool::ToolLayer(model, sample_rate, seed, 0)}) {}
ToolPlayer::~ToolPlayer() = default;
ToolPlayer::ToolPlayer(ToolPlayer&&) noexcept = default;
ToolPlayer& ToolPlayer::operator=(ToolPlayer&&) noexcept = default;

void ToolPlayer::process(const Impacts& impacts, double* out) noexcept {
  parts_->layer.process(tool::ToolInput{}, impacts, out);
}

}  // namespace rigsound
