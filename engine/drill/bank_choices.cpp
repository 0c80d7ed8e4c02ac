#include "drill/drill_input.hpp"

namespace rigsound::drill {

void BankChoices::add(const ClickBank& bank, double share) noexcept {
  if (share <= 0) return;
  for (int i = 0; i < count; ++i)
    if (choice[i].bank == &bank) {
      choice[i].share += share;
      return;
    }
  if (count < kMaxChoices) choice[count++] = {&bank, share};
}

const ClickBank& BankChoices::drawn(double uniform) const noexcept {
  int i = 0;
  for (; i + 1 < count && uniform >= choice[i].share; ++i) uniform -= choice[i].share;
  return *choice[i].bank;
}

}  // namespace rigsound::drill
